// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <functional>
#include <map>

namespace ringmotor::tests
{
  /** The integral of a smooth function, by 20 Gauss points. */
  inline double integral(const std::function<double(double)> &function, const double from,
                         const double to)
  {
    const dealii::QGauss<1> points(20);
    double sum = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
      sum += points.weight(q) * (to - from) * function(from + (to - from) * points.point(q)[0]);
    return sum;
  }

  /** Volumes in m^3 by material, of cells curved with this degree. */
  inline std::map<dealii::types::material_id, double>
  volumes(const dealii::Triangulation<3> &triangulation, const unsigned int mapping_degree)
  {
    using namespace dealii;
    const MappingQ<3> mapping(mapping_degree);
    const FE_Nothing<3> nothing;
    FEValues<3> values(mapping, nothing, QGauss<3>(mapping_degree + 2), update_JxW_values);
    std::map<types::material_id, double> sums;
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      values.reinit(cell);
      for (const double volume : values.get_JxW_values())
        sums[cell->material_id()] += volume;
    }
    return sums;
  }

  /** Areas in m^2 by boundary id, of cells curved with this degree. */
  inline std::map<dealii::types::boundary_id, double>
  boundary_areas(const dealii::Triangulation<3> &triangulation, const unsigned int mapping_degree)
  {
    using namespace dealii;
    const MappingQ<3> mapping(mapping_degree);
    const FE_Nothing<3> nothing;
    FEFaceValues<3> values(mapping, nothing, QGauss<2>(mapping_degree + 2), update_JxW_values);
    std::map<types::boundary_id, double> sums;
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int face : cell->face_indices())
        if (cell->at_boundary(face))
        {
          values.reinit(cell, face);
          for (const double area : values.get_JxW_values())
            sums[cell->face(face)->boundary_id()] += area;
        }
    return sums;
  }

  /** The smallest ratio of minimum to maximum Jacobian determinant within a cell, corners included.
   */
  inline double smallest_jacobian_ratio(const dealii::Triangulation<3> &triangulation)
  {
    using namespace dealii;
    const MappingQ<3> mapping(2);
    const FE_Nothing<3> nothing;
    FEValues<3> values(mapping, nothing, QGaussLobatto<3>(4), update_jacobians);
    double worst = 1.;
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      values.reinit(cell);
      double least = std::numeric_limits<double>::max(), most = 0.;
      for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
      {
        least = std::min(least, values.jacobian(q).determinant());
        most  = std::max(most, values.jacobian(q).determinant());
      }
      worst = std::min(worst, least / most);
    }
    return worst;
  }
} // namespace ringmotor::tests
