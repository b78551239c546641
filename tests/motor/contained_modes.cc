// SPDX-License-Identifier: LGPL-2.1-or-later

// The static compliance of a motor whose bodies vibrate contains the static motions of their modes,
// also where these come from finer meshes.

#include "support/hermitian.h"
#include "support/motor_model.h"

#include <ringmotor/contact/ring_compliance.h>
#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/contact_bodies.h>
#include <ringmotor/motor/rotor_modes.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  using Complex = std::complex<double>;

  const ContactDiscretisation mesh = ContactDiscretisation::level(1);

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
    const unsigned int n         = 3 * compliance.n_nodes();
    std::vector<Complex> of_wave = compliance.of_wave(k);
    const double largest         = hermitian_eigenvalues(n, of_wave).back();
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
    return hermitian_eigenvalues(n, of_wave).front() / largest;
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
  const CondensedMotor motor  = condense_motor(parameters, wave, mesh, fine_modes);
  const RotorVibration vibration(parameters, wave.angular_frequency);
  const RingModes of_rotor = vibration.at(
      vibration.setting(fine_modes), ToothBody(parameters, mesh).whole_top.surface, mesh.lip_turn);
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
        condense_motor(without, wave, mesh, fine_modes, nullptr, ModeSets::own);
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
