// SPDX-License-Identifier: LGPL-2.1-or-later

// Meshes of half a sector for the program contact: sound ones tell where they touch, and those that
// cannot be in contact are refused in one line that names the entry and says what to do.

#include "mesh/named_sector.h"

#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/mesh/check_contact.h>
#include <ringmotor/mesh/sector_cuts.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/parameters.h>

#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  constexpr unsigned int n_teeth = 30;
  const double half_pitch        = M_PI / n_teeth;

  /** A base below a tooth, r = 20 to 26 mm. */
  NamedSector stator(const double end_of_tooth = 0.07)
  {
    return GridSector(
        {{{20e-3, 22e-3, 24e-3, 26e-3}, {0., end_of_tooth, half_pitch}, {0., 3e-3, 5e-3}}},
        [](const GridSector::Place &at) { return at[2] == 0   ? "base"
                                                 : at[1] == 0 ? "tooth"
                                                              : ""; },
        [](const GridSector::Place &at, const int direction, const bool is_upper)
        {
          return direction != 2            ? ""
                 : is_upper && at[2] == 1  ? "contact"
                 : !is_upper && at[2] == 0 ? "felt"
                                           : "";
        });
  }

  /** A ring with a lining below it, in r from 22 mm, that has a pocket at the cut. */
  NamedSector rotor(const double inner = 22e-3)
  {
    return GridSector(
        {{{inner, inner + 2e-3, inner + 6e-3}, {0., 0.04, half_pitch}, {-1e-3, 0., 2e-3, 4e-3}}},
        [](const GridSector::Place &at)
        {
          return at[2] == 0                 ? at[0] == 0 ? "lining" : ""
                 : at[2] == 2 && at[1] == 1 ? "" // the pocket
                                            : "rotor";
        },
        [](const GridSector::Place &at, const int direction, const bool is_upper)
        {
          return direction == 2 && !is_upper && at[2] == 0                ? "contact"
                 : direction == 2 && is_upper && at[2] == 2 && at[0] == 1 ? "pressed"
                 : direction == 0 && is_upper && at[2] == 1               ? "driven"
                                                                          : "";
        });
  }

  struct Sectors
  {
    NamedSector stator = ::stator(), rotor = ::rotor();
    double scale = 1.; ///< of the rotor's lengths
    Parameters parameters;
  };

  using Change = std::function<void(Sectors &)>;

  std::string message_with(const Change &change)
  {
    const Scratch scratch;
    Sectors of;
    of.parameters.rotor.radial_bar_stiffness = 0.;
    of.parameters.motor.n_teeth              = n_teeth;
    change(of);
    of.parameters.stator.mesh_file = of.stator.write(scratch, "stator.msh");
    of.parameters.rotor.mesh_file  = of.rotor.write(scratch, "rotor.msh", of.scale);
    return message_of<UserError>([&]() { check_bodies_in_contact(of.parameters); });
  }

  void expect_refusal(const Change &change, const std::vector<std::string> &words)
  {
    const std::string message = message_with(change);
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find("; "), std::string::npos) << message; // what to do
    for (const std::string &word : words)
      EXPECT_NE(message.find(word), std::string::npos) << '"' << word << "\" not in: " << message;
  }

  /** The cells have the outer faces of the body alone: no cracks between them, in which nodes of
   * one side would hang. Chords of arcs are a little off. */
  void expect_no_cracks(const SectorMesh &mesh, const SectorMesh &body)
  {
    const auto area_of_surface = [](const SectorMesh &of)
    {
      double area = 0.;
      for (const auto &face : of.triangulation->active_face_iterators())
        if (face->at_boundary())
          area += face->measure();
      return area;
    };
    EXPECT_NEAR(area_of_surface(mesh) / area_of_surface(body), 1., 2e-3);
  }

  double area_of(const SectorMesh &mesh, const dealii::types::boundary_id name)
  {
    double area = 0.;
    for (const auto &face : mesh.triangulation->active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == name)
        area += face->measure();
    return area;
  }
} // namespace

TEST(ContactSectors, AreAccepted)
{
  EXPECT_EQ(message_with([](Sectors &) {}), "nothing thrown");
}

