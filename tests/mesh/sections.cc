// SPDX-License-Identifier: LGPL-2.1-or-later

// Cross-sections: cuts and layers keep their area and leave no hanging nodes, revolved bodies have
// the volumes of Pappus and Guldin's theorem (or, with teeth, of integrals in closed form), and a
// stator of dimensions written to a file is read as the same.

#include "mesh/section_text.h"
#include "support/geometry.h"

#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/merged_section.h>
#include <ringmotor/mesh/read_section.h>
#include <ringmotor/mesh/revolved.h>
#include <ringmotor/mesh/section_layers.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/parameters.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;

namespace
{
  /** The number of a point (m). */
  unsigned int point_at(const Section &section, const double r, const double z)
  {
    for (unsigned int i = 0; i < section.points.size(); ++i)
      if (section.points[i].distance({r, z}) < 1e-12)
        return i;
    ADD_FAILURE() << "no point at " << r << ", " << z;
    return 0;
  }

  double area(const Section &section)
  {
    double area = 0.;
    for (const Section::Cell &cell : section.cells)
    {
      const auto &c                = cell.corners;
      const dealii::Tensor<1, 2> x = section.points[c[2]] - section.points[c[0]],
                                 y = section.points[c[3]] - section.points[c[1]];
      const double twice           = x[0] * y[1] - x[1] * y[0];
      EXPECT_GT(twice, 0.); // counterclockwise
      area += 0.5 * twice;
    }
    return area;
  }

  /** The length of the edges with a name; all of them must be outer ones. */
  double length(const Section &section, const dealii::types::boundary_id name)
  {
    const auto cells = section.cells_at_edges();
    double length    = 0.;
    for (const auto &[edge, name_of_edge] : section.names)
      if (name_of_edge == name)
      {
        EXPECT_EQ(cells.at(edge).size(), 1u);
        length += section.length(edge);
      }
    return length;
  }

  /** Without hanging nodes, each edge between cells belongs to two of them: the outer edges alone
   * make up the circumference. */
  double circumference(const Section &section)
  {
    double length = 0.;
    for (const auto &[edge, cells] : section.cells_at_edges())
      if (cells.size() == 1)
        length += section.length(edge);
    return length;
  }

  /** Both must be the disc: its area, circumference and names. */
  void expect_disc(const Section &section)
  {
    EXPECT_NEAR(area(section), 65e-6, 1e-18);
    EXPECT_NEAR(circumference(section), 51e-3, 1e-15);
    EXPECT_NEAR(length(section, ids::clamped), 1e-3, 1e-15);
    EXPECT_NEAR(length(section, ids::tooth_top), 10e-3, 1e-15);
  }

} // namespace

TEST(Section, IsCutInWholeFamilies)
{
  const Section section = read(disc());
  expect_disc(section);
  SectionCuts cuts(section);
  const auto cut_edge = [&](const Point<2> &from, const Point<2> &to, const double at)
  { cuts.cut(point_at(section, from[0], from[1]), point_at(section, to[0], to[1]), {at}); };
  cut_edge({20e-3, 0.}, {30e-3, 0.}, 0.25);  // through ceramic, ring and tooth
  cut_edge({10e-3, 1e-3}, {10e-3, 0.}, 0.1); // through web and ring, from above
  const Section cut = cuts.result();
  expect_disc(cut);
  EXPECT_EQ(cut.cells.size(), 2u + 4u + 2u + 2u + 2u);
  for (const Point<2> &x : cut.points)
    EXPECT_TRUE(std::abs(x[1] - 0.9e-3) < 1e-12 || std::abs(x[1] - 0.9e-3) > 1e-6);
  unsigned int n_low = 0, n_inside = 0;
  for (const Point<2> &x : cut.points)
  {
    n_low += std::abs(x[1] - 0.9e-3) < 1e-12 ? 1 : 0;
    n_inside += std::abs(x[0] - 22.5e-3) < 1e-12 ? 1 : 0;
  }
  EXPECT_EQ(n_low, 4u);
  EXPECT_EQ(n_inside, 6u);
}

TEST(Section, KnowsItsSingularPoints)
{
  // Two corners where the web meets ring and ceramic, and two ends of the clamped edge; what is
  // between the slots has the same.
  const Section section = read(disc());
  EXPECT_EQ(singular_points(section),
            (SectionPoints{point_at(section, 10e-3, 0.), point_at(section, 10e-3, 1e-3),
                           point_at(section, 20e-3, 0.), point_at(section, 20e-3, 1e-3)}));
}

