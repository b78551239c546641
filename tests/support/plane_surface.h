// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_surface.h>

#include <deal.II/fe/fe_q.h>

#include <cmath>
#include <vector>

namespace ringmotor::tests
{
  /** The faces between these radii (m) and angles (rad), without displacement forms. */
  inline ContactSurface plane_surface(const std::vector<double> &radii,
                                      const std::vector<double> &angles, const unsigned int degree)
  {
    using dealii::Point;
    const dealii::FE_Q<2> element(degree);
    const unsigned int n_r = degree * (radii.size() - 1) + 1,
                       n_t = degree * (angles.size() - 1) + 1;
    ContactSurface surface;
    surface.degree = degree;
    surface.nodes.resize(n_r * n_t);
    for (unsigned int i = 0; i + 1 < radii.size(); ++i)
      for (unsigned int j = 0; j + 1 < angles.size(); ++j)
      {
        const auto at = [&](const double u, const double v)
        {
          return Point<2>(radii[i] + u * (radii[i + 1] - radii[i]),
                          angles[j] + v * (angles[j + 1] - angles[j]));
        };
        surface.corners.push_back({{at(0., 0.), at(1., 0.), at(0., 1.), at(1., 1.)}});
        std::vector<unsigned int> face;
        for (const Point<2> &unit : element.get_unit_support_points())
        {
          const auto a = static_cast<unsigned int>(std::lround(degree * (i + unit[0]))),
                     b = static_cast<unsigned int>(std::lround(degree * (j + unit[1])));
          face.push_back(a * n_t + b);
          surface.nodes[face.back()].place = at(unit[0], unit[1]);
        }
        surface.faces.push_back(face);
      }
    return surface;
  }
} // namespace ringmotor::tests