TEST(ContactSectors, TellWhatTheirBodiesHave)
{
  const Scratch scratch;
  Parameters parameters;
  parameters.motor.n_teeth    = n_teeth;
  parameters.stator.mesh_file = stator().write(scratch, "stator.msh");
  NamedSector with_bars       = rotor();
  with_bars.rename("driven", "bars");
  parameters.rotor.mesh_file = with_bars.write(scratch, "rotor.msh");
  const auto of_stator       = stator_shape(parameters);
  const auto of_rotor        = rotor_shape(parameters);
  EXPECT_NEAR(of_stator->contact_line().radii.inner, 20e-3, 1e-12);
  EXPECT_NEAR(of_stator->contact_line().radii.outer, 26e-3, 1e-12);
  EXPECT_NEAR(of_rotor->contact_line().radii.outer, 24e-3, 1e-12);
  EXPECT_NEAR(rise_to_contact(*of_rotor, *of_stator), 6e-3, 1e-12);
  EXPECT_TRUE(of_stator->has_slots());
  ASSERT_EQ(of_stator->on_felt().size(), 1u);
  EXPECT_NEAR(of_stator->on_felt().front().width(), 6e-3, 1e-12);
  EXPECT_NEAR(of_rotor->radii_of(ids::lining).width(), 2e-3, 1e-12);
  // A band 2 mm high around the ring.
  EXPECT_NEAR(of_rotor->bar_stiffness() / (parameters.rotor.radial_bar_stiffness / 2e-3), 1., 1e-9);
}

TEST(ContactSectors, AreCutWhereBodiesTouch)
{
  const Scratch scratch;
  Parameters parameters;
  parameters.motor.n_teeth              = n_teeth;
  parameters.rotor.radial_bar_stiffness = 0.;
  parameters.stator.mesh_file           = stator().write(scratch, "stator.msh");
  parameters.rotor.mesh_file            = rotor().write(scratch, "rotor.msh");
  const auto of_stator                  = stator_shape(parameters);
  const RadialRange lip                 = rotor_shape(parameters)->contact_line().radii;
  const SectorMesh coarse               = of_stator->contact_tooth(lip, {1, 1}, MPI_COMM_SELF),
                   across               = of_stator->contact_tooth(lip, {3, 1}, MPI_COMM_SELF),
                   around               = of_stator->contact_tooth(lip, {1, 3}, MPI_COMM_SELF);
  EXPECT_EQ(coarse.n_cells(), 3u);
  EXPECT_EQ(across.n_cells(), 15u); // two more columns, and two more layers
  EXPECT_EQ(around.n_cells(), 9u);
  const double area = area_of(coarse, ids::tooth_top);
  EXPECT_GT(area, 0.);
  EXPECT_NEAR(area_of(across, ids::tooth_top) / area, 1., 1e-3); // chords of arcs
  EXPECT_NEAR(area_of(around, ids::tooth_foot) / area_of(coarse, ids::tooth_foot), 1., 1e-3);
  double narrowest = 1.;
  for (const auto &cell : across.triangulation->active_cell_iterators())
    narrowest = std::min(narrowest, cell->minimum_vertex_distance());
  EXPECT_NEAR(narrowest, 2e-3 * 0.15 * 0.15, 1e-9); // as a section is graded

  const auto of_rotor   = rotor_shape(parameters);
  RotorGrading grading  = RotorGrading::level(0);
  const auto n_cells_of = [&]() {
    return of_rotor->contact_sector(grading, {1, 1}, MPI_COMM_SELF).n_cells();
  };
  const std::size_t n_coarse = n_cells_of();
  EXPECT_EQ(n_coarse, 8u);
  grading.first *= 0.5;
  // At the side of the lining: columns and layers on both sides; at the pocket, too.
  EXPECT_GT(n_cells_of(), 3 * n_coarse);
  const auto volume_of = [](const SectorMesh &mesh)
  { return dealii::GridTools::volume(*mesh.triangulation, dealii::MappingQ<3>(3)); };
  const SectorMesh whole = of_rotor->contact_sector({0.5}, {1, 1}, MPI_COMM_SELF);
  for (const double first : {0.5, 0.25, 0.1, 0.02})
    for (const InterfaceGrading &cells : {InterfaceGrading{1, 1}, {3, 2}})
    {
      const SectorMesh cut = of_rotor->contact_sector({first, 0.1}, cells, MPI_COMM_SELF);
      expect_no_cracks(cut, whole);
      EXPECT_NEAR(volume_of(cut) / volume_of(whole), 1., 1e-9);
    }
  expect_no_cracks(of_stator->contact_tooth(lip, {3, 2}, MPI_COMM_SELF), coarse);
}

