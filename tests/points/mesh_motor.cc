// SPDX-License-Identifier: LGPL-2.1-or-later

// A motor whose bodies are read from meshes of half a sector is the motor of the sections that
// these meshes were revolved from, to rounding: the same contact points, compliances and modes. Cut
// as finer levels cut it, it comes close to the section that is divided anew.

#include "mesh/named_sector.h"
#include "mesh/section_text.h"
#include "support/paper_motor.h"

#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/mesh/check_contact.h>
#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/rotor_loss.h>
#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/wave/body_modes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  constexpr double top_of_base = 3e-3, top = 5e-3; // m

  /** A ring with teeth from r = 20 to 26 mm. */
  SectionText stator_section()
  {
    SectionText text;
    for (const double z : {0., top_of_base, top})
      for (const double r : {20e-3, 26e-3})
        text.points.emplace_back(r, z);
    text.elements = {{3, "base", {0, 1, 3, 2}}, {3, "tooth", {2, 3, 5, 4}}, {1, "contact", {4, 5}}};
    return text;
  }

  /** A ring with a lining below, from r = 20 to 24 mm, that bars hold. */
  SectionText rotor_section()
  {
    SectionText text = ring_on_web(8e-3);
    text.elements.push_back({1, "bars", {3, 7}});
    return text;
  }

  /** The motor of these sections, with radial slots, in which cells are straight in theta. */
  Parameters section_motor(const Scratch &scratch)
  {
    Parameters motor          = paper_motor();
    motor.motor               = {"", 4, 30};
    motor.stator.section_file = stator_section().write(scratch, "stator.msh");
    motor.rotor.section_file  = rotor_section().write(scratch, "rotor.msh");
    motor.stator.slot_angle   = 0.06;
    motor.support             = {};
    motor.materials.lining    = {2e9, 0.35, 1500., 3e-2};
    return motor;
  }

  StatorWave some_wave()
  {
    StatorWave wave;
    wave.n_waves           = 4;
    wave.angular_frequency = 2e5;
    wave.amplitude         = 1e-6;
    wave.foot = wave.top = [](const dealii::Point<3> &x)
    {
      const double theta = std::atan2(x[1], x[0]);
      const std::complex<double> around(std::cos(4. * theta), -std::sin(4. * theta));
      return std::array<std::complex<double>, 3>{
          {1e-7 * around, std::complex<double>(0., 4e-7) * around, 1e-6 * around}};
    };
    return wave;
  }

  /** The different values of a coordinate of a mesh's vertices in (r, theta, z), ascending. */
  std::vector<double> lines_of(const SectorMesh &mesh, const unsigned int coordinate)
  {
    std::vector<double> lines;
    for (const dealii::Point<3> &vertex : mesh.triangulation->get_vertices())
      lines.push_back(cylindrical(vertex)[coordinate]);
    std::sort(lines.begin(), lines.end());
    const auto are_same = [](const double a, const double b) { return b - a < 1e-9; };
    lines.erase(std::unique(lines.begin(), lines.end(), are_same), lines.end());
    return lines;
  }

  /** A stator with the cells of a tooth, and what is below it. */
  NamedSector stator_below(const SectorMesh &tooth, const unsigned int n_teeth)
  {
    std::array<std::vector<double>, 3> lines{
        {lines_of(tooth, 0), lines_of(tooth, 1), lines_of(tooth, 2)}};
    const int n_in_tooth = static_cast<int>(lines[1].size()) - 1;
    lines[1].push_back(M_PI / n_teeth);
    lines[2].insert(lines[2].begin(), 0.);
    const int n_along_z = static_cast<int>(lines[2].size()) - 1;
    return GridSector(
        lines,
        [=](const GridSector::Place &at) {
          return at[2] == 0 ? "base" : at[1] < n_in_tooth ? "tooth" : "";
        },
        [=](const GridSector::Place &at, const int direction, const bool is_upper)
        { return direction == 2 && is_upper && at[2] + 1 == n_along_z ? "contact" : ""; });
  }

  /** The same motor with meshes in files, of which contact makes the cells that it makes of the
   * sections. */
  Parameters with_meshes(const Parameters &motor, const ContactDiscretisation &discretisation,
                         const Scratch &scratch)
  {
    Parameters parameters          = motor;
    parameters.stator.section_file = parameters.rotor.section_file = "";
    parameters.stator.mesh_file =
        stator_below(ToothBody(motor, discretisation).mesh, motor.motor.n_teeth)
            .write(scratch, "stator_sector.msh");
    parameters.rotor.mesh_file =
        NamedSector(RotorBody(motor, discretisation).mesh).write(scratch, "rotor_sector.msh");
    return parameters;
  }

  /** The node of another motor at the same place. */
  std::size_t node_at(const CondensedMotor::Node &node, const CondensedMotor &motor)
  {
    const auto distance = [&](const CondensedMotor::Node &other)
    { return std::hypot(other.radius - node.radius, node.radius * (other.angle - node.angle)); };
    const auto nearest =
        std::min_element(motor.nodes.begin(), motor.nodes.end(),
                         [&](const CondensedMotor::Node &a, const CondensedMotor::Node &b)
                         { return distance(a) < distance(b); });
    EXPECT_LT(distance(*nearest), 1e-12);
    return nearest - motor.nodes.begin();
  }

  /** The motions under forces on one tooth that depend on their places. */
  std::vector<double> motions(const CondensedMotor &motor)
  {
    std::vector<double> forces(3 * motor.nodes.size() * motor.n_teeth), motions(forces.size());
    for (std::size_t i = 0; i < motor.nodes.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        forces[3 * i + c] = motor.nodes[i].area * (1. + 0.5 * c + 100. * motor.nodes[i].radius +
                                                   3. * motor.nodes[i].angle);
    motor.compliance.add_motions(forces.data(), motions.data());
    return motions;
  }

  /** The mean rise under an even pressure on one tooth, m/Pa. */
  double mean_rise(const CondensedMotor &motor)
  {
    const std::size_t n = motor.nodes.size();
    std::vector<double> forces(3 * n * motor.n_teeth), motions(forces.size());
    for (std::size_t i = 0; i < n; ++i)
      forces[3 * i] = motor.nodes[i].area;
    motor.compliance.add_motions(forces.data(), motions.data());
    double sum = 0., area = 0.;
    for (std::size_t i = 0; i < n; ++i)
    {
      sum += motor.nodes[i].area * motions[3 * i];
      area += motor.nodes[i].area;
    }
    return sum / area;
  }
} // namespace

