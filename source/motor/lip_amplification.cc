// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/lip_amplification.h>
#include <ringmotor/structure/cyclic_factors.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** A load on the outer line of a half sector's lip that travels with k waves around the ring:
     * forces on all displacements, real field, then imaginary one.
     * @param direction see PointVector */
    std::vector<double> load(const ContactSurface &lip, const unsigned int k,
                             const unsigned int direction)
    {
      double outer = 0., last = 0.;
      for (const SurfaceNode &node : lip.nodes)
      {
        outer = std::max(outer, node.place[0]);
        last  = std::max(last, node.place[1]);
      }
      std::vector<double> forces(6 * lip.nodes.size());
      for (unsigned int i = 0; i < lip.nodes.size(); ++i)
      {
        const double theta = lip.nodes[i].place[1];
        if (lip.nodes[i].place[0] < outer * (1. - 1e-9))
          continue;
        const bool is_shared = std::abs(theta) < 1e-9 || theta > last - 1e-9; // with the next half
        const double force   = is_shared ? 0.5 : 1.;
        forces[3 * i + direction]                      = force * std::cos(k * theta);
        forces[3 * (lip.nodes.size() + i) + direction] = -force * std::sin(k * theta);
      }
      return forces;
    }

    /** The same on the unknowns of the rotor's sector. */
    std::vector<double> on_unknowns(const RotorBody &body, const unsigned int k,
                                    const std::vector<double> &load)
    {
      std::array<Vector<double>, 2> forces{
          {Vector<double>(body.sector.n_dofs()), Vector<double>(body.sector.n_dofs())}};
      for (std::size_t i = 0; i < load.size(); ++i)
      {
        const std::size_t node = i / 3, n_nodes = body.lip.nodes.size();
        for (const auto &[dof, coefficient] : body.lip.nodes[node % n_nodes].displacement[i % 3])
          forces[node / n_nodes][dof] += load[i] * coefficient;
      }
      return body.sector.loads_of(k, forces);
    }

    double product(const std::vector<double> &a, const std::vector<double> &b)
    {
      return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
    }
  } // namespace

  LipAmplification::LipAmplification(const Parameters &parameters, const LipModes &modes,
                                     const unsigned int level, const unsigned int n_harmonics)
  {
    const RotorBody body(parameters, LipModes::discretisation(level));
    CyclicFactors stiffness(body.sector);
    for (unsigned int m = 1; m <= n_harmonics; ++m)
    {
      const unsigned int k                    = nodal_diameter_of_harmonic(parameters.motor, m);
      harmonics.emplace_back().nodal_diameter = k;
      if (k < 2)
        continue;
      Harmonic &harmonic               = harmonics.back();
      const std::vector<double> forces = load(body.lip, k, 0), outwards = load(body.lip, k, 2);
      const std::vector<double> loads = on_unknowns(body, k, forces);
      std::vector<double> motion      = loads;
      stiffness.factorise(k, 0.);
      stiffness.solve(motion);
      harmonic.static_motion = product(loads, motion);
      harmonic.static_radial = product(on_unknowns(body, k, outwards), motion);
      for (const LipModes::LipMode &mode : modes.of_diameter(k))
      {
        const auto work = [&](const std::vector<double> &load)
        { return product(mode.motion, load); };
        harmonic.frequencies.push_back(mode.angular_frequency);
        harmonic.work.push_back(work(forces) * work(forces));
        harmonic.radial.push_back(work(forces) * work(outwards));
      }
    }
  }

  double LipAmplification::dynamic(const Harmonic &of, const double static_motion,
                                   const std::vector<double> &work, const double angular_frequency)
  {
    double sum = static_motion;
    for (std::size_t r = 0; r < of.frequencies.size(); ++r)
    {
      const double square = std::pow(of.frequencies[r], 2);
      sum += work[r] * (1. / (square - std::pow(angular_frequency, 2)) - 1. / square);
    }
    return sum;
  }

  double LipAmplification::at(const unsigned int harmonic, const double angular_frequency) const
  {
    const Harmonic &of = harmonics[harmonic - 1];
    if (of.static_motion == 0.)
      return 1.;
    return dynamic(of, of.static_motion, of.work, angular_frequency) / of.static_motion;
  }

  double LipAmplification::radial_ratio(const unsigned int harmonic,
                                        const double angular_frequency) const
  {
    const Harmonic &of = harmonics[harmonic - 1];
    if (of.static_motion == 0.)
      return 0.;
    return dynamic(of, of.static_radial, of.radial, angular_frequency) /
           dynamic(of, of.static_motion, of.work, angular_frequency);
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
