// SPDX-License-Identifier: LGPL-2.1-or-later

// The stator below its teeth under contact forces. The static compliance of a tooth and the modes
// together reproduce the response of the shifted stiffness K - Omega^2 M of the whole stator with
// all unknowns, between any nodes of the tooth tops; the mode that is left out is the wave.

#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/condensation/condensation.h>
#include <ringmotor/contact/surface_compliance.h>
#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/points/point_finder.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <limits>

using namespace ringmotor;
using namespace ringmotor::tests;
using Complex = std::complex<double>;

namespace
{
  /** All nodes of a surface as contact points. */
  MortarCoupling all_nodes(const SectorSurface &surface)
  {
    MortarCoupling all;
    for (unsigned int i = 0; i < surface.surface.nodes.size(); ++i)
      all.nodes.push_back({i, 1., {{i, 0, 1.}}});
    return all;
  }

  /** Where a node lies on the tops: from the inner to the outer radius, and from the middle to the
   * end of the tooth. */
  struct Place
  {
    double across, around;
  };

  /** Forces on the nodes of a surface in one direction, by node and component. */
  std::vector<double> load(const SectorSurface &top, const unsigned int component,
                           const std::function<double(const Place &)> &force)
  {
    double inner = std::numeric_limits<double>::max(), outer = 0., end = 0.;
    for (const SurfaceNode &node : top.surface.nodes)
    {
      inner = std::min(inner, node.place[0]);
      outer = std::max(outer, node.place[0]);
      end   = std::max(end, node.place[1]);
    }
    std::vector<double> load(3 * top.surface.nodes.size(), 0.);
    for (std::size_t i = 0; i < top.surface.nodes.size(); ++i)
    {
      const auto &place       = top.surface.nodes[i].place;
      load[3 * i + component] = force({(place[0] - inner) / (outer - inner), place[1] / end});
    }
    return load;
  }

  /** Forces on their outer line, even or odd along the tooth. */
  std::vector<double> line_load(const SectorSurface &top, const unsigned int component,
                                const bool is_odd)
  {
    return load(top, component,
                [&](const Place &at) {
                  return at.across < 1. - 1e-6 ? 0. : is_odd ? at.around : 1.;
                });
  }

  /** One of smooth_loads(), which act on the nodes of each half. */
  std::vector<double> smooth_load(const SectorSurface &top, const unsigned int component,
                                  const unsigned int across, const bool is_odd)
  {
    return load(top, component,
                [&](const Place &at)
                {
                  const double of_halves = std::abs(at.around) < 1e-9 ? 2. : 1.;
                  return of_halves * std::pow(at.across, across) * (is_odd ? at.around : 1.);
                });
  }

  /** The work of a load that travels with k waves around a ring on the motions that another one
   * causes. */
  Complex compliance(const RingCompliance &ring, const unsigned int k,
                     const std::vector<double> &load, const std::vector<double> &other)
  {
    const unsigned int n = ring.n_sectors(), width = 3 * ring.n_nodes();
    Complex work = 0.;
    for (const unsigned int part : {0u, 1u})
    {
      std::vector<double> forces(n * width, 0.), motions(n * width, 0.);
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < width; ++i)
          forces[j * width + i] = load[i] * std::cos(2. * M_PI * k * j / n - part * M_PI / 2.);
      ring.add_motions(forces.data(), motions.data());
      // Motions of sector 0 due to cos and sin, the real parts of exp(-i k j alpha) and i times it.
      for (unsigned int i = 0; i < width; ++i)
        work += other[i] * (part == 0 ? Complex(motions[i]) : Complex(0., -motions[i]));
    }
    return work;
  }

  /** What a mode adds to this work at a frequency (rad/s). */
  Complex share(const RingMode &mode, const std::vector<double> &load,
                const std::vector<double> &other, const double frequency)
  {
    Complex of_load = 0., of_other = 0.;
    for (std::size_t i = 0; i < load.size(); ++i)
    {
      of_load += std::conj(mode.motion[i / 3][i % 3]) * load[i];
      of_other += mode.motion[i / 3][i % 3] * other[i];
    }
    const double square = std::pow(mode.angular_frequency, 2);
    if (mode.part == ModePart::tooth)
      return -of_load * of_other / square;
    const bool vibrates = mode.response == ModeResponse::vibrates;
    return of_load * of_other / (square - (vibrates ? frequency * frequency : 0.));
  }
} // namespace

