// SPDX-License-Identifier: LGPL-2.1-or-later

// Cutting a sheet changes the mesh, not the body: no hanging nodes, the same volume, one more cell
// for each cell that the sheet runs through, and cuts that still match. The number of sheets of a
// box is the number of its layers in the three directions.

#include "support/geometry.h"
#include "support/ring_sector.h"

#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/mesh/sheets.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  SectorMesh coarse_stator(const SectorForm form)
  {
    return make_sector(stator_body(StatorGeometry(), 90), form, SectorGrading::level(1),
                       MPI_COMM_SELF);
  }

  /** A whole sector in two pieces that are connected only across the cuts: 2 x 2 cells each. */
  SectorMesh split_sector()
  {
    const double pitch = 0.5;
    SectorMesh mesh{empty_triangulation<3>(MPI_COMM_SELF), SectorForm::whole, 12};
    dealii::Table<3, dealii::types::material_id> materials(2, 3, 2);
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int k = 0; k < 2; ++k)
          materials(i, j, k) = j == 1 ? dealii::numbers::invalid_material_id : ids::base;
    dealii::GridGenerator::subdivided_hyper_rectangle(
        *mesh.triangulation, {{0.1, 0.1}, {0.3 * pitch, 0.4 * pitch, 0.3 * pitch}, {0.1, 0.1}},
        dealii::Point<3>(1., -0.5 * pitch, 0.), materials);
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          face->set_boundary_id(face->center()[1] > 0.499 * pitch    ? ids::cut_high
                                : face->center()[1] < -0.499 * pitch ? ids::cut_low
                                                                     : ids::free);
    dealii::GridTools::transform(
        [](const dealii::Point<3> &x)
        { return dealii::Point<3>(x[0] * std::cos(x[1]), x[0] * std::sin(x[1]), x[2]); },
        *mesh.triangulation);
    return mesh;
  }

  double volume(const SectorMesh &mesh)
  {
    double sum = 0.;
    for (const auto &entry : volumes(*mesh.triangulation, 6))
      sum += entry.second;
    return sum;
  }

  /** (r, z) in nm of the vertices on a cut. */
  std::set<std::pair<long, long>> places_on(const SectorMesh &mesh,
                                            const dealii::types::boundary_id cut)
  {
    std::set<std::pair<long, long>> places;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == cut)
          for (const unsigned int v : face->vertex_indices())
          {
            const dealii::Point<3> x = face->vertex(v);
            places.emplace(std::lround(1e9 * std::hypot(x[0], x[1])), std::lround(1e9 * x[2]));
          }
    return places;
  }

  void expect_conforming(const SectorMesh &mesh)
  {
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
      {
        EXPECT_FALSE(face->has_children());
        for (unsigned int line = 0; line < 4; ++line)
          EXPECT_FALSE(face->line(line)->has_children());
      }
    if (mesh.form == SectorForm::whole)
    {
      EXPECT_EQ(places_on(mesh, ids::cut_low), places_on(mesh, ids::cut_high));
    }
  }

  unsigned int n_cells_in(const SectorMesh &mesh, const Sheets &sheets, const unsigned int sheet)
  {
    unsigned int count = 0;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (unsigned int direction = 0; direction < 3; ++direction)
        count += sheets.sheet(*cell, direction) == sheet;
    return count;
  }

  class SheetsOf : public testing::TestWithParam<SectorForm>
  {
  };
} // namespace

TEST(Sheets, AreTheLayersOfABox)
{
  for (const SectorForm form : {SectorForm::half, SectorForm::whole})
  {
    const SectorMesh mesh = rectangular_ring(1., {0.1, 0.1, 0.1}, 0.2, 2, 10, form, 5);
    const Sheets sheets(mesh);
    EXPECT_EQ(sheets.n_sheets(), 3u + 2u + 5u);
  }
}

TEST(Sheets, GoOnAcrossTheCuts)
{
  // Linked: 2 layers in r, 2 in z; in theta each piece has its own.
  SectorMesh mesh = split_sector();
  const Sheets sheets(mesh);
  EXPECT_EQ(sheets.n_sheets(), 2u + 2u + 2u);
  std::vector<bool> chosen(sheets.n_sheets(), false);
  for (unsigned int direction = 0; direction < 3; ++direction)
    chosen[sheets.sheet(*mesh.triangulation->begin_active(), direction)] = true;
  sheets.refine(mesh, chosen);
  expect_conforming(mesh);
  // First piece 3 x 2 x 3 cells, the second, not cut in theta, 3 x 1 x 3
  EXPECT_EQ(mesh.triangulation->n_active_cells(), 18u + 9u);
}

TEST(Sheets, OfTheStatorRunThroughTheSector)
{
  // A sheet that meets the mirror plane, as the layers in r and z do, crosses it; every other one
  // has its own mirror image.
  const SectorMesh half = coarse_stator(SectorForm::half), whole = coarse_stator(SectorForm::whole);
  const Sheets half_sheets(half), whole_sheets(whole);
  std::set<unsigned int> through;
  for (const auto &cell : half.triangulation->active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      if (cell->at_boundary(face) && cell->face(face)->boundary_id() == ids::mirror)
        for (unsigned int direction = 0; direction < 3; ++direction)
          if (direction != face / 2)
            through.insert(half_sheets.sheet(*cell, direction));
  EXPECT_GT(through.size(), 5u);
  EXPECT_LT(through.size(), half_sheets.n_sheets());
  EXPECT_EQ(whole_sheets.n_sheets(), 2 * half_sheets.n_sheets() - through.size());
}

TEST_P(SheetsOf, TheStatorCanBeCutOneByOne)
{
  const SectorMesh original = coarse_stator(GetParam());
  const double exact        = volume(original);
  const Sheets sheets(original);
  for (unsigned int sheet = 0; sheet < sheets.n_sheets(); ++sheet)
  {
    SectorMesh mesh             = coarse_stator(GetParam());
    const unsigned int n_before = mesh.triangulation->n_active_cells();
    const Sheets own(mesh);
    const unsigned int n_in = n_cells_in(mesh, own, sheet);
    std::vector<bool> chosen(own.n_sheets(), false);
    chosen[sheet] = true;
    own.refine(mesh, chosen);
    EXPECT_EQ(mesh.triangulation->n_active_cells(), n_before + n_in) << "sheet " << sheet;
    EXPECT_NEAR(volume(mesh) / exact, 1., 1e-11) << "sheet " << sheet;
    expect_conforming(mesh);
  }
}

TEST_P(SheetsOf, TheStatorCanBeCutAgainAndAgain)
{
  SectorMesh mesh     = coarse_stator(GetParam());
  const double exact  = volume(mesh);
  unsigned int stride = 2;
  for (unsigned int pass = 0; pass < 4; ++pass)
  {
    const Sheets sheets(mesh);
    std::vector<bool> chosen(sheets.n_sheets(), false);
    for (unsigned int sheet = pass % stride; sheet < chosen.size(); sheet += ++stride)
      chosen[sheet] = true;
    sheets.refine(mesh, chosen);
    EXPECT_NEAR(volume(mesh) / exact, 1., 1e-11) << "pass " << pass;
    expect_conforming(mesh);
    EXPECT_GT(smallest_jacobian_ratio(*mesh.triangulation), 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(Forms, SheetsOf, testing::Values(SectorForm::half, SectorForm::whole),
                         [](const auto &info)
                         { return info.param == SectorForm::half ? "Half" : "Whole"; });