TEST(Section, GetsLayersAroundSingularPoints)
{
  const Section section      = read(disc());
  const SectionPoints points = singular_points(section);
  SectionGrading grading(section);
  grading.grow_from(points, 1., {0.3, 1.});
  const Section grown = grading.result();
  expect_disc(grown);
  for (const Section::Cell &cell : grown.cells)
  {
    unsigned int n_singular = 0;
    for (const unsigned int corner : cell.corners)
      n_singular += points.count(corner);
    EXPECT_LE(n_singular, 1u);
  }
  for (const unsigned int n_layers : {1u, 3u})
  {
    const Section layered = with_layers(grown, points, n_layers, 0.25);
    expect_disc(layered);
    // The shortest edges at a corner shrink by the ratio of each layer.
    const unsigned int corner = point_at(section, 20e-3, 1e-3);
    const auto shortest       = [&](const Section &of)
    {
      double shortest = 1.;
      for (const auto &[edge, cells] : of.cells_at_edges())
        if (edge.first == corner || edge.second == corner)
          shortest = std::min(shortest, of.length(edge));
      return shortest;
    };
    EXPECT_NEAR(shortest(layered), shortest(grown) * std::pow(0.25, n_layers), 1e-12);
  }
}

TEST(RevolvedBody, HasTheVolumesOfItsParts)
{
  RevolvedBody body{read(disc()), {}};
  body.slots = slots_of(body.section, 60, 0.5e-3);
  EXPECT_NEAR(body.slots.inner_radius, 20e-3, 1e-15);
  const double half_pitch = M_PI / 60;
  // The area between theta = 0 and the plane at a distance c from the middle of the slot.
  const auto primitive = [&](const double r)
  {
    const double c = 0.25e-3;
    return 0.5 * (half_pitch * r * r - r * r * std::asin(c / r) - c * std::sqrt(r * r - c * c));
  };
  const auto sector = [&](const double inner, const double outer)
  { return 0.5 * half_pitch * (outer * outer - inner * inner); };
  const std::map<dealii::types::material_id, double> exact{
      {ids::base, 1e-3 * sector(10e-3, 20e-3) + 3e-3 * sector(20e-3, 30e-3)},
      {ids::tooth, 2e-3 * (primitive(30e-3) - primitive(20e-3))},
      {ids::piezoceramic, 5e-4 * sector(20e-3, 30e-3)}};
  for (const unsigned int level : {0u, 1u, 4u})
    for (const auto form : {SectorForm::half, SectorForm::whole})
    {
      const SectorMesh mesh = make_sector(body, form, SectorGrading::level(level), MPI_COMM_SELF);
      const double parts    = form == SectorForm::half ? 1. : 2.;
      for (const auto &[part, volume] : exact)
        EXPECT_NEAR(volumes(*mesh.triangulation, 6).at(part) / (parts * volume), 1., 1e-9)
            << level << ' ' << part;
      EXPECT_GT(smallest_jacobian_ratio(*mesh.triangulation), 0.05) << level;
    }
}

TEST(RevolvedBody, MayHaveRadialSlots)
{
  RevolvedBody body{read(disc()), {}};
  body.slots = slots_of(body.section, 60, 0., 0.02);
  const SectorMesh mesh =
      make_sector(body, SectorForm::half, SectorGrading::level(1), MPI_COMM_SELF);
  EXPECT_NEAR(volumes(*mesh.triangulation, 6).at(ids::tooth) /
                  (2e-3 * 0.5 * (M_PI / 60 - 0.01) * (900e-6 - 400e-6)),
              1., 1e-9);
}

