// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/modes_by_shapes.h>

#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;
  } // namespace

  MarchedModes::MarchedModes(const RingModes &modes, const unsigned int n_sectors,
                             const RingDynamics &dynamics)
      : modes(std::make_shared<const ModesByShapes>(modes)), n_sectors(n_sectors),
        dynamics(dynamics)
  {
    Assert(!dynamics.is_hysteretic, ExcMessage("hysteretic damping in single steps"));
  }

  MarchedModes::ByMode MarchedModes::modal_forces(const std::vector<PointVector> &forces) const
  {
    ByMode result(modes->by_diameter.size());
    for (unsigned int k = 0; k < result.size(); ++k)
      if (!modes->by_diameter[k].empty())
      {
        // Sector j of a wave has the phase -k j alpha.
        const std::vector<Complex> force =
            modes->wave_on_shapes(forces, n_sectors, (n_sectors - k) % n_sectors);
        for (const ModesByShapes::Mode &mode : modes->by_diameter[k])
          result[k].push_back(mode.frequency * mode.static_motion(force));
      }
    return result;
  }

  void MarchedModes::rest(const std::vector<PointVector> &forces)
  {
    earlier = modal_forces(forces);
    states.clear();
    for (unsigned int k = 0; k < earlier.size(); ++k)
    {
      states.emplace_back();
      for (unsigned int r = 0; r < earlier[k].size(); ++r)
        states[k].push_back(
            {earlier[k][r] / std::pow(modes->by_diameter[k][r].frequency, 2), 0., 0.});
    }
  }

  void MarchedModes::set(std::vector<std::vector<ModalState>> new_states,
                         const std::vector<PointVector> &forces)
  {
    states  = std::move(new_states);
    earlier = modal_forces(forces);
  }

  RingCompliance MarchedModes::compliance(const double dt) const
  {
    std::vector<std::vector<Complex>> waves;
    for (unsigned int k = 0; 2 * k <= n_sectors; ++k)
    {
      std::vector<Complex> factors;
      for (const ModesByShapes::Mode &mode : modes->by_diameter[k])
        factors.push_back(std::pow(mode.frequency, 2) *
                              dynamics.scheme.response_in_step(
                                  dt, mode.frequency, mode.damping(dynamics) + added_damping) -
                          1.);
      waves.push_back(modes->sum_over_modes(k, factors));
      for (Complex &entry : waves.back()) // the ring compliance's waves are exp(+i k j alpha)
        entry = std::conj(entry);
    }
    return RingCompliance(n_sectors, modes->shapes, waves);
  }

  std::vector<PointVector> MarchedModes::motion_of(const ByMode &displacements) const
  {
    std::vector<PointVector> motion(n_sectors * modes->shapes.m() / 3);
    for (unsigned int k = 0; k < displacements.size(); ++k)
      if (!displacements[k].empty()) // exp(-i k j alpha)
        modes->add_motion(k, displacements[k], true, k, n_sectors, motion);
    return motion;
  }

  std::vector<PointVector> MarchedModes::motion() const
  {
    ByMode displacements(states.size());
    for (unsigned int k = 0; k < states.size(); ++k)
      for (unsigned int r = 0; r < states[k].size(); ++r)
      {
        const ModesByShapes::Mode &mode = modes->by_diameter[k][r];
        displacements[k].push_back(states[k][r].displacement);
        if (mode.part == ModePart::tooth)
          displacements[k].back() -= earlier[k][r] / std::pow(mode.frequency, 2);
      }
    return motion_of(displacements);
  }

  std::vector<Complex> MarchedModes::vibration() const
  {
    std::vector<Complex> amplitudes;
    for (unsigned int k = 0; k < states.size(); ++k)
      for (unsigned int r = 0; r < states[k].size(); ++r)
        amplitudes.push_back(states[k][r].displacement -
                             earlier[k][r] / std::pow(modes->by_diameter[k][r].frequency, 2));
    return amplitudes;
  }

  std::vector<PointVector> MarchedModes::free_motion(const double dt) const
  {
    ByMode displacements(states.size());
    for (unsigned int k = 0; k < states.size(); ++k)
      for (unsigned int r = 0; r < states[k].size(); ++r)
      {
        const ModesByShapes::Mode &mode = modes->by_diameter[k][r];
        displacements[k].push_back(without_force(dynamics.scheme, states[k][r], dt, mode.frequency,
                                                 mode.damping(dynamics) + added_damping)
                                       .displacement);
      }
    return motion_of(displacements);
  }

  ModalPower MarchedModes::step(const std::vector<PointVector> &forces, const double dt)
  {
    const ByMode now = modal_forces(forces);
    ModalPower power;
    for (unsigned int k = 0; k < states.size(); ++k)
      for (unsigned int r = 0; r < states[k].size(); ++r)
      {
        const ModesByShapes::Mode &mode = modes->by_diameter[k][r];
        const double omega = mode.frequency, damping = mode.damping(dynamics) + added_damping,
                     weight   = n_sectors * multiplicity(k, n_sectors);
        const ModalState from = states[k][r];
        ModalState &state     = states[k][r];
        state                 = without_force(dynamics.scheme, from, dt, omega, damping);
        add_force(dynamics.scheme, now[k][r], dt, omega, damping, state);
        const Complex moved =
            state.displacement - from.displacement - (now[k][r] - earlier[k][r]) / (omega * omega);
        power.taken += weight / dt * (std::conj(0.5 * (now[k][r] + earlier[k][r])) * moved).real();
        if (mode.part == ModePart::rotor)
          power.damped_by_factor +=
              weight * omega * std::norm(0.5 * (state.velocity + from.velocity));
      }
    earlier = now;
    return power;
  }
} // namespace ringmotor
