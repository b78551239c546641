// SPDX-License-Identifier: LGPL-2.1-or-later

// Recovery of the whole rotor and teeth from the contact nodes: where bodies touch they move as in
// the operating point, which does not involve their interior: teeth at their nodes, the rotor in
// the weighted mean of the mortar method. (For the interior recovery itself see
// tests/condensation/condensation.cc.)

#include "support/motor_model.h"

#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/pictures/motor_bodies.h>
#include <ringmotor/points/point_finder.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;

namespace
{
  /** Normal, along -theta, radial. */
  PointVector along_axes(const dealii::Tensor<1, 3> &u, const double theta)
  {
    PointVector result;
    result[0] = u[2];
    result[1] = u[0] * std::sin(theta) - u[1] * std::cos(theta);
    result[2] = u[0] * std::cos(theta) + u[1] * std::sin(theta);
    return result;
  }

  PointVector motion_at(const RingBody &body, const RingBody::Displacement &displacement,
                        const double r, const double theta, const double z)
  {
    const auto point = body.point_at(Point<3>(r * std::cos(theta), r * std::sin(theta), z));
    if (!point)
    {
      ADD_FAILURE() << "no point at r = " << r << ", theta = " << theta;
      return {};
    }
    return along_axes(displacement[*point], theta);
  }

  /** The motion of the rotor at a contact point: that of the whole body in the mean of the mortar
   * method. @param angle rad, of the tooth and the lip's turn; @param height m, of the contact */
  PointVector rotor_at(const MortarCoupling::Node &node, const SectorSurface &lip,
                       const RingBody &rotor, const RingBody::Displacement &displacement,
                       const double angle, const double pitch, const double height)
  {
    PointVector motion;
    for (const MortarCoupling::Weight &weight : node.weights)
    {
      const auto &place = lip.surface.nodes[weight.rotor_node].place;
      motion += weight.weight * motion_at(rotor, displacement, place[0],
                                          place[1] + angle + weight.sector * pitch, height);
    }
    return motion;
  }

  /** With modes of elements of the same degree, on a mesh of the lip that is no finer, before
   * contain_modes(): nothing of them is lost. Without those for error bars. */
  CondensedMotor with_modes(const Parameters &parameters, const StatorWave &wave,
                            const ContactDiscretisation &discretisation)
  {
    const MotorModel model = motor_model(parameters);
    const ToothBody tooth(parameters, discretisation);
    const RotorVibration vibration(parameters, wave.angular_frequency);
    const auto modes = [&] {
      return vibration.at(vibration.setting(1), tooth.whole_top.surface, discretisation.lip_turn);
    };
    if (model.rotor_moves_as_whole)
    {
      CondensedMotor motor =
          condense_motor(parameters, wave, discretisation, 1, nullptr, ModeSets::own);
      motor.modes = modes();
      return motor;
    }
    Parameters without               = parameters;
    without.effects["Rotor inertia"] = without.effects["Damping"] = EffectChoice::off;
    CondensedMotor motor = condense_motor(without, wave, discretisation);
    if (model.rotor_needs_modes())
    {
      motor.modes       = modes();
      motor.modes_level = 1;
      motor.dynamics    = {model.rotor_loss_factor, InertiaScheme::second_order(0.8),
                           !model.rotor_vibrates};
    }
    return motor;
  }

  constexpr double rounding = 1e-9;

  void expect_bodies_follow(const Parameters &parameters, const StatorWave &wave,
                            const CondensedMotor &motor, const PointRequest &request,
                            const ContactDiscretisation &discretisation,
                            const double of_rotor_within = rounding)
  {
    const ContactFields fields = OperatingPointFinder(parameters, motor).find(request).fields;
    const unsigned int last    = fields.times.size() - 1;
    const MotorBodies bodies(parameters, wave, discretisation, motor.degree, MPI_COMM_WORLD);
    const RotorVibration vibration(parameters, wave.angular_frequency, MPI_COMM_WORLD);
    if (motor.has_modes_of(ModePart::rotor)) // kept, unless they are those of all frequencies
      vibration.prepare(motor.modes_level, ModeSets::own);
    const RingBody::Displacement
        rotor =
            bodies.rotor_motions(motor, vibration, {{fields, last, motor.wave.amplitude}}).front(),
        teeth = bodies.teeth_motions({{fields, last, motor.wave.amplitude}}).front();

    const ToothBody tooth_body(parameters, discretisation);
    const RotorBody rotor_body(parameters, discretisation);
    const MortarCoupling mortar = couple(tooth_body.whole_top.surface, rotor_body.whole_lip.surface,
                                         motor.pitch(), discretisation.lip_turn);
    const double top            = parameters.stator.base_thickness + parameters.stator.tooth_height;
    double tooth_error = 0., rotor_error = 0., largest = 0.;
    for (unsigned int tooth = 0; tooth < motor.n_teeth; ++tooth)
      for (unsigned int a = 0; a < motor.nodes.size(); ++a)
      {
        const std::size_t i = (last * fields.n_repeating_teeth + tooth % fields.n_repeating_teeth) *
                                  motor.nodes.size() +
                              a;
        const PointVector of_tooth = motion_at(bodies.teeth(), teeth, motor.nodes[a].radius,
                                               motor.nodes[a].angle + tooth * motor.pitch(), top);
        const PointVector of_rotor =
            rotor_at(mortar.nodes[a], rotor_body.whole_lip, bodies.rotor(), rotor,
                     discretisation.lip_turn + tooth * motor.pitch(), motor.pitch(), top);
        largest     = std::max(largest, fields.rotor[i].norm());
        tooth_error = std::max(tooth_error, (of_tooth - fields.tooth[i]).norm());
        rotor_error = std::max(rotor_error, (of_rotor - fields.rotor[i]).norm());
      }
    EXPECT_GT(largest, 1e-7);
    EXPECT_LT(tooth_error, rounding * largest);
    EXPECT_LT(rotor_error, of_rotor_within * largest);
  }

