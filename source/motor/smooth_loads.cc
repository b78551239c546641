// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/places.h>
#include <ringmotor/motor/smooth_loads.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    struct Extent
    {
      double inner = std::numeric_limits<double>::max(), outer = 0., end = 0.;

      explicit Extent(const ContactSurface &surface)
      {
        for (const SurfaceNode &node : surface.nodes)
        {
          inner = std::min(inner, node.place[0]);
          outer = std::max(outer, node.place[0]);
          end   = std::max(end, node.place[1]);
        }
      }
      /** Of the width, from the inner end. */
      double across(const SurfaceNode &node) const
      {
        return (node.place[0] - inner) / (outer - inner);
      }
    };
  } // namespace

  std::vector<LinearForm> smooth_loads_in_section(const ContactSurface &surface,
                                                  const unsigned int degree)
  {
    const Extent extent(surface);
    std::vector<LinearForm> loads;
    for (const unsigned int component : {0u, 1u, 2u})
      for (unsigned int i = 0; i <= degree; ++i)
      {
        loads.emplace_back();
        for (const SurfaceNode &node : surface.nodes)
          if (is_same_place(node.place[1], 0., extent.end))
            for (const auto &[dof, coefficient] : node.displacement[component])
              loads.back().emplace_back(dof, std::pow(extent.across(node), i) * coefficient);
      }
    return loads;
  }

  std::vector<std::vector<double>> smooth_loads(const CyclicSector &sector,
                                                const ContactSurface &surface, const unsigned int k,
                                                const LoadDegrees &degrees)
  {
    const Extent extent(surface);
    std::vector<std::vector<double>> loads;
    for (const unsigned int component : {0u, 1u, 2u})
      for (unsigned int i = 0; i <= degrees.across; ++i)
        for (unsigned int j = 0; j <= degrees.around; ++j)
        {
          // S reverses the component along -theta: even there means imaginary.
          const unsigned int part = (component == 1 ? j + 1 : j) % 2;
          std::array<Vector<double>, 2> forces{
              {Vector<double>(sector.n_dofs()), Vector<double>(sector.n_dofs())}};
          for (const SurfaceNode &node : surface.nodes)
          {
            const double around = node.place[1] / extent.end,
                         force  = std::pow(extent.across(node), i) * std::pow(around, j) *
                                 (degrees.vanish_at_cut ? 1. - around * around : 1.);
            for (const auto &[dof, coefficient] : node.displacement[component])
              forces[part][dof] += force * coefficient;
          }
          loads.push_back(sector.loads_of(k, forces));
        }
    return loads;
  }
} // namespace ringmotor
