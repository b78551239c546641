// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the energy goes. Expected: closed forms of travelling waves; the work of a hysteretic body
// by summing force times displacement over a period; one tooth over a period instead of all teeth
// at one time sample.

#include "../support/motor_model.h"

#include <ringmotor/balance/drive.h>
#include <ringmotor/balance/loss_budget.h>
#include <ringmotor/points/point_finder.h>
#include <ringmotor/points/rotor_energy.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <map>
#include <utility>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  constexpr double omega = 2. * M_PI * 30e3;

  /** One node on each of 90 teeth, pressed by a wave with 14 periods around the ring. The rotor
   * moves in proportion, with a phase lag @p lag. */
  ContactFields wave_of_14(const unsigned int n_samples, const double force, const double motion,
                           const double lag)
  {
    constexpr unsigned int n_teeth = 90;
    ContactFields fields;
    fields.n_repeating_teeth = n_teeth;
    for (unsigned int sample = 0; sample < n_samples; ++sample)
    {
      fields.times.push_back(sample * 2. * M_PI / omega / (n_teeth * n_samples));
      for (unsigned int tooth = 0; tooth < n_teeth; ++tooth)
      {
        const double phase = 2. * omega * fields.times.back() - 14. * 2. * M_PI * tooth / n_teeth;
        PointVector f, u;
        f[0] = 3. + force * std::cos(phase); // the mean is not part of the wave
        u[0] = motion * std::cos(phase - lag);
        fields.state.force.push_back(f);
        fields.rotor.push_back(u);
      }
    }
    return fields;
  }
} // namespace

TEST(RotorEnergy, PartsAroundTheRingTurnWithTheWave)
{
  const RingPattern even{7, 90, 0}, warped{7, 90, 2}, common{9, 90, 0};
  EXPECT_EQ(time_harmonic(even, 0), 0u);
  EXPECT_EQ(time_harmonic(even, 7), 1u);
  EXPECT_EQ(time_harmonic(even, 83), 1u);
  EXPECT_EQ(time_harmonic(even, 14), 2u);
  EXPECT_EQ(time_harmonic(even, 5), 25u); // 7 * 25 = 175 = -5 (mod 90)
  EXPECT_EQ(time_harmonic(warped, 7), 1u);
  EXPECT_EQ(time_harmonic(warped, 5), 1u);
  EXPECT_EQ(time_harmonic(warped, 2), 0u); // stationary, like the warp
  EXPECT_EQ(time_harmonic(common, 9), 1u);
  EXPECT_EQ(time_harmonic(common, 45), 5u);
}

TEST(RotorEnergy, OfATravellingWave)
{
  // Half of force times motion, its mean over the ring, times 90 teeth.
  constexpr double force = 0.3, motion = 2e-7;
  for (const unsigned int n_samples : {1u, 3u})
  {
    const std::vector<double> energies =
        rotor_energies(wave_of_14(n_samples, force, motion, 0.), {7, 90, 0});
    for (unsigned int m = 0; m < energies.size(); ++m)
      EXPECT_NEAR(energies[m], m == 2 ? 0.25 * 90 * force * motion : 0., 1e-20) << m;
  }
}

TEST(RotorEnergy, LosesWhatAHystereticBodyDoes)
{
  // A compliance of C exp(-i eta) moves by C cos(phase - eta); work per period of force on motion.
  constexpr double force = 0.3, motion = 2e-7, eta = 1e-3;
  constexpr unsigned int n_steps = 3600;
  double work                    = 0.;
  for (unsigned int step = 0; step < n_steps; ++step)
  {
    const double phase = 4. * M_PI * step / n_steps; // twice the wave's frequency
    work += 90. * force * std::cos(phase) * motion * -std::sin(phase - eta) * 4. * M_PI / n_steps;
  }
  const double power                 = work * omega / (2. * M_PI);
  const std::vector<double> energies = rotor_energies(wave_of_14(1, force, motion, 0.), {7, 90, 0});
  EXPECT_NEAR(eta * power_per_loss_factor(energies, omega), power, 1e-5 * power);
}

TEST(RotorEnergy, AMomentOfAllTeethTellsThePeriodOfOne)
{
  const Parameters parameters = reference_motor();
  const CondensedMotor motor =
      condense_motor(parameters, stator_wave(parameters), ContactDiscretisation::level(0));
  const CurvePoint point    = OperatingPointFinder(parameters, motor).find({Control::torque, 0.08});
  const std::size_t n_nodes = motor.nodes.size();
  for (const unsigned int m : {1u, 2u, 5u})
  {
    // Tooth j is where tooth 0 was n j alpha / omega ago.
    double energy = 0.;
    for (std::size_t node = 0; node < n_nodes; ++node)
      for (unsigned int c = 0; c < 3; ++c)
      {
        std::complex<double> force, motion;
        for (unsigned int tooth = 0; tooth < 90; ++tooth)
        {
          const double time                = -7. * tooth * 2. * M_PI / 90. / omega;
          const std::complex<double> phase = std::polar(1. / 90., -omega * m * time);
          force += phase * point.fields.state.force[tooth * n_nodes + node][c];
          motion += phase * point.fields.rotor[tooth * n_nodes + node][c];
        }
        energy += 90. * (std::conj(force) * motion).real();
      }
    EXPECT_GT(energy, 0.) << m;
    EXPECT_NEAR(point.rotor_energies[m], energy, 1e-9 * energy) << m;
  }
  EXPECT_GT(point.rotor_energies[1], point.rotor_energies[2]);
}

