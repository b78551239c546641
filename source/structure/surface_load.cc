// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/surface_load.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    void sum_over_ranks(ComplexField &field, MPI_Comm communicator)
    {
      Utilities::MPI::sum(field.real, communicator, field.real);
      Utilities::MPI::sum(field.imaginary, communicator, field.imaginary);
    }

    void add(ComplexField &forces, const SectorNodes::Dof dof, const Complex force)
    {
      forces.real[dof] += force.real();
      forces.imaginary[dof] += force.imag();
    }
  } // namespace

  SectorMotion face_load(const SectorElements &sector, const types::boundary_id faces,
                         const Traction &traction)
  {
    SectorMotion forces = sector.at_rest();
    if (!sector.dofs().has_active_dofs())
      return forces;
    const FiniteElement<3> &fe = sector.dofs().get_fe();
    FEFaceValues<3> values(sector.geometry(), fe, QGauss<2>(fe.degree + 2),
                           update_values | update_quadrature_points | update_JxW_values);
    std::vector<SectorNodes::Dof> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : sector.dofs().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int face : cell->face_indices())
          if (cell->at_boundary(face) && cell->face(face)->boundary_id() == faces)
          {
            values.reinit(cell, face);
            cell->get_dof_indices(dofs);
            for (const unsigned int q : values.quadrature_point_indices())
            {
              const std::array<Complex, 3> t = traction(values.quadrature_point(q));
              for (unsigned int i = 0; i < dofs.size(); ++i)
                add(forces.solid, dofs[i],
                    values.JxW(q) * values.shape_value(i, q) *
                        t[fe.system_to_component_index(i).first]);
            }
          }
    sum_over_ranks(forces.solid, sector.communicator());
    return forces;
  }

  SectorMotion lower_face_load(const SectorElements &sector, const types::material_id cells,
                               const Traction &traction)
  {
    SectorMotion forces = sector.at_rest();
    if (!sector.shell_dofs().has_active_dofs())
      return forces;
    const FiniteElement<2, 3> &fe = sector.shell_dofs().get_fe();
    FEValues<2, 3> values(sector.shell_geometry(), fe, QGauss<2>(fe.degree + 2),
                          update_values | update_quadrature_points | update_normal_vectors |
                              update_JxW_values);
    std::vector<SectorNodes::Dof> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : sector.shell_dofs().active_cell_iterators())
      if (cell->is_locally_owned() && cell->material_id() == cells)
      {
        values.reinit(cell);
        cell->get_dof_indices(dofs);
        const double height = sector.sector_mesh().sections.at(cells).lower_face();
        for (const unsigned int q : values.quadrature_point_indices())
        {
          // The area of the reference surface, which equals that of the face as these shells are
          // flat.
          const Tensor<1, 3> arm         = height * values.normal_vector(q);
          const std::array<Complex, 3> t = traction(values.quadrature_point(q) + arm);
          for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const unsigned int component = fe.system_to_component_index(i).first;
            const unsigned int d = component % 3, e = (d + 1) % 3, f = (d + 2) % 3;
            add(forces.shell, dofs[i],
                values.JxW(q) * values.shape_value(i, q) *
                    (component < 3 ? t[d] : arm[e] * t[f] - arm[f] * t[e]));
          }
        }
      }
    sum_over_ranks(forces.shell, sector.communicator());
    return forces;
  }
} // namespace ringmotor
