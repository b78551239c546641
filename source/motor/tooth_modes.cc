// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/stator_sector.h>
#include <ringmotor/motor/tooth_modes.h>
#include <ringmotor/structure/modes.h>

#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  std::vector<RingMode> tooth_modes(const Parameters &parameters,
                                    const ContactDiscretisation &discretisation,
                                    const MortarCoupling &mortar, const double up_to)
  {
    const ToothBody tooth(parameters, discretisation, /*is_clamped =*/true);
    const std::vector<LinearForm> displacements = displacement_forms(tooth.top);
    std::vector<RingMode> modes;
    for (const Mode &mode : ModeSolver(tooth.sector).below(0, std::pow(up_to, 2)))
    {
      const auto top =
          sector_motion(on_surface(tooth.sector, displacements, mode), tooth.whole_top.origin);
      RingMode at_points{std::sqrt(mode.eigenvalue), {}, /*of_tooth =*/true};
      for (const MortarCoupling::Node &node : mortar.nodes)
      {
        at_points.motion.push_back(top[node.tooth_node]);
        for (std::complex<double> &component : at_points.motion.back())
          component *= std::sqrt(0.5); // two halves make a tooth
      }
      modes.push_back(std::move(at_points));
    }
    return modes;
  }
} // namespace ringmotor
