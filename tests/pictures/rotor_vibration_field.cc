// SPDX-License-Identifier: LGPL-2.1-or-later

// The interior of a rotor with inertia: forces that travel around the lip with a harmonic of the
// wave move all of its points as a solution with the shifted stiffness K - Omega^2 M does, without
// modes; for a vanishing density (or frequency, which is the same) as a rotor at rest.

#include "support/motor_model.h"

#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/pictures/motor_bodies.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;
using Complex = std::complex<double>;

namespace
{
  const Complex i(0., 1.);

  class RotorVibrationField : public testing::TestWithParam<ElementKind>
  {
  protected:
    RotorVibrationField()
        : parameters(vibrating(GetParam())), wave(driven()),
          mesh(LipModes::discretisation(modes_level)), bodies(parameters, wave, mesh, mesh.degree),
          rotor(parameters, mesh), tooth(parameters, mesh),
          mortar(couple(tooth.whole_top.surface, rotor.whole_lip.surface, pitch, 0.)),
          ring(rotor.sector, mesh.degree)
    {
      const RotorVibration vibration(parameters, wave.angular_frequency);
      motor.n_teeth     = n_teeth;
      motor.modes       = vibration.at(vibration.setting(modes_level), tooth.whole_top.surface, 0.);
      motor.modes_level = modes_level;
    }

    static Parameters vibrating(const ElementKind flange)
    {
      Parameters parameters               = reference_motor();
      parameters.effects["Rotor inertia"] = EffectChoice::on;
      parameters.rotor.flange_element     = flange;
      return parameters;
    }
    static StatorWave driven()
    {
      StatorWave wave;
      wave.angular_frequency = 2. * M_PI * 30e3;
      return wave;
    }

    /** Forces (N) on a contact node of tooth 0 with k waves, symmetric about the tooth's middle. */
    std::array<Complex, 3> force(const unsigned int a, const unsigned int k) const
    {
      const double area  = mortar.nodes[a].area,
                   angle = tooth.whole_top.surface.nodes[mortar.nodes[a].tooth_node].place[1];
      const Complex size = 1e6 * area * std::polar(1., -(k * angle));
      return {{size, 0.3 * i * size, -0.2 * size}};
    }

    /** The fields of a point in which these forces travel with a frequency (rad/s). */
    ContactFields fields(const unsigned int k, const double frequency) const
    {
      ContactFields fields;
      fields.times             = {0.};
      fields.n_repeating_teeth = n_teeth;
      fields.state.rigid.assign(3, 0.);
      for (unsigned int j = 0; j < n_teeth; ++j)
        for (unsigned int a = 0; a < mortar.nodes.size(); ++a)
        {
          fields.state.force.emplace_back();
          for (unsigned int c = 0; c < 3; ++c)
            fields.state.force.back()[c] =
                (force(a, k)[c] * std::polar(1., -(j * k * pitch))).real();
        }
      for (unsigned int other = 0; other < motor.modes.size(); ++other)
        for (const RingMode &mode : motor.modes[other])
        {
          Complex on_mode = 0.;
          for (unsigned int a = 0; other == k && a < mortar.nodes.size(); ++a)
            for (unsigned int c = 0; c < 3; ++c) // the real part is half of two waves
              on_mode += 0.5 * std::conj(mode.motion[a][c]) * force(a, k)[c];
          const double square = std::pow(mode.angular_frequency, 2);
          fields.vibration.push_back(on_mode *
                                     (1. / (square - frequency * frequency) - 1. / square));
        }
      return fields;
    }

    /** The motion of the whole rotor at these frequencies. */
    std::vector<RingBody::Displacement> found(const unsigned int k,
                                              const std::vector<double> &frequencies) const
    {
      std::vector<ContactFields> of_points;
      for (const double frequency : frequencies)
        of_points.push_back(fields(k, frequency));
      std::vector<PointSample> samples;
      for (const ContactFields &fields : of_points)
        samples.push_back({fields, 0, 0.});
      return bodies.rotor_motions(motor, RotorVibration(parameters, wave.angular_frequency),
                                  samples);
    }

