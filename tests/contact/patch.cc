// SPDX-License-Identifier: LGPL-2.1-or-later

// The patch test: two blocks with non-matching meshes, pressed together (and sheared, with sticking
// contact) between clamped ends. Without lateral contraction (nu = 0) and, where they are sheared,
// with the tractions of a constant shear stress on their sides, stresses are constant:
// p = d / (H_1/E_1 + H_2/E_2) for an approach d of the ends, tau likewise with G = E/2. Linear and
// quadratic elements contain that solution, so it must be reproduced, tractions as force per area.
//
// It is reproduced for flat faces, cut out of a ring of very large radius. On a ring like the
// motor's, the parametrisation of quadratic arcs is not uniform: with half an arc a (rad)
// dtheta/ds = a (1 + a^2 (3 s^2 - 1) / 6), -1 <= s <= 1, against a in the plane of the coupling. To
// order a^2 this leaves a linear cell's forces unchanged, but changes those at the ends of a
// quadratic arc by (a^2/6) (6/5 - 2/3) / (1/3) and the one at its middle by half as much.
//
// A shear stress of constant direction has components along theta and r that change with theta.
// Dual functions of quadratic faces reproduce linear functions, those of linear faces only
// constants: the latter are in error by up to the change over a face of the tooth.

#include "support/elastic_contact.h"
#include "support/record.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;

namespace
{
  const Material soft{70e9, 0., 2700., 0.}, hard{210e9, 0., 7800., 0.};

  constexpr double length = 1e-3;                   ///< m, of the blocks across
  constexpr double depth = 0.8e-3, height = 0.6e-3; ///< m, of the lower and the upper one

  BlockLines scaled(const double radius, BlockLines lines)
  {
    for (double &r : lines.r)
      r = radius + length * r;
    for (double &theta : lines.theta)
      theta *= 0.125 * length / radius;
    return lines;
  }

  BlockLines lower_lines(const double radius)
  {
    return scaled(radius, {{0., 0.3, 0.55, 1.}, {0., 0.5, 1.}, {0., -0.3 * depth, -depth}});
  }

  BlockLines upper_lines(const double radius)
  {
    return scaled(radius,
                  {{0., 0.2, 0.6, 0.8, 1.}, {0., 0.35, 0.7, 1.}, {0., 0.6 * height, height}});
  }

  /** Deviation of tractions and displacements from the constant-stress solution, relative to it. */
  struct Deviation
  {
    double traction = 0., displacement = 0.;
  };

  Deviation deviation(const ElasticContact &contact, const ContactSolution &solution,
                      const ContactSurface &surface, const double pressure, const double shear,
                      const CondensedBlock &lower)
  {
    Deviation found;
    std::vector<double> moved(3 * contact.n_points());
    for (unsigned int i = 0; i < moved.size(); ++i)
    {
      moved[i] = lower.by_side_load[3 * contact.coupling.nodes[i / 3].tooth_node + i % 3];
      for (unsigned int j = 0; j < moved.size(); ++j)
        moved[i] -= contact.of_lower(i, j) * solution.state.force[j / 3][j % 3];
    }
    for (unsigned int a = 0; a < contact.n_points(); ++a)
    {
      const MortarCoupling::Node &node = contact.coupling.nodes[a];
      const double theta               = surface.nodes[node.tooth_node].place[1];
      // On the rotor; the shear stress is along x.
      const PointVector expected({pressure, -shear * std::sin(theta), -shear * std::cos(theta)});
      const PointVector u({-pressure * depth / soft.young_modulus,
                           shear * std::sin(theta) * depth / (0.5 * soft.young_modulus),
                           shear * std::cos(theta) * depth / (0.5 * soft.young_modulus)});
      found.traction =
          std::max(found.traction,
                   (solution.state.force[a] / node.area - expected).norm() / expected.norm());
      const PointVector difference =
          PointVector({moved[3 * a], moved[3 * a + 1], moved[3 * a + 2]}) - u;
      found.displacement = std::max(found.displacement, difference.norm() / u.norm());
    }
    return found;
  }

