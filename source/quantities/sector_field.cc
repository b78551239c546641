// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/quantities/sector_field.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/fe_values_extractors.h>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The lattice of (order + 1)^3 points on the unit cell, first index fastest. */
    Quadrature<3> lattice(const unsigned int order)
    {
      std::vector<Point<3>> points;
      for (unsigned int k = 0; k <= order; ++k)
        for (unsigned int j = 0; j <= order; ++j)
          for (unsigned int i = 0; i <= order; ++i)
            points.emplace_back(static_cast<double>(i) / order, static_cast<double>(j) / order,
                                static_cast<double>(k) / order);
      return Quadrature<3>(points);
    }

    /** The mirror image at theta -> -theta, with U(-theta) = S conj(U(theta)). */
    SectorField::Cell mirrored(const SectorField::Cell &cell, const unsigned int order)
    {
      SectorField::Cell image = cell;
      for (unsigned int point = 0; point < cell.points.size(); ++point)
      {
        // The mirror turns a right-handed lattice into a left-handed one: count its first index
        // backwards.
        const unsigned int i      = point % (order + 1);
        const unsigned int source = point - i + (order - i);
        image.points[point]       = cell.points[source];
        image.points[point][1] *= -1.;
        for (unsigned int d = 0; d < 3; ++d)
          image.displacement[point][d] =
              (d == 1 ? -1. : 1.) * std::conj(cell.displacement[source][d]);
      }
      return image;
    }
  } // namespace

  SectorField sample_sector(const CyclicSector &sector, const Mode &mode, const unsigned int order)
  {
    const SectorMesh &mesh = sector.sector_mesh();
    SectorField field;
    field.order             = order;
    field.n_sectors         = mesh.n_sectors;
    field.nodal_diameter    = mode.nodal_diameter;
    field.angular_frequency = 2. * numbers::PI * mode.frequency();

    const Quadrature<3> points = lattice(order);
    FEValues<3> values(sector.geometry(), sector.dofs().get_fe(), points,
                       update_values | update_quadrature_points);
    const FEValuesExtractors::Vector displacement(0);
    std::vector<Tensor<1, 3>> real(points.size()), imaginary(points.size());
    for (const auto &cell : sector.dofs().active_cell_iterators())
    {
      values.reinit(cell);
      values[displacement].get_function_values(mode.displacement.real, real);
      values[displacement].get_function_values(mode.displacement.imaginary, imaginary);
      SectorField::Cell sampled;
      sampled.material = cell->material_id();
      sampled.points   = values.get_quadrature_points();
      for (unsigned int q = 0; q < points.size(); ++q)
        sampled.displacement.push_back({{{real[q][0], imaginary[q][0]},
                                         {real[q][1], imaginary[q][1]},
                                         {real[q][2], imaginary[q][2]}}});
      field.cells.push_back(sampled);
      if (mesh.form == SectorForm::half)
        field.cells.push_back(mirrored(sampled, order));
    }
    return field;
  }
} // namespace ringmotor