  void expect_bodies_follow(const Parameters &parameters, const StatorWave &wave,
                            const PointRequest &request,
                            const ContactDiscretisation &discretisation)
  {
    expect_bodies_follow(parameters, wave, with_modes(parameters, wave, discretisation), request,
                         discretisation);
  }

  ContactDiscretisation coarse()
  {
    return ContactDiscretisation::level(0);
  }
} // namespace

TEST(MotorBodies, MoveAsTheirContactPointsDo)
{
  Parameters parameters        = reference_motor();
  const StatorWave wave        = stator_wave(parameters);
  ContactDiscretisation turned = coarse();
  turned.lip_turn              = 0.3 * 2. * M_PI / parameters.motor.n_teeth;
  expect_bodies_follow(parameters, wave, {Control::torque, 0.05}, coarse());
  parameters.rotor.flange_element = ElementKind::shell;
  expect_bodies_follow(parameters, wave, {Control::torque, 0.05}, turned);
}

TEST(MotorBodies, TouchAStatorThatSinks)
{
  // The stator of the disc motor sinks under the preload, which its picture does not show: the
  // rotor is drawn relative to it. Waves around the ring, which it does not show either, have no
  // mean.
  Parameters parameters = read_parameters(RINGMOTOR_SOURCE_DIR "/prm/disc60.prm");
  for (const std::string off : {"Rotor inertia", "Tooth vibration", "Damping"})
    parameters.effects[off] = EffectChoice::off;
  const StatorWave wave      = stator_wave(parameters);
  const CondensedMotor motor = condense_motor(parameters, wave, coarse(), 1);
  const ContactFields fields =
      OperatingPointFinder(parameters, motor).find({Control::speed, 0.}).fields;
  const MotorBodies bodies(parameters, wave, coarse(), motor.degree);
  const RingBody::Displacement rotor =
      bodies
          .rotor_motions(motor, RotorVibration(parameters, wave.angular_frequency),
                         {{fields, 0, motor.wave.amplitude}})
          .front();
  const ToothBody tooth_body(parameters, coarse());
  const RotorBody rotor_body(parameters, coarse());
  const MortarCoupling mortar = couple(tooth_body.whole_top.surface, rotor_body.whole_lip.surface,
                                       motor.pitch(), coarse().lip_turn);
  const double height         = stator_shape(parameters)->contact_line().highest;
  double apart = 0., sunk = 0.; // m, means
  const std::size_t n = fields.n_repeating_teeth * motor.nodes.size();
  for (unsigned int tooth = 0; tooth < fields.n_repeating_teeth; ++tooth)
    for (unsigned int a = 0; a < motor.nodes.size(); ++a)
    {
      const std::size_t i = fields.point(0, tooth, a);
      apart += (rotor_at(mortar.nodes[a], rotor_body.whole_lip, bodies.rotor(), rotor,
                         tooth * motor.pitch(), motor.pitch(), height)[0] -
                fields.rotor[i][0]) /
               n;
      sunk += fields.modal[i][0] / n;
    }
  EXPECT_GT(sunk, 1e-5);
  EXPECT_LT(std::abs(apart), 1e-8 * sunk);
}

TEST(MotorBodies, TiltAndStandOnWarpedTeeth)
{
  Parameters parameters                    = reference_motor();
  parameters.initial_deformation.amplitude = 4e-6;
  parameters.initial_deformation.n_waves   = 1;
  parameters.time.time_step                = 2e-6;
  parameters.accuracy.contact_target       = 0.5;
  // Enough for the motion to settle whatever the rounding: pictures have to follow it, not to find
  // it.
  parameters.materials.rotor_metal.loss_factor = 0.1;
  const StatorWave wave                        = stator_wave(parameters);
  for (const double bars : {0., 1e9})
  {
    parameters.rotor.radial_bar_stiffness = bars;
    expect_bodies_follow(parameters, wave, {Control::speed, 8.}, coarse());
  }
}

