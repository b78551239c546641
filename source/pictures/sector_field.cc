// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/elements/shell.h>
#include <ringmotor/elements/solid.h>
#include <ringmotor/pictures/lattice.h>
#include <ringmotor/pictures/sector_field.h>
#include <ringmotor/structure/mirror.h>
#include <ringmotor/structure/shell_trace.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/fe_values_extractors.h>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    SectorField::Cell image_of(const SectorField::Cell &cell, const unsigned int order)
    {
      SectorField::Cell image = cell;
      for (unsigned int point = 0; point < cell.points.size(); ++point)
      {
        // The mirror turns a right-handed lattice into a left-handed one: count its first index
        // backwards.
        const unsigned int i       = point % (order + 1);
        const unsigned int source  = point - i + (order - i);
        image.points[point]        = mirrored(cell.points[source]);
        image.strain_energy[point] = cell.strain_energy[source];
        image.displacement[point]  = mirrored(cell.displacement[source]);
        if (!cell.potential.empty())
          image.potential[point] = std::conj(cell.potential[source]);
      }
      return image;
    }

    /** Adds a cell and, for a half sector, its mirror image. */
    void add(const SectorField::Cell &cell, const SectorForm form, SectorField &field)
    {
      field.cells.push_back(cell);
      if (form == SectorForm::half)
        field.cells.push_back(image_of(cell, field.order));
    }

    std::vector<std::complex<double>> potential_at(const Quadrature<3> &points,
                                                   const CyclicSector &sector,
                                                   const SectorElements::Cell &cell,
                                                   const ComplexField &potential)
    {
      const FiniteElement<3> &scalar           = sector.dofs().get_fe().base_element(0);
      const std::vector<SectorNodes::Dof> dofs = sector.potential_dofs_of(cell);
      std::vector<std::complex<double>> values(points.size());
      for (unsigned int q = 0; q < points.size(); ++q)
        for (unsigned int i = 0; i < dofs.size(); ++i)
        {
          const unsigned int number = dofs[i] - sector.nodes().first_potential_dof();
          values[q] += scalar.shape_value(i, points.point(q)) *
                       std::complex<double>(potential.real[number], potential.imaginary[number]);
        }
      return values;
    }

    void add_solids(const CyclicSector &sector, const Mode &mode, SectorField &field)
    {
      const Quadrature<3> points = lattice<3>(field.order);
      FEValues<3> values(sector.geometry(), sector.dofs().get_fe(), points,
                         update_values | update_gradients | update_quadrature_points);
      const FEValuesExtractors::Vector displacement(0);
      std::vector<Tensor<1, 3>> real(points.size()), imaginary(points.size());
      std::vector<Tensor<2, 3>> real_slope(points.size()), imaginary_slope(points.size());
      for (const auto &cell : sector.dofs().active_cell_iterators())
      {
        values.reinit(cell);
        values[displacement].get_function_values(mode.motion.solid.real, real);
        values[displacement].get_function_values(mode.motion.solid.imaginary, imaginary);
        values[displacement].get_function_gradients(mode.motion.solid.real, real_slope);
        values[displacement].get_function_gradients(mode.motion.solid.imaginary, imaginary_slope);
        const Material &material = sector.material_table().at(cell->material_id());
        SectorField::Cell sampled;
        sampled.material = cell->material_id();
        sampled.points   = values.get_quadrature_points();
        if (sector.has_potential(cell))
          sampled.potential = potential_at(points, sector, cell, mode.motion.potential);
        for (unsigned int q = 0; q < points.size(); ++q)
        {
          sampled.displacement.push_back({{{real[q][0], imaginary[q][0]},
                                           {real[q][1], imaginary[q][1]},
                                           {real[q][2], imaginary[q][2]}}});
          // The mean of Re(U exp(i omega t))^2 is |U|^2 / 2.
          sampled.strain_energy.push_back(0.5 *
                                          (strain_energy_density(material, real_slope[q]) +
                                           strain_energy_density(material, imaginary_slope[q])));
        }
        add(sampled, sector.sector_mesh().form, field);
      }
    }

    /** Strain energy per volume (J/m^3, mean over a period) of a shell's cell. */
    double mean_strain_energy(const CyclicSector &sector, const SectorElements::ShellCell &cell,
                              const ComplexField &motion, ShellElement &element)
    {
      const Material &material = sector.material_table().at(cell->material_id());
      const auto &fe           = sector.shell_dofs().get_fe();
      std::vector<Vector<double>> fields(2, Vector<double>(fe.n_dofs_per_cell()));
      cell->get_dof_values(motion.real, fields[0]);
      cell->get_dof_values(motion.imaginary, fields[1]);
      Vector<double> shift(fe.n_dofs_per_cell());
      for (unsigned int i = 0; i < shift.size(); ++i)
        shift[i] = fe.system_to_component_index(i).first == 0;
      element.reinit(cell, material, sector.sector_mesh().sections.at(cell->material_id()));
      const double volume = element.mass_products({shift}).front() / material.density;
      const std::vector<double> twice_energies = element.stiffness_products(fields);
      return 0.25 * (twice_energies[0] + twice_energies[1]) / volume;
    }

    /** The cells of shells with their thickness, as bodies. */
    void add_shells(const CyclicSector &sector, const Mode &mode, SectorField &field)
    {
      ShellTrace trace(sector, lattice<2>(field.order));
      ShellElement element(sector.shell_geometry(), sector.shell_dofs().get_fe());
      for (const auto &cell : sector.shell_dofs().active_cell_iterators())
      {
        trace.reinit(cell, mode.motion.shell);
        const ShellSection &section = sector.sector_mesh().sections.at(cell->material_id());
        SectorField::Cell sampled;
        sampled.material    = cell->material_id();
        const double energy = mean_strain_energy(sector, cell, mode.motion.shell, element);
        for (unsigned int layer = 0; layer <= field.order; ++layer)
          for (unsigned int q = 0; q < trace.size(); ++q)
          {
            const double height = section.lower_face() + section.thickness * layer / field.order;
            sampled.points.push_back(trace.position(q, height));
            sampled.displacement.push_back(trace.displacement(q, height));
            sampled.strain_energy.push_back(energy);
          }
        add(sampled, sector.sector_mesh().form, field);
      }
    }
  } // namespace

  SectorField sample_sector(const CyclicSector &sector, const Mode &mode, const unsigned int order)
  {
    SectorField field;
    field.order             = order;
    field.n_sectors         = sector.sector_mesh().n_sectors;
    field.nodal_diameter    = mode.nodal_diameter;
    field.angular_frequency = 2. * numbers::PI * mode.frequency();
    if (sector.dofs().has_active_dofs())
      add_solids(sector, mode, field);
    if (sector.shell_dofs().has_active_dofs())
      add_shells(sector, mode, field);
    return field;
  }
} // namespace ringmotor
