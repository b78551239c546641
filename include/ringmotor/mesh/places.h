// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <cmath>
#include <utility>

namespace ringmotor
{
  /**
   * When two places in a mesh are the same. Meshes in memory, generated or read, are exact: what is
   * meant to be one plane, radius or point differs by rounding errors only. The coordinates of a
   * file may be off by more, but read_sector() moves its nodes to where they are meant to be, so
   * that nobody behind it has to allow for that.
   */
  namespace places
  {
    constexpr double rounding = 1e-9; ///< relative to the size of what is compared
    /** Of the largest radius, what a file's nodes may be off: eight digits, or numbers in single
     * precision, are enough. read_sector() alone uses it. */
    constexpr double file_rounding = 1e-6;
  } // namespace places

  /** Whether two coordinates of places in a mesh of this @p size are the same. */
  inline bool is_same_place(const double a, const double b, const double size)
  {
    return std::abs(a - b) <= places::rounding * size;
  }

  /** (r, theta, z) with theta in (-pi, pi]. */
  inline dealii::Point<3> cylindrical(const dealii::Point<3> &x)
  {
    return dealii::Point<3>(std::hypot(x[0], x[1]), std::atan2(x[1], x[0]), x[2]);
  }

  /** The inverse of cylindrical(). */
  inline dealii::Point<3> cartesian(const dealii::Point<3> &place)
  {
    return dealii::Point<3>(place[0] * std::cos(place[1]), place[0] * std::sin(place[1]), place[2]);
  }

  /** The mean of (r, theta, z) of a face's corners; where its edges are arcs, as far out as their
   * ends. */
  template <typename Face>
  dealii::Point<3> mean_place_of_corners(const Face &face)
  {
    dealii::Point<3> mean;
    for (unsigned int i = 0; i < 4; ++i)
      mean += 0.25 * cylindrical(face->vertex(i));
    return mean;
  }

  /** Smallest and largest distance of a mesh's vertices from the axis. */
  std::pair<double, double> range_of_radii(const dealii::Triangulation<3> &triangulation);
} // namespace ringmotor