TEST(MotorBodies, RepeatThemselvesWithTheWave)
{
  Parameters parameters            = reference_motor();
  parameters.motor.n_waves         = 9;
  parameters.modes.nodal_diameters = {9};
  expect_bodies_follow(parameters, stator_wave(parameters), {Control::torque, 0.05}, coarse());
}

TEST(MotorBodies, VibrateAsTheirContactPointsDo)
{
  Parameters parameters               = reference_motor();
  parameters.effects["Rotor inertia"] = EffectChoice::on;
  parameters.effects["Damping"]       = EffectChoice::on;
  const StatorWave wave               = stator_wave(parameters);
  expect_bodies_follow(parameters, wave, {Control::torque, 0.05}, coarse());
  ContactDiscretisation turned        = coarse();
  turned.lip_turn                     = 0.3 * 2. * M_PI / parameters.motor.n_teeth;
  parameters.rotor.flange_element     = ElementKind::shell;
  parameters.effects["Rotor inertia"] = EffectChoice::off; // hysteretic damping alone
  expect_bodies_follow(parameters, wave, {Control::torque, 0.05}, turned);
}

TEST(MotorBodies, VibrateCloseToTheirContactPointsWithFineModes)
{
  // Modes are drawn as they are on their mesh, contact has those that its coarser one contains.
  Parameters parameters = reference_motor();
  for (const std::string on : {"Rotor inertia", "Tooth inertia", "Tooth vibration"})
    parameters.effects[on] = EffectChoice::on;
  const StatorWave wave             = stator_wave(parameters);
  constexpr unsigned int fine_modes = 2;
  constexpr double nearly           = 0.01;
  const auto mesh                   = ContactDiscretisation::level(1);
  expect_bodies_follow(parameters, wave,
                       condense_motor(parameters, wave, mesh, fine_modes, nullptr, ModeSets::own),
                       {Control::torque, 0.05}, mesh, nearly);
}

TEST(MotorBodies, VibrateWithARepeatingWave)
{
  Parameters parameters               = reference_motor();
  parameters.effects["Rotor inertia"] = EffectChoice::on;
  parameters.motor.n_waves            = 9;
  parameters.modes.nodal_diameters    = {9};
  expect_bodies_follow(parameters, stator_wave(parameters), {Control::torque, 0.05}, coarse());
}

TEST(MotorBodies, BounceOnWarpedTeeth)
{
  Parameters parameters                    = reference_motor();
  parameters.motor.n_teeth                 = 30;
  parameters.effects["Rotor inertia"]      = EffectChoice::on;
  parameters.effects["Damping"]            = EffectChoice::on;
  parameters.initial_deformation.amplitude = 2e-6;
  parameters.initial_deformation.n_waves   = 1;
  parameters.time.time_step                = 2e-6;
  parameters.accuracy.contact_target       = 0.5;
  // Enough for the motion to settle whatever the rounding: pictures have to follow it, not to find
  // it.
  parameters.materials.rotor_metal.loss_factor = 0.1;
  expect_bodies_follow(parameters, stator_wave(parameters), {Control::speed, 8.}, coarse());
}

TEST(MotorBodies, FillTheRing)
{
  const Parameters parameters = reference_motor();
  const StatorWave wave;
  const MotorBodies bodies(parameters, wave, coarse(), 4);
  const std::vector<Point<3>> &x = bodies.rotor().points();
  double volume                  = 0.;
  for (const auto &cell : bodies.rotor().cells())
  {
    std::array<dealii::Tensor<1, 3>, 3> edge; // the mean of four
    for (unsigned int v = 0; v < 8; ++v)
      for (unsigned int d = 0; d < 3; ++d)
        edge[d] += ((v >> d) & 1 ? 0.25 : -0.25) * dealii::Tensor<1, 3>(x[cell[v]]);
    const double of_cell = cross_product_3d(edge[0], edge[1]) * edge[2];
    EXPECT_GT(of_cell, 0.);
    volume += of_cell;
  }
  const RotorGeometry &rotor = parameters.rotor;
  const auto ring            = [](const double inner, const double outer, const double height)
  { return M_PI * (outer * outer - inner * inner) * height; };
  const double expected =
      ring(rotor.ring_inner_radius, rotor.ring_outer_radius,
           rotor.ring_upper_face - rotor.ring_lower_face) +
      ring(rotor.lip_inner_radius, rotor.ring_inner_radius, rotor.flange_thickness);
  EXPECT_NEAR(volume / expected, 1., 1e-3); // arcs are polygons
}