TEST(LossBudget, FeltFollowsTheLowerSide)
{
  const Parameters parameters = paper_motor();
  const WaveMotion wave       = [](const dealii::Point<3> &x)
  {
    return std::array<std::complex<double>, 3>{
        {1., 1., std::polar(1e-6, -7. * std::atan2(x[1], x[0]))}};
  };
  Support felt           = parameters.support;
  felt.felt_inner_radius = 29e-3; // reaches beyond the stator
  felt.felt_outer_radius = 34e-3;
  const double area      = M_PI * (34e-3 * 34e-3 - 30e-3 * 30e-3);
  const double energy    = 0.25 * 5e5 / 1e-3 * area * 1e-12;
  const auto on_felt     = radii_on_felt(stator_body(parameters));
  EXPECT_NEAR(felt_energy(felt, on_felt, 90, wave), energy, 1e-9 * energy);
  felt.felt_inner_radius = 36e-3;
  felt.felt_outer_radius = 38e-3;
  EXPECT_EQ(felt_energy(felt, on_felt, 90, wave), 0.);
}

namespace
{
  /** 0.4 W of output and 0.1 W of friction loss. */
  CurvePoint point_at_work()
  {
    CurvePoint point;
    point.result.speed           = 8.;
    point.result.torque          = 0.05;
    point.result.tangential_loss = 0.06;
    point.result.radial_loss     = 0.04;
    point.rotor_power            = 2.;
    return point;
  }

  std::pair<Materials, Support> lossy_stator()
  {
    Materials materials;
    materials.stator_metal.loss_factor = 1e-3;
    materials.piezoceramic.loss_factor = 2e-3;
    Support felt;
    felt.felt_loss_factor = 0.3;
    return {materials, felt};
  }
} // namespace

TEST(LossBudget, AddsUpWithItsErrors)
{
  CurvePoint point       = point_at_work();
  point.result.amplitude = 4e-6; // twice that of the energies
  const PointError half{
      {{"speed", 0.08}, {"friction_loss", 0.01}, {"rotor_power_per_loss_factor", 0.1}}};
  point.errors = {{causes::meshes, half}, {causes::time_step, half}};
  point.errors[causes::time_step]["amplitude"] = 1e-8;
  const auto [materials, felt]                 = lossy_stator();
  const WaveEnergies wave{1e5, 2e-6, {1e-3, 1e-6, causes::wave}, 2e-4, 1e-6};
  const LossBudget budget = loss_budget(point, wave, materials, RotorLossFactor{5e-3}, felt);
  EXPECT_NEAR(budget.output.value, 0.4, 1e-12);
  EXPECT_NEAR(budget.output.error(), std::hypot(0.05 * 0.08, 0.05 * 0.08), 1e-12);
  EXPECT_NEAR(budget.friction.value, 0.1, 1e-12);
  EXPECT_NEAR(budget.stator_metal.value, 2. * 1e5 * 1e-3 * 4e-3, 1e-12);
  EXPECT_NEAR(budget.stator_metal.error(),
              2. * 1e5 * 1e-3 * 4. * std::hypot(1e-6, 1e-3 * 2. * 0.0025), 1e-12);
  EXPECT_NEAR(budget.amplitude.error(), 1e-8, 1e-20);
  EXPECT_NEAR(budget.piezoceramic.value, 2. * 1e5 * 2e-3 * 8e-4, 1e-12);
  EXPECT_NEAR(budget.rotor.value, 5e-3 * 2., 1e-12);
  EXPECT_NEAR(budget.support.value, 2. * 1e5 * 0.3 * 4e-6, 1e-12);
  EXPECT_NEAR(budget.total().value, 0.1 + 0.8 + 0.32 + 0.01 + 0.24, 1e-12);
  const double of_meshes = 0.01 + 5e-3 * 0.1, of_step = of_meshes + 1.36 * 2. * 0.0025,
               of_wave = 8e-4;
  EXPECT_NEAR(budget.total().error(), std::hypot(of_meshes, of_step, of_wave), 1e-12);
  EXPECT_NEAR(budget.efficiency().value, 0.4 / 1.87, 1e-12);
  // The error of a quotient, by changing both parts by their errors of one cause after the other.
  const auto change = [](const double of_output, const double of_loss)
  { return 0.4 / 1.87 - (0.4 - of_output) / (1.87 - of_output + of_loss); };
  EXPECT_NEAR(budget.efficiency().error(),
              std::hypot(change(0.004, of_meshes), change(0.004, of_step), change(0., of_wave)),
              1e-4);
  // By causes
  EXPECT_NEAR(budget.output.errors.at(causes::meshes), 0.05 * 0.08, 1e-12);
  EXPECT_NEAR(budget.total().errors.at(causes::meshes), 0.01 + 5e-3 * 0.1, 1e-12);
  EXPECT_NEAR(budget.total().errors.at(causes::wave), 2. * 1e5 * 1e-3 * 4. * 1e-6, 1e-12);
  EXPECT_NEAR(budget.total().errors.at(causes::time_step), 0.01 + 5e-3 * 0.1 + 1.36 * 2. * 0.0025,
              1e-12);
}

