// SPDX-License-Identifier: LGPL-2.1-or-later

// The gap between the faces in contact at rest. A crowned and a roof-shaped lip, drawn in the
// section of a thick rotor, press on thick teeth as Hertz (1882) and the closed form of a wedge on
// a half-plane (Johnson, Contact Mechanics, 5.2) say for line contact; lapped faces carry their
// preload evenly, exactly.

#include "mesh/section_text.h"
#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/contact/friction_law.h>
#include <ringmotor/contact/solve/contact_solver.h>
#include <ringmotor/mesh/check_contact.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/ring_contact.h>
#include <ringmotor/parameters/errors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  /** Blocks of a height (m) from z = @p low between columns at these radii. */
  Section columns(const std::vector<double> &radii, const double low, const double high,
                  const dealii::types::material_id part)
  {
    Section section;
    for (const double z : {low, high})
      for (const double r : radii)
        section.points.emplace_back(r, z);
    const unsigned int n = radii.size();
    for (unsigned int i = 0; i + 1 < n; ++i)
      section.cells.push_back({{{i, i + 1, n + i + 1, n + i}}, part});
    return section;
  }

  constexpr double inner = 28e-3, middle = 33e-3, outer = 38e-3, half_lip = 0.6e-3;

  /** Steel blocks: teeth 6 mm high, and a rotor of the same height whose lip, in the middle of its
   * lower face, has a profile (m, over the distance from its middle). */
  Parameters thick_motor(const Scratch &scratch, const std::function<double(double)> &profile)
  {
    Parameters parameters             = reference_motor();
    parameters.motor.n_teeth          = 12;
    parameters.stator.slot_width      = 0.;
    parameters.stator.slot_angle      = 1e-3;
    parameters.materials.stator_metal = parameters.materials.rotor_metal = {200e9, 0.3, 7800., 0.};
    parameters.rotor.radial_bar_stiffness                                = 0.;

    Section stator = columns({inner, outer}, 0., 6e-3, ids::base),
            tooth  = columns({inner, outer}, 6e-3, 12e-3, ids::tooth);
    stator.points.insert(stator.points.end(), tooth.points.begin() + 2, tooth.points.end());
    stator.cells.push_back({{{2, 3, 5, 4}}, ids::tooth});
    stator.names[Section::edge(4, 5)] = ids::tooth_top;
    stator.names[Section::edge(0, 1)] = ids::clamped;
    parameters.stator.section_file =
        SectionText(stator, names_of_stator()).write(scratch, "stator.msh");

    constexpr unsigned int n = 48;
    std::vector<double> radii{inner};
    for (unsigned int i = 0; i <= n; ++i)
      radii.push_back(middle + half_lip * (2. * i / n - 1.));
    radii.push_back(outer);
    Section rotor         = columns(radii, 0., 6e-3, ids::rotor);
    const unsigned int up = radii.size();
    for (unsigned int i = 0; i + 1 < up; ++i)
    {
      rotor.names[Section::edge(up + i, up + i + 1)] = ids::ring_top;
      if (i > 0 && i <= n)
        rotor.names[Section::edge(i, i + 1)] = ids::lip;
      if (i > 0)
        rotor.points[i][1] = profile(radii[i] - middle);
    }
    rotor.names[Section::edge(0, up)] = ids::ring_bore;
    parameters.rotor.section_file =
        SectionText(rotor, names_of_rotor()).write(scratch, "rotor.msh");
    return parameters;
  }

  /** No wave. */
  StatorWave at_rest(const Parameters &parameters)
  {
    StatorWave wave;
    wave.n_waves           = parameters.motor.n_waves;
    wave.angular_frequency = 1e5;
    wave.foot =
        wave.top = [](const dealii::Point<3> &) { return std::array<std::complex<double>, 3>(); };
    return wave;
  }

  /** Pressure (Pa) over the distance (m) from the middle of the lip, along the middle of a tooth,
   * under a preload (N) without friction. */
  std::vector<std::pair<double, double>> pressures(const CondensedMotor &motor,
                                                   const double preload)
  {
    const TimeStep at_rest{0., 1e-5, std::vector<PointVector>(motor.n_teeth * motor.nodes.size())};
    const MotorInUse in_use(motor);
    const RingContact contact(in_use, {preload, {}}, at_rest, Warp());
    const ContactState state =
        solve_without_friction(contact, motor.constants, contact.pressed_down()).state;
    std::vector<std::pair<double, double>> pressures;
    for (std::size_t a = 0; a < motor.nodes.size(); ++a)
      if (std::abs(motor.nodes[a].angle) < 1e-9)
        pressures.emplace_back(motor.nodes[a].radius - middle,
                               state.force[a][0] / motor.nodes[a].area);
    std::sort(pressures.begin(), pressures.end());
    return pressures;
  }

  /** Even cells across the lip. */
  ContactDiscretisation fine()
  {
    ContactDiscretisation mesh;
    mesh.degree = 2;
    mesh.tooth = mesh.lip = {12, 1, 1.};
    mesh.rotor            = {0.25, 0.3, 0.6};
    return mesh;
  }

  const double modulus = 200e9 / (2. * (1. - 0.3 * 0.3)); ///< E*, Pa, of both bodies

  /** By which a level lip turns under an evenly spread preload, per N: the slope of the gap that
   * keeps it level instead. */
  double slope_by_roll()
  {
    const Scratch scratch;
    const Parameters parameters = thick_motor(scratch, [](const double) { return 0.; });
    const CondensedMotor motor  = condense_motor(parameters, at_rest(parameters), fine());
    double product = 0., square = 0.;
    for (std::size_t a = 0; a < motor.nodes.size(); ++a)
    {
      const double x = motor.nodes[a].radius - middle;
      product += motor.nodes[a].area * x * motor.gap.deflection[a];
      square += motor.nodes[a].area * x * x;
    }
    return product / square;
  }

  /** The largest difference between pressures under a line load (N/m) on a lip with a profile and
   * the expected ones, from 0.2 to 0.7 of the half width (m) of contact; none may act beyond 1.3 of
   * it. */
  double error_of_pressures(const std::function<double(double)> &profile, const double line_load,
                            const std::function<double(double)> &expected, const double half_width)
  {
    const double preload = 2. * M_PI * middle * line_load, roll = preload * slope_by_roll();
    const Scratch scratch;
    const Parameters parameters =
        thick_motor(scratch, [&](const double x) { return profile(x) - roll * x; });
    const CondensedMotor motor = condense_motor(parameters, at_rest(parameters), fine());
    const auto found           = pressures(motor, preload);
    double error               = 0.;
    for (std::size_t i = 1; i + 1 < found.size(); ++i)
    {
      // Nodes at the ends and in the middle of quadratic faces have different errors.
      const double x    = found[i].first,
                   mean = 0.25 * found[i - 1].second + 0.5 * found[i].second +
                          0.25 * found[i + 1].second,
                   share = std::abs(x) / half_width;
      if (share > 0.2 && share < 0.7)
        error = std::max(error, std::abs(mean - expected(x)));
      if (share > 1.3)
      {
        EXPECT_EQ(mean, 0.) << x;
      }
    }
    return error;
  }
} // namespace