    RingBody::Displacement expected(const unsigned int k, const double frequency) const
    {
      // The surface of the whole sector has each node of the half one, and its mirror image.
      const SectorSurface &lip   = rotor.whole_lip;
      const unsigned int n_forms = 3 * rotor.lip.nodes.size();
      CondensationLoad load{std::vector<double>(2 * n_forms, 0.), {}, {}};
      for (unsigned int a = 0; a < mortar.nodes.size(); ++a)
        for (const MortarCoupling::Weight &weight : mortar.nodes[a].weights)
        {
          const auto [node, is_mirrored] = lip.origin[weight.rotor_node];
          if (is_mirrored)
            continue;
          const double half = std::abs(lip.surface.nodes[weight.rotor_node].place[1]) < 1e-9;
          const Complex factor =
              weight.weight * (1. - 0.5 * half) * std::polar(1., weight.sector * k * pitch);
          for (unsigned int c = 0; c < 3; ++c)
          {
            load.forces[3 * node + c] += (factor * force(a, k)[c]).real();
            load.forces[n_forms + 3 * node + c] += (factor * force(a, k)[c]).imag();
          }
        }
      const Condensation shifted(rotor.sector, displacement_forms(rotor.lip), {}, {},
                                 frequency * frequency, /*with_interior =*/true);
      const RingBody::Amplitude amplitude =
          ring.amplitude(shifted.interior(k, {}, {load}).front(), rotor.sector.at_rest());
      RingBody::Displacement displacement = ring.at_rest();
      for (unsigned int j = 0; j < n_teeth; ++j)
        ring.add(j, std::polar(1., -(j * k * pitch)), amplitude, displacement);
      return displacement;
    }

    static double largest(const RingBody::Displacement &one,
                          const RingBody::Displacement &other = {})
    {
      double largest = 0.;
      for (std::size_t p = 0; p < one.size(); ++p)
        largest = std::max(largest, (other.empty() ? one[p] : one[p] - other[p]).norm());
      return largest;
    }

    static constexpr unsigned int n_teeth = 90, modes_level = 2;
    static constexpr double pitch = 2. * M_PI / n_teeth;
    const Parameters parameters;
    const StatorWave wave;
    const ContactDiscretisation mesh;
    const MotorBodies bodies;
    const RotorBody rotor;
    const ToothBody tooth;
    const MortarCoupling mortar;
    const RingBody ring;
    CondensedMotor motor;
  };
} // namespace

TEST_P(RotorVibrationField, IsThatOfTheShiftedStiffness)
{
  for (const unsigned int m : {1u, 3u})
  {
    const unsigned int k   = nodal_diameter_of_harmonic(parameters.motor, m);
    const double frequency = m * wave.angular_frequency;
    const auto motions     = found(k, {0., frequency, 0.02 * frequency, 0.01 * frequency});
    const RingBody::Displacement exact = expected(k, frequency), &at_rest = motions[0];
    EXPECT_GT(largest(at_rest, exact), 0.3 * largest(exact)) << m;
    EXPECT_LT(largest(at_rest, expected(k, 0.)), 1e-9 * largest(at_rest)) << m;
    // Vectors above three times the frequency respond as at rest.
    EXPECT_LT(largest(motions[1], exact), 1e-3 * largest(exact)) << m;
    // In proportion to the density, which is to the square of the frequency
    const double little = largest(motions[2], at_rest), least = largest(motions[3], at_rest);
    EXPECT_LT(little, 1e-2 * largest(at_rest)) << m;
    EXPECT_NEAR(little / least, 4., 1e-2) << m;
  }
}

INSTANTIATE_TEST_SUITE_P(Flange, RotorVibrationField,
                         testing::Values(ElementKind::solid, ElementKind::shell),
                         [](const auto &of)
                         { return of.param == ElementKind::solid ? "Solid" : "Shell"; });
