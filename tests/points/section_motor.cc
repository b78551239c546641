// SPDX-License-Identifier: LGPL-2.1-or-later

// A motor whose bodies are read from sections is the motor of the dimensions that these were
// written from: the same contact points, compliance and operating point to rounding. The loss
// factor of a rotor of several materials lies between theirs, and is exact where the parts do not
// differ.

#include "mesh/section_text.h"
#include "support/motor_model.h"

#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/mesh/check_contact.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/rotor_loss.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/points/point_finder.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  /** The same motor with sections in files of the folder. */
  Parameters with_sections(const Parameters &motor, const Scratch &scratch)
  {
    const unsigned int n_teeth = motor.motor.n_teeth;
    Parameters parameters      = motor;
    parameters.stator.section_file =
        SectionText(stator_body(motor.stator, n_teeth).section, names_of_stator())
            .write(scratch, "stator.msh");
    parameters.rotor.section_file =
        SectionText(rotor_body(motor.rotor, n_teeth).section, names_of_rotor())
            .write(scratch, "rotor.msh");
    // Only the files count.
    parameters.stator.base_thickness = parameters.stator.tip_outer_radius = 1.;
    parameters.rotor.lip_inner_radius = parameters.rotor.ring_outer_radius = 1.;
    return parameters;
  }

  /** The motion of the rotor's and the teeth's contact points under forces on one tooth. */
  std::vector<double> motions(const CondensedMotor &motor)
  {
    std::vector<double> forces(3 * motor.nodes.size() * motor.n_teeth), motions(forces.size());
    for (unsigned int i = 0; i < 3 * motor.nodes.size(); ++i)
      forces[i] = 1. + 0.1 * i;
    motor.compliance.add_motions(forces.data(), motions.data());
    return motions;
  }
} // namespace

TEST(SectionMotor, IsThatOfItsDimensions)
{
  const Scratch scratch;
  Parameters motor          = reference_motor();
  const StatorWave wave     = stator_wave(motor);
  const Parameters sections = with_sections(motor, scratch);
  EXPECT_NO_THROW(check_bodies_in_contact(sections));
  Parameters mixed = sections;
  mixed.rotor      = motor.rotor;
  EXPECT_NO_THROW(check_bodies_in_contact(mixed));
  mixed.rotor.lip_inner_radius = 40e-3;
  mixed.rotor.lip_outer_radius = 41e-3;
  const std::string message    = message_of<UserError>([&]() { check_bodies_in_contact(mixed); });
  EXPECT_NE(message.find("Rotor/Lip inner radius = 0.04 m to Rotor/Lip outer radius = 0.041 m, and "
                         "the curve 'contact' of Stator/Section file = \""),
            std::string::npos)
      << message;
  EXPECT_EQ(rotor_loss_factor(sections), motor.materials.rotor_metal.loss_factor);
  for (const unsigned int level : {0u, 2u})
  {
    const ContactDiscretisation mesh = ContactDiscretisation::level(level);
    const CondensedMotor one         = condense_motor(motor, wave, mesh),
                         other       = condense_motor(sections, wave, mesh);
    ASSERT_EQ(one.nodes.size(), other.nodes.size());
    EXPECT_EQ(one.n_dofs, other.n_dofs);
    for (std::size_t i = 0; i < one.nodes.size(); ++i)
    {
      EXPECT_NEAR(one.nodes[i].radius, other.nodes[i].radius, 1e-14);
      EXPECT_NEAR(one.nodes[i].area / other.nodes[i].area, 1., 1e-9);
      for (unsigned int c = 0; c < 3; ++c)
        EXPECT_LT(std::abs(one.wave.free_motion[i][c] - other.wave.free_motion[i][c]),
                  1e-9 * wave.amplitude);
    }
    const std::vector<double> a = motions(one), b = motions(other);
    double largest = 0.;
    for (const double motion : a)
      largest = std::max(largest, std::abs(motion));
    for (std::size_t i = 0; i < a.size(); ++i)
      EXPECT_NEAR(a[i], b[i], 1e-9 * largest);
    if (level > 0)
      continue;
    const auto at_work = [](const Parameters &parameters, const CondensedMotor &of) {
      return OperatingPointFinder(parameters, of).find({Control::torque, 0.05});
    };
    const CurvePoint point = at_work(motor, one), other_point = at_work(sections, other);
    EXPECT_NEAR(point.result.speed / other_point.result.speed, 1., 1e-9);
    EXPECT_NEAR(point.result.tangential_loss / other_point.result.tangential_loss, 1., 1e-9);
    EXPECT_NEAR(point.rotor_power / other_point.rotor_power, 1., 1e-9);
  }
}

TEST(SectionMotor, TellsWhereItsBodiesTouch)
{
  Parameters motor = reference_motor();
  for (const ElementKind flange : {ElementKind::solid, ElementKind::shell})
  {
    motor.rotor.flange_element = flange;
    const ContactLine lip      = contact_line(rotor_body(motor));
    EXPECT_EQ(lip.radii.inner, motor.rotor.lip_inner_radius);
    EXPECT_EQ(lip.radii.outer, motor.rotor.lip_outer_radius);
    EXPECT_NEAR(lip.lowest, 0., 1e-15);
    EXPECT_NEAR(rise_to_contact(*rotor_shape(motor), *stator_shape(motor)),
                motor.stator.base_thickness + motor.stator.tooth_height, 1e-15);
  }
  for (const ElementKind ceramic : {ElementKind::solid, ElementKind::shell})
  {
    motor.stator.piezoceramic_element      = ceramic;
    const std::vector<RadialRange> on_felt = radii_on_felt(stator_body(motor));
    ASSERT_EQ(on_felt.size(), 1u);
    EXPECT_EQ(on_felt.front().inner, motor.stator.base_inner_radius);
    EXPECT_EQ(on_felt.front().outer, motor.stator.base_outer_radius);
  }
}

TEST(SectionMotor, LosesInAllPartsOfItsRotor)
{
  Parameters motor;
  motor.motor                      = {"", 9, 90};
  motor.rotor.section_file         = RINGMOTOR_SOURCE_DIR "/meshes/disc60_rotor.msh";
  motor.rotor.radial_bar_stiffness = 0.;
  Material &metal = motor.materials.rotor_metal, &lining = motor.materials.lining;
  metal  = {68.9e9, 0.33, 2700., 1e-3};
  lining = {2e9, 0.35, 1500., 1e-3};
  EXPECT_NEAR(rotor_loss_factor(motor), 1e-3, 1e-15);
  lining.loss_factor       = 3e-2;
  const double with_lining = rotor_loss_factor(motor);
  EXPECT_GT(with_lining, 2e-3);
  EXPECT_LT(with_lining, 3e-2);
  EXPECT_EQ(largest_rotor_loss_factor(motor), 3e-2);
  lining.young_modulus = 2e6; // nearly all energy in the lining
  EXPECT_NEAR(rotor_loss_factor(motor), 3e-2, 1e-3);
  lining.poisson_ratio = metal.poisson_ratio;
  lining.young_modulus = metal.young_modulus; // a small part of the ring
  EXPECT_LT(rotor_loss_factor(motor), with_lining);
}
