// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/elements/bar.h>
#include <ringmotor/elements/foundation.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/motor/body_parts.h>
#include <ringmotor/structure/motion_products.h>
#include <ringmotor/wave/frequency_shift.h>

#include <deal.II/base/mpi.h>

#include <set>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Twice the energies of a mode in what is added, over the meshed part of a sector. */
    struct Products
    {
      double stiffness = 0., mass = 0.;
    };

    /** The real and the imaginary field of a mode in some degrees of freedom of a cell. */
    std::vector<Vector<double>> values_of(const Mode &mode,
                                          const std::vector<types::global_dof_index> &dofs)
    {
      const ComplexField &motion = mode.motion.solid;
      std::vector<Vector<double>> values(2, Vector<double>(dofs.size()));
      for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        values[0][i] = motion.real[dofs[i]];
        values[1][i] = motion.imaginary[dofs[i]];
      }
      return values;
    }

    Products of_plates(const CyclicSector &sector, const Mode &mode, const BarSection &plates)
    {
      BarElement bar(sector.geometry(), sector.dofs().get_fe());
      std::set<unsigned int> done; // edges are counted in their first cell
      Products products;
      for (const auto &cell : sector.dofs().active_cell_iterators())
        for (const unsigned int line : cell->line_indices())
          if (cell->line(line)->boundary_id() == ids::target_plate &&
              done.insert(cell->line_index(line)).second && cell->is_locally_owned())
          {
            bar.reinit(cell, line, plates);
            const auto cell_dofs = sector.dofs_of(cell);
            std::vector<types::global_dof_index> own;
            for (const unsigned int dof : bar.local_dofs())
              own.push_back(cell_dofs[dof]);
            const std::vector<Vector<double>> values = values_of(mode, own);
            for (const double product : bar.stiffness_products(values))
              products.stiffness += product;
            for (const double product : bar.mass_products(values))
              products.mass += product;
          }
      return products;
    }

    Products of_felt(const CyclicSector &sector, const Mode &mode, const double stiffness)
    {
      FoundationElement felt(sector.geometry(), sector.dofs().get_fe());
      Products products;
      for (const auto &cell : sector.dofs().active_cell_iterators())
        for (const unsigned int face : cell->face_indices())
          if (cell->is_locally_owned() && is_on_felt(cell->face(face)->boundary_id()))
          {
            felt.reinit(cell, face, stiffness);
            const auto dofs = sector.dofs_of(cell);
            for (const double product :
                 felt.stiffness_products(values_of(mode, {dofs.begin(), dofs.end()})))
              products.stiffness += product;
          }
      return products;
    }
  } // namespace

  double frequency_shift(const CyclicSector &sector, const Mode &mode, const MotorModel &model)
  {
    Products products;
    for (const Products &part :
         {model.target_plates ? of_plates(sector, mode, *model.target_plates) : Products(),
          model.felt_stiffness > 0. ? of_felt(sector, mode, model.felt_stiffness) : Products()})
    {
      products.stiffness += Utilities::MPI::sum(part.stiffness, sector.communicator());
      products.mass += Utilities::MPI::sum(part.mass, sector.communicator());
    }
    return 0.5 * (products.stiffness / mode.eigenvalue - products.mass) /
           motion_products(sector, {&mode.motion}).front().mass;
  }
} // namespace ringmotor