TEST(MeshMotor, IsThatOfItsSections)
{
  const Scratch scratch;
  const ContactDiscretisation coarse = ContactDiscretisation::level(0);
  const Parameters sections          = section_motor(scratch),
                   meshes            = with_meshes(sections, coarse, scratch);
  EXPECT_NO_THROW(check_bodies_in_contact(meshes));
  const CondensedMotor one   = condense_motor(sections, some_wave(), coarse),
                       other = condense_motor(meshes, some_wave(), coarse);
  ASSERT_EQ(one.nodes.size(), other.nodes.size());
  EXPECT_EQ(one.n_dofs, other.n_dofs);
  const std::vector<double> a = motions(one), b = motions(other);
  const double largest = std::abs(*std::max_element(a.begin(), a.end(),
                                                    [](const double x, const double y)
                                                    { return std::abs(x) < std::abs(y); }));
  for (std::size_t i = 0; i < one.nodes.size(); ++i)
  {
    const std::size_t j = node_at(one.nodes[i], other);
    EXPECT_NEAR(one.nodes[i].area / other.nodes[j].area, 1., 1e-9);
    for (unsigned int c = 0; c < 3; ++c)
    {
      EXPECT_LT(std::abs(one.wave.free_motion[i][c] - other.wave.free_motion[j][c]), 1e-15);
      for (unsigned int tooth = 0; tooth < one.n_teeth; ++tooth)
        EXPECT_NEAR(a[3 * (tooth * one.nodes.size() + i) + c],
                    b[3 * (tooth * one.nodes.size() + j) + c], 1e-9 * largest);
    }
  }
  ASSERT_EQ(one.near_rigid_modes.size(), other.near_rigid_modes.size());
  for (std::size_t i = 0; i < one.near_rigid_modes.size(); ++i)
    EXPECT_NEAR(one.near_rigid_modes[i].stiffness / other.near_rigid_modes[i].stiffness, 1., 1e-9);
  EXPECT_NEAR(rotor_loss_factor(meshes) / rotor_loss_factor(sections), 1., 1e-9);
}

TEST(MeshMotor, ComesCloseToItsSectionsOnFinerMeshes)
{
  const Scratch scratch;
  const Parameters sections = section_motor(scratch),
                   meshes   = with_meshes(sections, ContactDiscretisation::level(0), scratch);
  const auto rise           = [](const Parameters &parameters, const unsigned int level) {
    return mean_rise(condense_motor(parameters, some_wave(), ContactDiscretisation::level(level)));
  };
  const double fine = rise(sections, 2);
  EXPECT_GT(std::abs(rise(meshes, 0) / fine - 1.), 2e-3);
  EXPECT_NEAR(rise(meshes, 2) / fine, 1., 2e-4);
  // The tooth has the same cells at all levels.
  Parameters mixed = sections;
  mixed.stator     = meshes.stator;
  EXPECT_NEAR(rise(mixed, 2) / fine, 1., 1e-9);
}

TEST(MeshMotor, HasTheModesOfItsSections)
{
  const Scratch scratch;
  Parameters sections                 = section_motor(scratch);
  sections.accuracy.mode              = AccuracyMode::fixed;
  sections.accuracy.polynomial_degree = 2;
  sections.accuracy.refinement        = 0;
  sections.modes.nodal_diameters      = {4};
  sections.modes.n_modes              = 2;
  Parameters meshes                   = sections;
  meshes.stator.section_file = meshes.rotor.section_file = "";
  meshes.stator.mesh_file = NamedSector(make_sector(stator_body(sections), SectorForm::half,
                                                    SectorGrading::level(0), MPI_COMM_SELF))
                                .write(scratch, "stator_sector.msh");
  meshes.rotor.mesh_file = NamedSector(make_rotor_sector(rotor_body(sections), SectorForm::half,
                                                         RotorGrading::level(0), MPI_COMM_SELF))
                               .write(scratch, "rotor_sector.msh");
  for (const Body body : {Body::stator, Body::tooth, Body::rotor})
  {
    const auto frequencies = [body](Parameters parameters)
    {
      parameters.modes.body = body;
      BodyModes modes(parameters, MPI_COMM_SELF);
      modes.find([](const Pass &) {});
      std::vector<double> found;
      for (const FoundMode &mode : modes.search().modes())
        found.push_back(mode.frequency.value);
      return found;
    };
    const std::vector<double> one = frequencies(sections), other = frequencies(meshes);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i)
      EXPECT_NEAR(one[i] / other[i], 1., 1e-9);
  }
  EXPECT_EQ(StatorBody(sections, 0).tooth.n_dofs(), StatorBody(meshes, 0).tooth.n_dofs());
  EXPECT_GT(StatorBody(meshes, 1).sector.n_dofs(), StatorBody(meshes, 0).sector.n_dofs());
}
