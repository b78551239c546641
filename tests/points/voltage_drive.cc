// SPDX-License-Identifier: LGPL-2.1-or-later
// A wave driven by a voltage, with contacts made up so that its amplitudes follow by hand: that of
// a linear oscillator in closed form; those of one whose spring changes with the square of the
// amplitude from the roots of a cubic equation, chosen in advance by the formulas of Vieta.
#include <ringmotor/motor/voltage_drive.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/points/frequency_response.h>
#include <ringmotor/points/wave_balance.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>

using namespace ringmotor;

namespace
{
  constexpr double natural = 2. * M_PI * 30e3;

  VoltageDrive drive_of(const double voltage)
  {
    VoltageDrive drive;
    drive.voltage           = voltage;
    drive.force_factor      = 0.25;
    drive.modal_mass        = 0.028;
    drive.natural_frequency = natural;
    drive.internal_loss     = 1e11; // W/m^2
    return drive;
  }

  /** For the amplitude where an excess vanishes, to 1e-5 of it. */
  StableRoot<double> search(const double start, const std::function<double(double)> &excess)
  {
    return balanced<double>(
        driven_amplitude, std::log(start),
        [&](const double place)
        { return std::make_pair(excess(std::exp(place)), std::exp(place)); },
        [](const StableRoot<double> &root)
        {
          return root.share() * std::abs(root.found.state - root.other->state) <=
                 1e-5 * root.found.state;
        });
  }

  double amplitude_from(const double start, const VoltageDrive &drive,
                        const std::function<WaveLoad(double amplitude)> &contact)
  {
    const auto found =
        search(start, [&](const double a) { return drive.excess(contact(a), false); });
    EXPECT_EQ(found.end, RootEnd::settled);
    return found.found.state;
  }
} // namespace

TEST(VoltageDrive, MovesALinearOscillatorAtResonance)
{
  const VoltageDrive drive = drive_of(20.);
  const double constant    = 0.3; // W, as of a brake whose power does not depend on the amplitude
  // 5 N = (0.3 W / a + 1e11 W/m^2 a) / omega has two roots; the larger one is stable.
  const double force = 0.25 * 20. * natural;
  const double exact = (force + std::sqrt(force * force - 4. * 1e11 * constant)) / (2. * 1e11);
  for (const double start : {0.5, 0.9, 1., 1.5, 20.})
    EXPECT_NEAR(amplitude_from(start * exact, drive,
                               [&](const double a) {
                                 return WaveLoad{a, natural, 0., constant};
                               }) /
                    exact,
                1., 3e-5);
}

TEST(VoltageDrive, DecaysWhereTheBrakeIsTooStrong)
{
  const VoltageDrive drive = drive_of(20.);
  EXPECT_THROW(amplitude_from(1e-6, drive,
                              [&](const double a) {
                                return WaveLoad{a, natural, 0., 1e6 * a};
                              }),
               ComputationError);
}

TEST(VoltageDrive, MovesALinearOscillatorBesideItsResonance)
{
  VoltageDrive drive  = drive_of(20.);
  drive.frequency     = 1.01 * natural;
  const double spring = 0.028 * natural * natural * (1. + 2. * 0.002 - 1.01 * 1.01),
               damper = 1e11 / *drive.frequency, exact = 5. / std::hypot(spring, damper);
  EXPECT_NEAR(amplitude_from(1e-6, drive,
                             [&](const double a) {
                               return WaveLoad{a, *drive.frequency, 0.002, 0.};
                             }) /
                  exact,
              1., 3e-5);
}

TEST(VoltageDrive, HasTwoStableAmplitudesBesideASofteningResonance)
{
  // With x the square of the amplitude over (1 um)^2, (A + B x)^2 x + D^2 x = F^2 has the roots 1,
  // 1.5 and 2, the middle one unstable, if
  //   -2 A / B = 4.5, (A^2 + D^2) / B^2 = 6.5, F^2 / B^2 = 3.
  const double d = 1e11 / (0.99 * natural), b = -d / std::sqrt(6.5 - 4.5 * 4.5 / 4.), a = -2.25 * b,
               force = std::abs(b) * std::sqrt(3.) * 1e-6;
  VoltageDrive drive = drive_of(force / 0.25);
  drive.frequency    = 0.99 * natural;
  // The mass for which the spring of the oscillator at rest is A at this frequency.
  drive.modal_mass   = a / (natural * natural * (1. - 0.99 * 0.99));
  const auto contact = [&](const double amplitude)
  {
    const double x = std::pow(amplitude / 1e-6, 2);
    return WaveLoad{amplitude, *drive.frequency,
                    b * x / (2. * drive.modal_mass.value * natural * natural), 0.};
  };
  const auto from = [&](const double x)
  { return std::pow(amplitude_from(1e-6 * std::sqrt(x), drive, contact) / 1e-6, 2); };
  EXPECT_NEAR(from(0.5), 1., 3e-4);
  EXPECT_NEAR(from(1.45), 1., 3e-4);
  EXPECT_NEAR(from(1.55), 2., 3e-4);
  EXPECT_NEAR(from(2.5), 2., 3e-4);
}

