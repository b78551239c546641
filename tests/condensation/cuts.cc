// SPDX-License-Identifier: LGPL-2.1-or-later

// A sector with unusable cuts is a user's mistake: one line names the entry. The number of unknowns
// of a valid one is known from counting its nodes.

#include "support/materials.h"
#include "support/ring_sector.h"

#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/structure/cyclic_sector.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  SectorMesh brick(const SectorForm form)
  {
    return rectangular_ring(0.8, {0.1, 0.1}, 0.1, 1, 12, form, 2);
  }

  /** The message with which this mesh is refused. */
  std::string refusal(const SectorMesh &mesh)
  {
    try
    {
      const CyclicSector sector(mesh, all_of(steel), 2);
    }
    catch (const UserError &error)
    {
      return error.what();
    }
    return "nothing thrown";
  }

  void expect_refusal(const SectorMesh &mesh, const std::string &reason)
  {
    const std::string message = refusal(mesh);
    EXPECT_NE(message.find("Stator/Mesh file"), std::string::npos) << message;
    EXPECT_NE(message.find(reason), std::string::npos) << message;
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
  }

  void rename_boundary(SectorMesh &mesh, const dealii::types::boundary_id from,
                       const dealii::types::boundary_id to)
  {
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == from)
          face->set_boundary_id(to);
  }
} // namespace

TEST(Cuts, GiveTheRightNumberOfUnknowns)
{
  // 5 x 5 x 3 nodes in (r, theta, z), 15 of them on each of two planes. Half sector: inside 3 + 3,
  // on the mirror plane 1 + 2, on the cut 3. Whole sector: 3 + 3 except on the dependent cut.
  const SectorMesh half = brick(SectorForm::half), whole = brick(SectorForm::whole);
  EXPECT_EQ(CyclicSector(half, all_of(steel), 2).n_unknowns(), 45u * 6 + 15u * 3 + 15u * 3);
  EXPECT_EQ(CyclicSector(whole, all_of(steel), 2).n_unknowns(), 60u * 6);
}

TEST(Cuts, MustMatchNodeByNode)
{
  SectorMesh mesh = brick(SectorForm::whole);
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() == ids::cut_high)
        cell->set_refine_flag();
  mesh.triangulation->execute_coarsening_and_refinement();
  expect_refusal(mesh, "do not match");
}

TEST(Cuts, MustMatchInPosition)
{
  SectorMesh mesh = brick(SectorForm::whole);
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() == ids::cut_high)
      {
        for (const unsigned int vertex : face->vertex_indices())
          if (std::abs(std::hypot(face->vertex(vertex)[0], face->vertex(vertex)[1]) - 0.9) < 1e-6)
            face->vertex(vertex) *= 1.001;
      }
  expect_refusal(mesh, "do not match");
}

TEST(Cuts, MustBeApartByThePitch)
{
  SectorMesh half = brick(SectorForm::half), whole = brick(SectorForm::whole);
  half.n_sectors = whole.n_sectors = 13;
  expect_refusal(half, "degrees");
  expect_refusal(whole, "degrees");
}

TEST(Cuts, MustBeMarked)
{
  for (const auto &[form, id] :
       {std::pair(SectorForm::half, ids::mirror), std::pair(SectorForm::half, ids::cut),
        std::pair(SectorForm::whole, ids::cut_low), std::pair(SectorForm::whole, ids::cut_high)})
  {
    SectorMesh mesh = brick(form);
    rename_boundary(mesh, id, ids::free);
    expect_refusal(mesh, std::to_string(id));
  }
}

TEST(Cuts, MustBeTheRightWayRound)
{
  SectorMesh half = brick(SectorForm::half);
  rename_boundary(half, ids::mirror, 99);
  rename_boundary(half, ids::cut, ids::mirror);
  rename_boundary(half, 99, ids::cut);
  expect_refusal(half, "degrees");

  SectorMesh whole = brick(SectorForm::whole);
  rename_boundary(whole, ids::cut_low, 99);
  rename_boundary(whole, ids::cut_high, ids::cut_low);
  rename_boundary(whole, 99, ids::cut_high);
  expect_refusal(whole, "degrees");
}
