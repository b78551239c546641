// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/rotor_energy.h>

#include <deal.II/base/numbers.h>

#include <complex>
#include <cstdlib>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /** The few nodes on which a force acts at any time. */
    std::vector<std::size_t> pressed_nodes(const std::vector<PointVector> &force,
                                           const std::size_t n_nodes)
    {
      std::vector<bool> is_pressed(n_nodes, false);
      for (std::size_t i = 0; i < force.size(); ++i)
        if (force[i] != PointVector())
          is_pressed[i % n_nodes] = true;
      std::vector<std::size_t> nodes;
      for (std::size_t node = 0; node < n_nodes; ++node)
        if (is_pressed[node])
          nodes.push_back(node);
      return nodes;
    }

    /** The component of vectors with q waves around the teeth of one repetition, at some nodes. */
    std::vector<Complex> wave_part(const PointVector *vectors, const unsigned int n_teeth,
                                   const std::size_t n_nodes, const std::vector<std::size_t> &nodes,
                                   const unsigned int q)
    {
      std::vector<Complex> part(3 * nodes.size());
      for (unsigned int tooth = 0; tooth < n_teeth; ++tooth)
      {
        const Complex phase =
            std::polar(1. / n_teeth, 2. * numbers::PI * (q * tooth % n_teeth) / n_teeth);
        for (std::size_t i = 0; i < nodes.size(); ++i)
          for (unsigned int c = 0; c < 3; ++c)
            part[3 * i + c] += phase * vectors[tooth * n_nodes + nodes[i]][c];
      }
      return part;
    }
  } // namespace

  unsigned int time_harmonic(const RingPattern &pattern, const unsigned int k)
  {
    const int n_teeth = pattern.n_teeth, n_waves = pattern.n_waves, p = pattern.warp_waves;
    for (int order = 0; order <= n_teeth; ++order)
      for (int m = 0; m <= order; ++m) // among equal orders the slowest
        for (const int l : {order - m, m - order})
          for (const int sign : {1, -1})
            if ((p > 0 || l == 0) &&
                (sign * m * n_waves + l * p - static_cast<int>(k)) % n_teeth == 0)
              return m;
    return 0;
  }

  std::vector<double> rotor_energies(const ContactFields &fields, const RingPattern &pattern,
                                     const unsigned int first_sample)
  {
    const unsigned int n_teeth           = fields.n_repeating_teeth, // of one repetition
        n_repeats                        = pattern.n_teeth / n_teeth;
    const std::size_t n_samples          = fields.times.size(),
                      n_nodes            = fields.state.force.size() / (n_samples * n_teeth);
    const std::vector<std::size_t> nodes = pressed_nodes(fields.state.force, n_nodes);
    std::vector<double> energies(1, 0.);
    for (unsigned int q = 0; q < n_teeth; ++q)
    {
      const unsigned int m = time_harmonic(pattern, q * n_repeats);
      if (m == 0)
        continue;
      energies.resize(std::max<std::size_t>(energies.size(), m + 1), 0.);
      for (std::size_t sample = first_sample; sample < n_samples; ++sample)
      {
        const std::size_t first = sample * n_teeth * n_nodes;
        const auto part         = [&](const std::vector<PointVector> &vectors)
        { return wave_part(vectors.data() + first, n_teeth, n_nodes, nodes, q); };
        const std::vector<Complex> force = part(fields.state.force), motion = part(fields.rotor),
                                   modal = fields.modal.empty() ? std::vector<Complex>(force.size())
                                                                : part(fields.modal);
        double work                      = 0.;
        for (std::size_t i = 0; i < force.size(); ++i)
          work += (std::conj(force[i]) * (motion[i] - modal[i])).real();
        energies[m] += 0.5 * pattern.n_teeth * work / (n_samples - first_sample);
      }
    }
    return energies;
  }

  double power_per_loss_factor(const std::vector<double> &energies, const double angular_frequency)
  {
    double power = 0.;
    for (std::size_t m = 1; m < energies.size(); ++m)
      power += 2. * m * angular_frequency * energies[m];
    return power;
  }
} // namespace ringmotor