TEST(DrivePoint, PutsInWhatComesOut)
{
  // The contact takes output, friction loss, and the losses of all vibrations but the wave from the
  // wave, which loses 2 omega eta E itself.
  CurvePoint point             = point_at_work();
  point.result.stator_damping  = 0.07;
  point.result.modal_power     = 5e-3 * 2. + 0.07;
  point.result.input_power     = 0.4 + 0.1 + point.result.modal_power;
  point.result.gross_power     = 1.;
  point.result.amplitude       = 2e-6;
  const auto [materials, felt] = lossy_stator();
  const WaveEnergies energies{2. * M_PI * 4e4, 2e-6, 1e-3, 2e-4, 1e-6};
  const LossBudget budget = loss_budget(point, energies, materials, RotorLossFactor{5e-3}, felt);
  DrivenWave wave;
  wave.amplitude            = 2e-6;
  wave.natural_frequency    = 4e4;
  wave.modal_mass           = 0.02;
  wave.force_factor         = {{0.5, 0.5}};
  wave.parallel_capacitance = {{5e-9, 5e-9}};
  const DrivePoint drive    = drive_point(point, budget, wave);
  const double of_wave      = 2. * 2. * M_PI * 4e4 * (1e-3 * 1e-3 + 2e-3 * 2e-4 + 0.3 * 1e-6);
  EXPECT_NEAR(drive.electrical_input.value, 0.4 + 0.1 + 0.01 + 0.07 + of_wave, 1e-9);
  EXPECT_LT(drive.imbalance, 1e-9);
}

TEST(LossBudget, HasTheRotorsPartsThatThereAre)
{
  CurvePoint point;
  point.rotor_power      = 2.;
  point.result.amplitude = 1e-6;
  point.errors           = {{causes::meshes, PointError{{{"rotor_power_per_loss_factor", 0.1}}}}};
  const WaveEnergies wave{1e5, 1e-6, 1e-3, 2e-4, 1e-6};
  const auto losses = [&](const RotorLossFactor &of_rotor)
  {
    std::map<std::string, Estimate> named;
    for (const Quantity &loss : loss_budget(point, wave, {}, of_rotor, {}).losses())
      named.emplace(loss.name, loss.estimate);
    return named;
  };
  auto of = losses({1e-3, 4e-3, 2e-3, true, true});
  EXPECT_NEAR(of.at("internal_loss_rotor_metal").value, 2e-3, 1e-15);
  EXPECT_NEAR(of.at("internal_loss_lining").value, 8e-3, 1e-15);
  EXPECT_NEAR(of.at("internal_loss_adhesive").value, 4e-3, 1e-15);
  EXPECT_NEAR(of.at("internal_loss_rotor").value, 14e-3, 1e-15);
  EXPECT_NEAR(of.at("internal_loss_rotor").error(),
              of.at("internal_loss_rotor_metal").error() + of.at("internal_loss_lining").error() +
                  of.at("internal_loss_adhesive").error(),
              1e-15);
  const double total = of.at("total_loss").value;
  of                 = losses({7e-3});
  EXPECT_EQ(of.count("internal_loss_rotor_metal"), 0u);
  EXPECT_EQ(of.count("internal_loss_lining"), 0u);
  EXPECT_EQ(of.count("internal_loss_adhesive"), 0u);
  EXPECT_NEAR(of.at("internal_loss_rotor").value, 14e-3, 1e-15);
  EXPECT_NEAR(of.at("total_loss").value, total, 1e-12); // the parts do not count twice
  of = losses({3e-3, 4e-3, 0., true, false});
  EXPECT_EQ(of.count("internal_loss_lining"), 1u);
  EXPECT_EQ(of.count("internal_loss_adhesive"), 0u);
}
