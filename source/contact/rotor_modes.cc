// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/rotor_modes.h>
#include <ringmotor/structure/modes.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /** The displacements of a mode on a surface, real field, then imaginary one. */
    std::vector<double> on_surface(const CyclicSector &sector,
                                   const std::vector<LinearForm> &displacements, const Mode &mode)
    {
      std::vector<double> values;
      for (const Vector<double> &field : sector.in_axes(mode.motion))
        for (const LinearForm &form : displacements)
        {
          values.push_back(0.);
          for (const auto &[dof, coefficient] : form)
            values.back() += coefficient * field[dof];
        }
      return values;
    }

    /** Nodal diameters that the harmonics of the wave have. */
    std::set<unsigned int> nodal_diameters(const Motor &motor, const bool is_warped,
                                           const double modes_up_to)
    {
      std::set<unsigned int> diameters;
      const auto n_harmonics = static_cast<unsigned int>(2. * modes_up_to);
      for (unsigned int m = 1; m <= (is_warped ? motor.n_teeth : n_harmonics); ++m)
      {
        const unsigned int around = (is_warped ? m : m * motor.n_waves) % motor.n_teeth;
        diameters.insert(std::min(around, motor.n_teeth - around));
      }
      diameters.erase(0);
      diameters.erase(1);
      return diameters;
    }
  } // namespace

  std::vector<std::array<Complex, 3>> at_contact_points(const std::vector<double> &half,
                                                        const std::vector<MirroredNode> &origin,
                                                        const MortarCoupling &mortar,
                                                        const double turn)
  {
    const std::vector<std::array<Complex, 3>> rotor = sector_motion(half, origin);
    std::vector<std::array<Complex, 3>> motions;
    for (const MortarCoupling::Node &node : mortar.nodes)
    {
      std::array<Complex, 3> motion{};
      for (const MortarCoupling::Weight &weight : node.weights)
        for (unsigned int c = 0; c < 3; ++c)
          motion[c] += weight.weight * std::polar(1., -weight.sector * turn) *
                       rotor[weight.rotor_node][c];
      motions.push_back(motion);
    }
    return motions;
  }

  RingModes rotor_modes(const Parameters &parameters, const ContactSurface &tooth_top,
                        const StatorWave &wave, const ContactDiscretisation &discretisation)
  {
    const unsigned int n_teeth = parameters.motor.n_teeth;
    const double pitch         = 2. * numbers::PI / n_teeth;
    const RotorBody body(parameters, discretisation.for_modes());
    const MortarCoupling mortar =
        couple(tooth_top, body.whole_lip.surface, pitch, discretisation.lip_turn);
    const std::vector<LinearForm> displacements = displacement_forms(body.lip);
    const bool gives_way_along =
        parameters.effects.rotor_tangential_compliance != EffectChoice::off;

    ModeSolver solver(body.sector);
    RingModes modes(n_teeth / 2 + 1);
    for (const unsigned int k :
         nodal_diameters(parameters.motor, is_warped(parameters), discretisation.modes_up_to))
      for (const Mode &mode :
           solver.below(k, std::pow(discretisation.modes_up_to * wave.angular_frequency, 2)))
      {
        RingMode ring_mode{
            std::sqrt(mode.eigenvalue),
            at_contact_points(on_surface(body.sector, displacements, mode), body.whole_lip.origin,
                              mortar, k * pitch)};
        for (std::array<Complex, 3> &motion : ring_mode.motion)
          for (unsigned int c = 0; c < 3; ++c)
            // Two halves make a sector.
            motion[c] *= c == 0 || gives_way_along ? std::sqrt(0.5) : 0.;
        modes[k].push_back(std::move(ring_mode));
      }
    return modes;
  }
} // namespace ringmotor