TEST(RestGapLong, OfACrownGivesThePressureOfHertz)
{
  constexpr double crown = 0.1, half_width = 0.3e-3; // m
  const double line_load = M_PI * modulus * half_width * half_width / (4. * crown),
               most      = 2. * line_load / (M_PI * half_width);
  const double error     = error_of_pressures(
      [](const double x) { return x * x / (2. * crown); }, line_load,
      [&](const double x) { return most * std::sqrt(1. - std::pow(x / half_width, 2)); },
      half_width);
  record("error of the pressure over the largest one", error / most);
  EXPECT_LT(error, 0.04 * most);
}

TEST(RestGapLong, OfARoofGivesThePressureOfAWedge)
{
  constexpr double slope = 2e-3, half_width = 0.3e-3;
  const double unit  = modulus * slope / M_PI; // the pressure is infinite at the ridge
  const double error = error_of_pressures(
      [](const double x) { return slope * std::abs(x); }, modulus * slope * half_width,
      [&](const double x) { return unit * std::acosh(half_width / std::abs(x)); }, half_width);
  record("error of the pressure over E* times the slope over pi", error / unit);
  EXPECT_LT(error, 0.06 * unit);
}

TEST(RestGap, OfLappedFacesSpreadsThePreloadEvenly)
{
  Parameters parameters    = reference_motor();
  parameters.contact.faces = ContactFaces::lapped;
  const double preload     = parameters.loading.preload;
  for (const unsigned int level : {0u, 1u})
  {
    const CondensedMotor motor =
        condense_motor(parameters, at_rest(parameters), ContactDiscretisation::level(level));
    EXPECT_LT(motor.gap.unevenness(preload), 1e-16);
    double area = 0.;
    for (const CondensedMotor::Node &node : motor.nodes)
      area += motor.n_teeth * node.area;
    for (const auto &[x, pressure] : pressures(motor, preload))
      EXPECT_NEAR(pressure * area / preload, 1., 1e-6) << x;
  }
  parameters.contact.faces = ContactFaces::drawn;
  const CondensedMotor level =
      condense_motor(parameters, at_rest(parameters), ContactDiscretisation::level(0));
  EXPECT_GT(level.gap.unevenness(preload), 1e-8);
  EXPECT_NEAR(level.gap.unevenness(2. * preload) / level.gap.unevenness(preload), 2., 1e-9);
}

TEST(RestGap, IsOfFacesThatAreNearlyLevel)
{
  const Scratch scratch;
  const Parameters deep = thick_motor(scratch, [](const double x) { return 0.3 * std::abs(x); });
  const std::string message = message_of<UserError>([&]() { check_bodies_in_contact(deep); });
  EXPECT_NE(message.find("the curve 'contact' reaches from z = 0 mm to 0.18 mm"), std::string::npos)
      << message;
}
