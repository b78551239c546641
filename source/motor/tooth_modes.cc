// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/surface_compliance.h>
#include <ringmotor/motor/smooth_loads.h>
#include <ringmotor/motor/tooth_modes.h>
#include <ringmotor/structure/response_modes.h>

#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  ContactDiscretisation tooth_modes_discretisation(const unsigned int level)
  {
    ContactDiscretisation discretisation;
    discretisation.degree          = 2 + level;
    discretisation.tooth           = {1, 1};
    discretisation.tooth.n_at_foot = 2;
    return discretisation;
  }

  RingMode mode_on_surface(const CyclicSector &sector, const ContactSurface &surface,
                           const std::vector<MirroredNode> &origin, const Mode &mode,
                           const ModePart part)
  {
    RingMode whole{std::sqrt(mode.eigenvalue),
                   sector_motion(on_surface(sector, displacement_forms(surface), mode), origin),
                   part};
    for (std::array<std::complex<double>, 3> &motion : whole.motion)
      for (std::complex<double> &component : motion)
        component *= std::sqrt(0.5); // two halves make a sector
    return whole;
  }

  std::vector<SurfaceWeights> weights_on(const ContactSurface &surface,
                                         const ContactSurface &tooth_top,
                                         const MortarCoupling &mortar)
  {
    std::vector<SurfaceWeights> weights;
    for (const MortarCoupling::Node &node : mortar.nodes)
      weights.push_back(interpolation(surface, tooth_top.nodes[node.tooth_node].place));
    return weights;
  }

  std::vector<RingMode> tooth_modes(const Parameters &parameters, const unsigned int level,
                                    const double up_to, const ContactSurface &tooth_top,
                                    const MortarCoupling &mortar)
  {
    const ToothBody tooth(parameters, tooth_modes_discretisation(level), /*is_clamped =*/true);
    // All harmonics act on the same tooth, so its responses have to be right everywhere, and its
    // lowest modes, next to the first harmonics, as accurate as a small loss factor is.
    std::vector<double> frequencies;
    for (const double share : {0.1, 0.2, 0.4, 0.7, 1.})
      frequencies.push_back(share * up_to);
    const auto loads = smooth_loads(tooth.sector, tooth.top, 0, {1, 2});

    const std::vector<SurfaceWeights> weights =
        weights_on(tooth.whole_top.surface, tooth_top, mortar);
    std::vector<RingMode> modes;
    for (const Mode &mode :
         without_fast_vectors(ResponseModes(tooth.sector).at(0, loads, frequencies), up_to))
      modes.push_back(interpolated(
          mode_on_surface(tooth.sector, tooth.top, tooth.whole_top.origin, mode, ModePart::tooth),
          weights));
    return modes;
  }
} // namespace ringmotor