namespace
{
  /** The stator of the reference motor on the coarsest mesh, with and without all unknowns. */
  struct CoarseStator
  {
    const Parameters parameters = reference_motor();
    const StatorWave wave       = stator_wave(parameters);
    const StatorBody body{parameters, 0};
    const MortarCoupling all = all_nodes(body.whole_top);
    const StatorModes stator{parameters, wave, 0, 9};
    const RingModes &modes = stator.at_nodes();
    const dealii::FullMatrix<double> of_tooth =
        sector_compliance(InterfaceCompliance(Condensation(
                              body.tooth, displacement_forms(body.top_of_tooth), {}, {}, 0.)),
                          body.whole_top.origin)
            .at_rest;

    /** The frequency of a harmonic, rad/s, and its nodal diameter. */
    double frequency(const unsigned int m) const { return m * wave.angular_frequency; }
    unsigned int k(const unsigned int m) const
    {
      return nodal_diameter_of_harmonic(parameters.motor, m);
    }

    RingCompliance with_all_unknowns(const unsigned int m) const
    {
      const Condensation shifted(body.sector, displacement_forms(body.top), {}, {},
                                 std::pow(frequency(m), 2));
      const InterfaceCompliance interface(shifted);
      return RingCompliance(
          parameters.motor.n_teeth, sector_compliance(interface, body.whole_top.origin), all,
          [&](const unsigned int diameter) { return interface.through_cut(diameter, {}); });
    }

    double of_tooth_alone(const std::vector<double> &load, const std::vector<double> &other) const
    {
      double work = 0.;
      for (unsigned int i = 0; i < load.size(); ++i)
        for (unsigned int j = 0; j < load.size(); ++j)
          work += other[i] * of_tooth(i, j) * load[j];
      return work;
    }

    /** What the modes add to that. */
    Complex of_modes(const std::vector<double> &load, const std::vector<double> &other,
                     const unsigned int m) const
    {
      Complex work = 0.;
      for (const RingMode &mode : modes[k(m)])
        work += share(mode, load, other, frequency(m));
      return work;
    }
  };
} // namespace

TEST(StatorModes, GiveTheResponseToSmoothForcesAsAllUnknownsDo)
{
  const CoarseStator coarse;
  for (const unsigned int m : {2u, 3u, 6u})
  {
    const RingCompliance ring = coarse.with_all_unknowns(m);
    double error = 0., largest = 0.;
    for (const unsigned int component : {0u, 1u, 2u})
      for (const unsigned int across : {0u, 1u, 3u})
        for (const bool is_odd : {false, true})
        {
          const std::vector<double> load  = smooth_load(coarse.body.whole_top, component, across,
                                                        is_odd),
                                    other = smooth_load(coarse.body.whole_top, 0, 1, is_odd);
          const Complex expected          = compliance(ring, coarse.k(m), load, other),
                        found =
                            coarse.of_tooth_alone(load, other) + coarse.of_modes(load, other, m);
          error   = std::max(error, std::abs(found - expected));
          largest = std::max(largest, std::abs(expected));
        }
    record("error of the response to smooth forces", error / largest);
    EXPECT_LT(error, 1e-9 * largest) << m;
  }
}

TEST(StatorModes, GiveTheResponseToForcesOnTheOuterEdge)
{
  // Forces in contact act on the edge; what the mode of the wave adds is not theirs.
  const CoarseStator coarse;
  for (const unsigned int m : {1u, 2u, 3u, 4u, 6u, 9u})
  {
    const RingCompliance ring = coarse.with_all_unknowns(m);
    for (const unsigned int component : {0u, 1u, 2u})
    {
      // Of an even normal force on the motion along the ring that is odd, as in bending.
      const std::vector<double> load  = line_load(coarse.body.whole_top, component, component == 1),
                                other = line_load(coarse.body.whole_top, 0, false);
      Complex expected                = compliance(ring, coarse.k(m), load, other);
      if (m == 1)
        expected -= share(coarse.stator.driven(), load, other, coarse.frequency(m));
      const double of_tooth = coarse.of_tooth_alone(load, other);
      const Complex added = expected - of_tooth, found = coarse.of_modes(load, other, m);
      record("error of the response at the edge", std::abs(found - added) / std::abs(added));
      EXPECT_LT(std::abs(found - added), 0.02 * std::abs(added)) << m << " " << component;
    }
  }
}