  Deviation under_pressure(const double radius, const unsigned int degree)
  {
    constexpr double pressure = 5e6; // Pa
    const CondensedBlock lower(lower_lines(radius), soft, degree),
        upper(upper_lines(radius), hard, degree);
    ElasticContact contact(lower, upper);
    for (PointVector &motion : contact.free_motion)
      motion[0] -= pressure * (depth / soft.young_modulus + height / hard.young_modulus);
    const ContactSolution solution = contact.solve(0.);
    EXPECT_TRUE(solution.certificate.holds());
    return deviation(contact, solution, lower.surface(), pressure, 0., lower);
  }

  class Patch : public testing::TestWithParam<unsigned int>
  {
  };
} // namespace

TEST_P(Patch, FlatFacesUnderConstantPressure)
{
  const Deviation found = under_pressure(2e3 * length, GetParam());
  record("relative error of tractions", found.traction);
  record("relative error of displacements", found.displacement);
  EXPECT_LT(found.traction, 1e-10);
  EXPECT_LT(found.displacement, 1e-10);
}

TEST_P(Patch, FlatFacesThatStickUnderConstantShear)
{
  constexpr double radius = 2e3 * length, pressure = 5e6, shear = 1e6;
  const auto on_sides = [&](const Point<3> &x)
  {
    const double r = std::hypot(x[0], x[1]), theta = std::atan2(x[1], x[0]);
    // The x component of the normal: first and last radius, else the side at constant angle
    const double normal = r < radius + 1e-6 * length          ? -std::cos(theta)
                          : r > radius + (1. - 1e-6) * length ? std::cos(theta)
                                                              : -std::sin(theta);
    return std::array<std::complex<double>, 3>{{0., 0., shear * normal}};
  };
  const CondensedBlock lower(lower_lines(radius), soft, GetParam(), 0., 1e300, on_sides),
      upper(upper_lines(radius), hard, GetParam(), 0., 1e300, on_sides);
  ElasticContact contact(lower, upper);
  for (unsigned int a = 0; a < contact.n_points(); ++a)
  {
    const double theta = lower.surface().nodes[contact.coupling.nodes[a].tooth_node].place[1];
    const double shift = shear * 2. * (depth / soft.young_modulus + height / hard.young_modulus);
    contact.free_motion[a] +=
        PointVector({-pressure * (depth / soft.young_modulus + height / hard.young_modulus),
                     shift * std::sin(theta), shift * std::cos(theta)});
  }
  const ContactSolution solution = contact.solve(0.5);
  EXPECT_EQ(std::count(solution.status.begin(), solution.status.end(), PointStatus::stick),
            contact.n_points());
  const Deviation found = deviation(contact, solution, lower.surface(), pressure, shear, lower);
  record("relative error of tractions", found.traction);
  record("relative error of displacements", found.displacement);
  const double face_angle = 0.5 * 0.125 * length / radius;
  EXPECT_LT(found.traction, GetParam() == 1 ? shear / pressure * face_angle : 1e-10);
  EXPECT_LT(found.displacement, GetParam() == 1 ? shear / pressure * face_angle : 1e-10);
}

TEST_P(Patch, FacesOfARingUnderConstantPressure)
{
  for (const double radius : {34. * length, 340. * length})
  {
    const Deviation found = under_pressure(radius, GetParam());
    record("relative error of tractions, radius 34, 340 times the length", found.traction);
    const double half_arc = 0.25 * 0.125 * length / radius;
    EXPECT_LT(found.traction, GetParam() == 1 ? 1e-10 : 0.3 * half_arc * half_arc);
  }
}

INSTANTIATE_TEST_SUITE_P(Degree, Patch, testing::Values(1u, 2u));
