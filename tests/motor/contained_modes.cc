// SPDX-License-Identifier: LGPL-2.1-or-later

// The static compliance of a motor whose bodies vibrate contains the static motions of their modes,
// also where these come from finer meshes.

#include "support/motor_model.h"

#include <ringmotor/contact/ring_compliance.h>
#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/contact_bodies.h>
#include <ringmotor/motor/rotor_modes.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  using Complex = std::complex<double>;

  const ContactDiscretisation on = ContactDiscretisation::level(1);

  constexpr unsigned int fine_modes = 2; ///< on elements of a higher degree than those in contact

  Parameters vibrating_motor()
  {
    Parameters parameters = reference_motor();
    for (const std::string name : {"Rotor inertia", "Tooth inertia", "Tooth vibration"})
      parameters.effects[name] = EffectChoice::on;
    return parameters;
  }

  /** The smallest eigenvalue of the compliance for a wave without the static motions of modes, over
   * the largest one of the compliance itself. */
  double least_residual(const RingCompliance &compliance, const std::vector<RingMode> &modes,
                        const unsigned int k)
  {
    const unsigned int n           = 3 * compliance.n_nodes();
    std::vector<Complex> of_wave   = compliance.of_wave(k);
    const auto extreme_eigenvalues = [&]
    {
      dealii::LAPACKFullMatrix<double> real(2 * n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
        {
          const Complex entry = 0.5 * (of_wave[j * n + i] + std::conj(of_wave[i * n + j]));
          real(i, j) = real(n + i, n + j) = entry.real();
          real(n + i, j)                  = entry.imag();
          real(i, n + j)                  = -entry.imag();
        }
      dealii::Vector<double> values;
      dealii::FullMatrix<double> vectors;
      constexpr double all = std::numeric_limits<double>::max();
      real.compute_eigenvalues_symmetric(-all, all, 0., values, vectors);
      return std::make_pair(values[0], values[values.size() - 1]);
    };
    const double largest = extreme_eigenvalues().second;
    for (const RingMode &mode : modes)
    {
      std::vector<Complex> motion; // modes turn the other way
      for (const std::array<Complex, 3> &at_node : mode.motion)
        for (const Complex &component : at_node)
          motion.push_back(std::conj(component) / mode.angular_frequency);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          of_wave[j * n + i] -= motion[i] * std::conj(motion[j]);
    }
    return extreme_eigenvalues().first / largest;
  }
  /** Of a motion under a traction in direction @p component with k waves around the ring. */
  Complex response(const CondensedMotor &motor, const std::vector<std::array<Complex, 3>> &motion,
                   const unsigned int k, const unsigned int component)
  {
    Complex sum = 0.;
    for (std::size_t a = 0; a < motor.nodes.size(); ++a)
      sum += std::conj(motion[a][component]) * motor.nodes[a].area *
             std::polar(1., -(k * motor.nodes[a].angle));
    return sum;
  }
} // namespace

TEST(ContainedModes, LeaveNoNegativeResidualCompliance)
{
  const Parameters parameters = vibrating_motor();
  const StatorWave wave       = stator_wave(parameters);
  const CondensedMotor motor  = condense_motor(parameters, wave, on, fine_modes);
  const RingModes of_rotor =
      RotorVibration(parameters, wave.angular_frequency)
          .at(RotorVibration(parameters, wave.angular_frequency).setting(fine_modes),
              ToothBody(parameters, on).whole_top.surface, on.lip_turn);
  for (const unsigned int k : {0u, 1u, 6u, 7u, 13u, 22u, 40u, 45u})
  {
    for (const RingModes *modes :
         {&motor.modes, &motor.coarse_modes, &motor.modes_of_other_harmonics})
    {
      ASSERT_EQ(modes->size(), 46u);
      ASSERT_EQ((*modes)[k].empty(), k == 0); // no harmonic has as many waves
      EXPECT_GT(least_residual(motor.compliance, (*modes)[k], k), -1e-8) << k;
    }
    // Modes on a finer mesh than the bodies in contact are not contained by themselves.
    if (k > 1 && k < 45)
    {
      EXPECT_LT(least_residual(motor.compliance, of_rotor[k], k), -1e-3) << k;
    }
  }
}

TEST(ContainedModes, ChangeLittleUnderSmoothForces)
{
  constexpr double little     = 0.1;
  const Parameters parameters = vibrating_motor();
  const StatorWave wave       = stator_wave(parameters);
  // Rigid teeth and a rotor that does not give way along its lip leave a singular compliance.
  const std::vector<std::vector<std::string>> cases{
      {}, {"Tooth vibration"}, {"Tooth vibration", "Tooth shear"}, {"Rotor tangential compliance"}};
  for (const std::vector<std::string> &off : cases)
  {
    Parameters without = parameters;
    for (const std::string &name : off)
      without.effects[name] = EffectChoice::off;
    const CondensedMotor motor =
        condense_motor(without, wave, on, fine_modes, nullptr, ModeSets::own);
    double changed_most = 0.;
    for (const unsigned int k : {6u, 7u, 13u, 22u, 40u, 45u})
    {
      double largest = 0., change = 0.;
      for (const RingMode &mode : motor.modes[k])
        for (unsigned int component = 0; mode.of_rotor() && component < 3; ++component)
        {
          const Complex of_body   = response(motor, mode.motion_of_body(), k, component),
                        contained = response(motor, mode.motion, k, component);
          largest                 = std::max(largest, std::abs(of_body) / mode.angular_frequency);
          change = std::max(change, std::abs(contained - of_body) / mode.angular_frequency);
        }
      EXPECT_LT(change, little * largest) << (off.empty() ? "" : off.back()) << " " << k;
      changed_most = std::max(changed_most, change);
    }
    EXPECT_GT(changed_most, 0.);
  }
}