TEST(RevolvedBody, OfDimensionsIsReadAsItWasWritten)
{
  const Scratch scratch;
  const RevolvedBody body = stator_body(StatorGeometry(), 90);
  const std::string file  = SectionText(body.section, names_of_stator()).write(scratch);
  RevolvedBody read_body{read_section(file, BodyOf::stator), {}};
  read_body.slots = slots_of(read_body.section, 90, StatorGeometry().slot_width);
  const SectorMesh made =
                       make_sector(body, SectorForm::half, SectorGrading::level(2), MPI_COMM_SELF),
                   from_file = make_sector(read_body, SectorForm::half, SectorGrading::level(2),
                                           MPI_COMM_SELF);
  ASSERT_EQ(made.triangulation->n_active_cells(), from_file.triangulation->n_active_cells());
  for (auto a = made.triangulation->begin_active(), b = from_file.triangulation->begin_active();
       a != made.triangulation->end(); ++a, ++b)
  {
    EXPECT_EQ(a->material_id(), b->material_id());
    EXPECT_LT(a->center().distance(b->center()), 1e-15);
    for (const unsigned int face : a->face_indices())
      EXPECT_EQ(a->face(face)->boundary_id(), b->face(face)->boundary_id());
  }
}

TEST(RevolvedBody, HasBarsAndFeltWhereTheSectionNamesThem)
{
  SectionText ring;
  ring.points   = {{10e-3, 0.}, {20e-3, 0.}, {10e-3, 4e-3}, {20e-3, 4e-3}};
  ring.elements = {{3, "rotor", {0, 1, 3, 2}}, {1, "bars", {0, 2}}};
  const Scratch scratch;
  Parameters parameters;
  parameters.rotor.section_file         = ring.write(scratch);
  parameters.rotor.radial_bar_stiffness = 1e9;
  EXPECT_NEAR(rotor_body(parameters).bar_stiffness, 1e9 / 4e-3, 1.);
  parameters.not_given = {"Rotor/Radial bar stiffness"};
  EXPECT_NE(message_of<UserError>([&]() { rotor_body(parameters); }).find("has the curve 'bars'"),
            std::string::npos);
  ring.elements.pop_back();
  parameters.rotor.section_file = ring.write(scratch);
  EXPECT_EQ(rotor_body(parameters).bar_stiffness, 0.);
  parameters.not_given.clear();
  EXPECT_NE(message_of<UserError>([&]() { rotor_body(parameters); }).find("no curve 'bars'"),
            std::string::npos);

  parameters.stator.section_file      = three_columns().write(scratch, "stator.msh");
  parameters.support.felt_thickness   = 1e-3;
  parameters.support.felt_modulus     = 1e6;
  parameters.support.felt_loss_factor = 0.1;
  EXPECT_NE(message_of<UserError>([&]() { stator_body(parameters); }).find("no curve 'felt'"),
            std::string::npos);
  parameters.effects["Felt support"] = EffectChoice::off;
  EXPECT_NO_THROW(stator_body(parameters));
}

TEST(Section, LosesLinesThatOnlyDivide)
{
  // Two columns of ring and lining; the line between them reaches from the contact to the top.
  SectionText text;
  for (const double z : {0., 1e-3, 3e-3})
    for (const double r : {20e-3, 22e-3, 25e-3})
      text.points.emplace_back(r, z);
  text.elements     = {{3, "lining", {0, 1, 4, 3}}, {3, "lining", {1, 2, 5, 4}},
                       {3, "rotor", {3, 4, 7, 6}},  {3, "rotor", {4, 5, 8, 7}},
                       {1, "contact", {0, 1}},      {1, "contact", {1, 2}},
                       {1, "pressed", {6, 7}},      {1, "pressed", {7, 8}}};
  const auto merged = [&]() { return without_lines_from(ids::lip, read(text, BodyOf::rotor)); };
  EXPECT_EQ(merged().cells.size(), 2u);
  EXPECT_NEAR(area(merged()), 15e-6, 1e-18);
  EXPECT_NEAR(circumference(merged()), 16e-3, 1e-15);
  EXPECT_NEAR(length(merged(), ids::lip), 5e-3, 1e-15);
  EXPECT_NEAR(length(merged(), ids::ring_top), 5e-3, 1e-15);
  const std::vector<SectionText::Element> all = text.elements;
  text.elements.pop_back(); // the line ends where a name does
  EXPECT_EQ(merged().cells.size(), 4u);
  text.elements     = all;
  text.points[7][1] = 3.2e-3; // or at a corner
  EXPECT_EQ(merged().cells.size(), 4u);
  text.points[7][1] = 3e-3;
  text.points[4][1] = 1.1e-3; // or crosses a bent one
  EXPECT_EQ(merged().cells.size(), 4u);
}