namespace
{
  /** Until the excess is at most 1e-10. */
  StableRoot<double> root_of(const std::function<double(double)> &excess)
  {
    return stable_root<double>(
        0., [&](const double x) { return std::make_pair(excess(x), x); },
        [](const StableRoot<double> &root) { return std::abs(root.found.excess) <= 1e-10; },
        {0.3, 10., 1e-6});
  }
} // namespace

TEST(StableRoot, IsFoundFromBothSides)
{
  for (const double exact : {-3., -1e-3, 1e-3, 0.4, 3.})
  {
    const auto root = root_of([&](const double x) { return std::sinh(x - exact); });
    EXPECT_EQ(root.end, RootEnd::settled);
    EXPECT_NEAR(root.found.state, exact, 1e-9);
  }
}

TEST(StableRoot, IsTheJumpOfAnExcessWithoutARoot)
{
  // Both sides of the jump at 0.7, where the excess changes from -0.2 to 0.1.
  const auto root = root_of([](const double x) { return x - 0.7 + (x < 0.7 ? -0.2 : 0.1); });
  EXPECT_EQ(root.end, RootEnd::jump);
  ASSERT_TRUE(root.other);
  EXPECT_NEAR(root.found.place, 0.7, 2e-6);
  EXPECT_NEAR(root.other->place, 0.7, 2e-6);
  EXPECT_NEAR(root.found.excess, 0.1, 1e-5);
  EXPECT_NEAR(root.other->excess, -0.2, 1e-5);
  EXPECT_EQ(root.share(), 1.);
}

TEST(StableRoot, KnowsWhatItLeavesOpen)
{
  // Of a state that is linear in the excess, its share of the difference is the whole rest.
  const auto root = stable_root<double>(
      0., [](const double x) { return std::make_pair(1.3 * (x - 0.25), 7. * x); },
      [](const StableRoot<double> &so_far) { return std::abs(so_far.found.excess) < 0.2; },
      {0.3, 10., 1e-6});
  ASSERT_TRUE(root.other);
  const double rest = 7. * 0.25 - root.found.state;
  EXPECT_NE(rest, 0.);
  EXPECT_NEAR(std::abs(rest), root.share() * std::abs(root.found.state - root.other->state), 1e-12);
}

TEST(StableRoot, IsNotFoundWhereThePlaceMovesForEver)
{
  EXPECT_EQ(root_of([](const double) { return -0.2; }).end, RootEnd::escaped);
}

TEST(VoltageDrive, GrowsWhereTheRotorFeedsIt)
{
  const VoltageDrive drive = drive_of(20.);
  EXPECT_LT(drive.excess({1e-6, natural, 0., -0.2}, false), 0.);
}

TEST(VoltageDrive, KnowsTheAmplitudeAsWellAsItsNumbers)
{
  VoltageDrive drive                   = drive_of(20.);
  drive.force_factor.errors["phases"]  = 0.01 * drive.force_factor.value;
  drive.internal_loss.errors["losses"] = 0.02 * drive.internal_loss.value;
  const auto free    = [](const double a) { return WaveLoad{a, natural, 0., 0.}; };
  const double exact = 5. * natural / 1e11;
  const auto found   = search(exact, [&](const double a) { return drive.excess(free(a), true); });
  EXPECT_NEAR(found.found.state / exact, 1.01 / 0.98, 1e-4);
}

TEST(VoltageDrive, SustainsAnAmplitudeAtTwoFrequencies)
{
  VoltageDrive drive = drive_of(20.);
  const WaveLoad load{2e-6, natural, 0.003, 0.1};
  for (const double frequency : drive.frequencies(load))
  {
    drive.frequency = frequency;
    // The same work in a period.
    const WaveLoad there{load.amplitude, frequency, load.detuning,
                         (0.1 + 1e11 * 4e-12) * frequency / natural - 1e11 * 4e-12};
    EXPECT_NEAR(drive.excess(there, false), 0., 1e-12);
    const std::complex<double> admittance = drive.motional_admittance(load, frequency);
    // Current: the charge of the wave by time; power: that of both phases.
    EXPECT_NEAR(std::abs(admittance) * 20., 0.25 * frequency * 2e-6, 1e-12);
    EXPECT_NEAR(admittance.real() * 400. / (0.1 + 1e11 * 4e-12), frequency / natural, 1e-12);
  }
  // At its largest amplitude, one.
  const double largest   = 5. * natural / 1e11;
  const auto frequencies = drive.frequencies({largest, natural, 0., 0.});
  EXPECT_NEAR(frequencies[0] / natural, 1., 1e-6);
  EXPECT_NEAR(frequencies[1] / natural, 1., 1e-6);
}

TEST(FrequencyResponse, TellsWhereSweepsLoseAndRegainTheWave)
{
  FrequencyResponse response;
  for (const auto &[frequency, is_stable] : std::vector<std::pair<double, bool>>{
           {1., true}, {3., true}, {2.5, false}, {2., false}, {4., true}})
    response.points.push_back({1e-6, frequency, {}, {}, {}, is_stable});
  ASSERT_NE(response.regains(), nullptr);
  EXPECT_EQ(response.regains()->frequency.value, 3.);
  ASSERT_NE(response.loses(), nullptr);
  EXPECT_EQ(response.loses()->frequency.value, 4.);
  for (ResponsePoint &point : response.points)
    point.is_stable = true;
  EXPECT_EQ(response.regains(), nullptr);
  EXPECT_EQ(response.loses(), nullptr);
}
