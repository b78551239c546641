// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/quantities/effects.h>
#include <ringmotor/structure/motion_products.h>

#include <deal.II/base/mpi.h>

#include <set>

namespace ringmotor
{
  using namespace dealii;

  BarSection target_plates(const Parameters &parameters)
  {
    const Material &metal = parameters.materials.target_plate;
    const double area     = parameters.stator.target_plate_area;
    return {area * metal.young_modulus, area * metal.density};
  }

  double target_plate_shift(const CyclicSector &sector, const Mode &mode, const BarSection &plates)
  {
    BarElement bar(sector.geometry(), sector.dofs().get_fe());
    std::vector<Vector<double>> values(2);
    std::set<unsigned int> done; // edges belong to the first of their cells
    double stiffness = 0., mass = 0.;
    for (const auto &cell : sector.dofs().active_cell_iterators())
      for (const unsigned int line : cell->line_indices())
        if (cell->line(line)->boundary_id() == ids::target_plate &&
            done.insert(cell->line_index(line)).second && cell->is_locally_owned())
        {
          bar.reinit(cell, line, plates);
          const auto cell_dofs                 = sector.dofs_of(cell);
          const std::vector<unsigned int> &own = bar.local_dofs();
          for (unsigned int part = 0; part < 2; ++part)
          {
            const ComplexField &motion = mode.motion.solid;
            values[part].reinit(own.size());
            for (unsigned int i = 0; i < own.size(); ++i)
              values[part][i] = (part == 0 ? motion.real : motion.imaginary)[cell_dofs[own[i]]];
          }
          for (const double product : bar.stiffness_products(values))
            stiffness += product;
          for (const double product : bar.mass_products(values))
            mass += product;
        }
    stiffness = Utilities::MPI::sum(stiffness, sector.communicator());
    mass      = Utilities::MPI::sum(mass, sector.communicator());
    return 0.5 * (stiffness / mode.eigenvalue - mass) /
           motion_products(sector, {&mode.motion}).front().mass;
  }
} // namespace ringmotor