TEST(ContactSectors, NeedTheFacesOfContactAndLoads)
{
  for (const auto &[name, what] : {std::make_pair("pressed", "the preload acts"),
                                   {"driven", "the load torque acts"},
                                   {"contact", "the lower face of lip or lining"}})
    expect_refusal([name = name](Sectors &of) { of.rotor.rename(name, ""); },
                   {"Rotor/Mesh file = \"", std::string("it has no surface '") + name, what,
                    "Physical Surface(\""});
  expect_refusal([](Sectors &of) { of.stator.rename("contact", ""); },
                 {"Stator/Mesh file = \"", "no face has the physical id 15 (tooth top)"});
  expect_refusal([](Sectors &of) { of.rotor.rename("driven", "clamped"); },
                 {"Rotor/Mesh file = \"", "no surface 'driven'"});
  expect_refusal([](Sectors &of) { of.rotor.rename("pressed", "loaded"); },
                 {"Rotor/Mesh file = \"", "a surface has the name 'loaded', near r = ",
                  "contact, pressed, driven, bars or clamped"});
  expect_refusal([](Sectors &of) { of.rotor.rename("lining", "tooth"); },
                 {"a volume has the name 'tooth'", "allowed: rotor, lining or adhesive"});
  expect_refusal([](Sectors &of) { of.parameters.not_given = {"Materials/Lining/Loss factor"}; },
                 {"Materials/Lining/Loss factor", "Rotor/Mesh file has the part 'lining'"});
  expect_refusal([](Sectors &of) { of.parameters.not_given = {"Materials/Lining/Density"}; },
                 {"Materials/Lining/Density", "Rotor/Mesh file has the part 'lining'"});
  expect_refusal([](Sectors &of) { of.parameters.rotor.radial_bar_stiffness = 1e9; },
                 {"Rotor/Radial bar stiffness", "Rotor/Mesh file has no surface 'bars'"});
}

TEST(ContactSectors, NeedTeethThatReachTheRotor)
{
  expect_refusal([](Sectors &of) { of.stator = stator(half_pitch - 1e-9); },
                 {"Stator/Mesh file = \""}); // no slot is left
  expect_refusal([](Sectors &of) { of.stator.rename("tooth", "base"); },
                 {"Stator/Mesh file = \"", "belongs to the physical volume 1"});
  expect_refusal([](Sectors &of) { of.rotor = rotor(27e-3); },
                 {"the lip misses the teeth", "the surface 'contact' of Rotor/Mesh file = \"",
                  "from r = 27 mm to 29 mm", "the surface 'contact' of Stator/Mesh file = \"",
                  "from r = 20 mm to 26 mm", "at least 10 um"});
  expect_refusal(
      [](Sectors &of)
      {
        for (dealii::Point<3> &x : of.rotor.nodes)
          if (x[2] < -0.5e-3 && std::hypot(x[0], x[1]) > 23e-3)
            x[2] -= 0.1e-3;
      },
      {"Rotor/Mesh file = \"", "the surface 'contact' reaches from z = -1.1 mm to -1 mm",
       "it must be level"});
  expect_refusal(
      [](Sectors &of)
      {
        // The ring hangs down into the teeth beside the lining.
        for (dealii::Point<3> &x : of.rotor.nodes)
          if (std::abs(x[2]) < 1e-6 && std::hypot(x[0], x[1]) > 25e-3)
            x[2] = -4e-3;
      },
      {"the rotor cuts into the stator, at r = ", "touch along these lines only"});
}

TEST(ContactSectors, NeedHalfASectorInMetres)
{
  expect_refusal([](Sectors &of) { of.scale = 1e3; },
                 {"Rotor/Mesh file = \"", "its largest radius is 28 m", "Mesh.ScalingFactor"});
  expect_refusal([](Sectors &of) { of.rotor.rename("mirror", ""); },
                 {"Rotor/Mesh file = \"", "the cuts are not marked"});
  expect_refusal([](Sectors &of) { of.parameters.motor.n_teeth = 31; },
                 {"Stator/Mesh file = \"", "Motor/Number of teeth = 31"});
  expect_refusal([](Sectors &of) { of.parameters.wave.amplitude = 2e-3; },
                 {"Wave/Amplitude = 0.002 m", "the height of Stator/Mesh file = 0.005 m"});
}