TEST(StatorModes, LeaveOutTheModeThatContactForcesDetune)
{
  // The mode that is left out, with unit mass in a sector, and the wave as the program stator found
  // it on another mesh give the same shift of the frequency by the forces of a point.
  Parameters parameters               = reference_motor();
  parameters.effects["Tooth inertia"] = EffectChoice::on; // the mode has it, too
  const StatorWave wave               = stator_wave(parameters);
  const CondensedMotor motor = condense_motor(parameters, wave, ContactDiscretisation::level(0));
  const ToothBody tooth(parameters, ContactDiscretisation::level(0));
  const StatorModes stator(parameters, wave, 1, 3);
  const StatorBody body(parameters, 1);
  EXPECT_NEAR(stator.driven().angular_frequency, wave.angular_frequency,
              3e-3 * wave.angular_frequency);
  // All its strain is in materials with loss factors.
  EXPECT_GT(stator.driven().loss_factor, parameters.materials.stator_metal.loss_factor);
  EXPECT_LT(stator.driven().loss_factor, parameters.materials.piezoceramic.loss_factor);
  std::vector<SurfaceWeights> weights;
  for (const CondensedMotor::Node &node : motor.nodes)
    weights.push_back(interpolation(body.whole_top.surface, {node.radius, node.angle}));
  const RingMode driven = interpolated(stator.driven(), weights);
  // The amplitude of the mode in the wave.
  Complex product = 0.;
  double square   = 0.;
  for (std::size_t a = 0; a < weights.size(); ++a)
    for (unsigned int c = 0; c < 3; ++c)
    {
      product += std::conj(driven.motion[a][c]) * motor.wave.free_motion[a][c];
      square += std::norm(driven.motion[a][c]);
    }
  const Complex amplitude = product / square;
  const double energy     = 0.25 * motor.n_teeth *
                        std::norm(driven.angular_frequency * amplitude); // of a travelling wave
  EXPECT_NEAR(energy, wave.strain_energy, 0.02 * wave.strain_energy);
  const CurvePoint point = OperatingPointFinder(parameters, motor).find({Control::torque, 0.1});
  double work            = 0.; // of the forces on the rotor in the motion of the mode
  for (std::size_t i = 0; i < point.fields.state.force.size(); ++i)
    for (unsigned int c = 0; c < 3; ++c)
      work += point.fields.state.force[i][c] *
              (amplitude * driven.motion[i % weights.size()][c] *
               std::polar(1., motor.wave.angular_frequency * point.fields.times[0] -
                                  2. * M_PI * motor.n_waves / motor.n_teeth *
                                      static_cast<double>(i / weights.size())))
                  .real();
  record("shift by the mode over that by the wave", work / (4. * energy) / point.result.detuning);
  EXPECT_NEAR(work / (4. * energy), point.result.detuning, 0.02 * point.result.detuning);
}

TEST(StatorCompliance, ShowsTheResonanceOfAModeAtTwiceTheFrequency)
{
  // A mode with 24 waves passes twice the frequency of the wave with 12 as the base grows thicker.
  // Beside it the rotor is slower than on both sides; each state is found.
  std::vector<double> speeds, distances;
  for (const double thickness : {4.8e-3, 5.35e-3, 5.6e-3})
  {
    Parameters parameters                   = reference_motor();
    parameters.motor.n_waves                = 12;
    parameters.stator.base_thickness        = thickness;
    parameters.effects["Stator compliance"] = EffectChoice::on;
    const StatorWave wave                   = stator_wave(parameters);
    const CondensedMotor motor =
        condense_motor(parameters, wave, ContactDiscretisation::level(0), 1);
    distances.push_back(1.);
    for (const RingMode &mode : motor.modes[24])
      if (const double distance = mode.angular_frequency / (2. * wave.angular_frequency) - 1.;
          mode.part == ModePart::stator && std::abs(distance) < std::abs(distances.back()))
        distances.back() = distance;
    const CurvePoint point = OperatingPointFinder(parameters, motor).find({Control::torque, 0.});
    speeds.push_back(point.result.speed / motor.crest_speed());
    record("distance of the resonance", distances.back());
    record("speed without load over that of the crests", speeds.back());
  }
  EXPECT_GT(distances[0], 0.03);
  EXPECT_NEAR(distances[1], 0., 0.02);
  EXPECT_LT(distances[2], -0.03);
  EXPECT_LT(speeds[1], 0.95 * speeds[0]);
  EXPECT_LT(speeds[1], 0.95 * speeds[2]);
}
