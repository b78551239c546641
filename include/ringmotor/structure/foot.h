// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/geometry_info.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>

#include <optional>
#include <vector>

namespace ringmotor
{
  /** A point of a mesh in the coordinates of one of its cells. */
  template <int dim>
  struct Foot
  {
    typename dealii::DoFHandler<dim, 3>::active_cell_iterator cell;
    dealii::Point<dim> unit;
    double distance; ///< m
  };

  /** The point nearest to @p x in these cells, if it is within @p reach. */
  template <int dim>
  std::optional<Foot<dim>>
  foot_of(const dealii::Point<3> &x,
          const std::vector<typename dealii::DoFHandler<dim, 3>::active_cell_iterator> &cells,
          const dealii::Mapping<dim, 3> &mapping, const double reach)
  {
    std::optional<Foot<dim>> best;
    for (const auto &cell : cells)
      if (cell->center().distance(x) < cell->diameter() + reach)
        try
        {
          const dealii::Point<dim> unit = dealii::GeometryInfo<dim>::project_to_unit_cell(
              mapping.transform_real_to_unit_cell(cell, x));
          const double distance = mapping.transform_unit_to_real_cell(cell, unit).distance(x);
          if (distance < (best ? best->distance : reach))
            best = Foot<dim>{cell, unit, distance};
        }
        catch (const typename dealii::Mapping<dim, 3>::ExcTransformationFailed &)
        {
          // far from this cell
        }
    return best;
  }
} // namespace ringmotor
