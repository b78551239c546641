// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/lip_amplification.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Pressure on the outer line of a half sector's lip that travels with k waves around the ring:
     * forces on all displacements, real field, then imaginary one. */
    Vector<double> pressure(const ContactSurface &lip, const unsigned int k)
    {
      double outer = 0., last = 0.;
      for (const SurfaceNode &node : lip.nodes)
      {
        outer = std::max(outer, node.place[0]);
        last  = std::max(last, node.place[1]);
      }
      Vector<double> forces(6 * lip.nodes.size());
      for (unsigned int i = 0; i < lip.nodes.size(); ++i)
      {
        const double theta = lip.nodes[i].place[1];
        if (lip.nodes[i].place[0] < outer * (1. - 1e-9))
          continue;
        const bool is_shared = std::abs(theta) < 1e-9 || theta > last - 1e-9; // with the next half
        const double force   = is_shared ? 0.5 : 1.;
        forces[3 * i]        = force * std::cos(k * theta);
        forces[3 * (lip.nodes.size() + i)] = -force * std::sin(k * theta);
      }
      return forces;
    }
  } // namespace

  LipAmplification::LipAmplification(const Parameters &parameters, const LipModes &modes,
                                     const unsigned int level, const unsigned int n_harmonics)
  {
    const RotorBody body(parameters, LipModes::discretisation(level));
    const Condensation condensation = body.condensed();
    const InterfaceCompliance interface(condensation);
    for (unsigned int m = 1; m <= n_harmonics; ++m)
    {
      const unsigned int k = nodal_diameter_of_harmonic(parameters.motor, m);
      harmonics.push_back({k, 0., {}, {}});
      if (k < 2)
        continue;
      const Vector<double> forces = pressure(body.lip, k);
      Vector<double> motion(forces.size());
      interface.compliance(k, body.held(k)).vmult(motion, forces);
      harmonics.back().static_motion = forces * motion;
      for (const LipModes::LipMode &mode : modes.of_diameter(k))
      {
        double work = 0.;
        for (unsigned int i = 0; i < mode.motion.size(); ++i)
          work += forces[i] * mode.motion[i];
        harmonics.back().frequencies.push_back(mode.angular_frequency);
        harmonics.back().work.push_back(work * work);
      }
    }
  }

  double LipAmplification::at(const unsigned int harmonic, const double angular_frequency) const
  {
    const Harmonic &of = harmonics[harmonic - 1];
    double sum         = 1.;
    for (std::size_t r = 0; r < of.frequencies.size(); ++r)
    {
      const double square = std::pow(of.frequencies[r], 2);
      sum += of.work[r] / of.static_motion *
             (1. / (square - std::pow(angular_frequency, 2)) - 1. / square);
    }
    return sum;
  }

  double LipAmplification::rough_effect(const double angular_frequency) const
  {
    constexpr double pressed = 0.25, share_of_speed = 1. / 3.;
    double whole = 0., changed = 0.;
    for (unsigned int m = 1; m <= n_harmonics(); ++m)
    {
      // The Fourier coefficient of the pressure, relative to its mean.
      const double phase  = numbers::PI * m * pressed,
                   motion = std::pow(std::sin(phase) / phase, 2) * harmonics[m - 1].static_motion;
      whole += motion;
      changed += motion * std::min(1., std::abs(at(m, m * angular_frequency) - 1.));
    }
    return whole > 0. ? share_of_speed * changed / whole : 0.;
  }
} // namespace ringmotor
