// SPDX-License-Identifier: LGPL-2.1-or-later

// Sectors from Gmsh files. A good file is one that deal.II's writer makes of a mesh that we know:
// what is read must be that mesh. Bad ones are made from it by hand; each is refused in one line
// that names the entry and says what was found.

#include "output/scratch.h"
#include "support/geometry.h"
#include "support/ring_sector.h"

#include <ringmotor/mesh/read_sector.h>
#include <ringmotor/parameters/errors.h>

#include <deal.II/grid/grid_out.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  SectorMesh brick(const SectorForm form)
  {
    return rectangular_ring(0.8, {0.1, 0.1}, 0.1, 1, 12, form, 2, MPI_COMM_SELF);
  }

  void write(const std::string &path, const dealii::Triangulation<3> &triangulation)
  {
    dealii::GridOut writer;
    writer.set_flags(dealii::GridOutFlags::Msh(/*write_faces =*/true));
    std::ofstream file(path);
    file.precision(17);
    writer.write_msh(triangulation, file);
  }

  void expect_refusal(const std::string &path, const std::string &reason)
  {
    const std::string message =
        message_of<UserError>([&]() { read_sector(path, 12, MPI_COMM_SELF); });
    for (const std::string &part : {std::string("Stator/Mesh file"), path, reason})
      EXPECT_NE(message.find(part), std::string::npos) << part << " is missing in: " << message;
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
  }

  /** Refusal of the good mesh after @p damage. */
  template <typename Damage>
  void expect_refusal_after(const Damage &damage, const std::string &reason)
  {
    const Scratch scratch;
    const SectorMesh mesh = brick(SectorForm::half);
    damage(*mesh.triangulation);
    write(scratch.path("bad.msh"), *mesh.triangulation);
    expect_refusal(scratch.path("bad.msh"), reason);
  }

  template <typename Use>
  void for_each_boundary_face(const dealii::Triangulation<3> &triangulation, const Use &use)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          use(face);
  }
} // namespace

TEST(ReadSector, GivesBackWhatWasWritten)
{
  const Scratch scratch;
  for (const SectorForm form : {SectorForm::half, SectorForm::whole})
  {
    const SectorMesh original = brick(form);
    write(scratch.path("good.msh"), *original.triangulation);
    const SectorMesh read = read_sector(scratch.path("good.msh"), 12, MPI_COMM_SELF);
    EXPECT_EQ(read.form, form);
    EXPECT_EQ(read.n_sectors, 12u);
    EXPECT_EQ(read.triangulation->n_active_cells(), original.triangulation->n_active_cells());
    // Curved around the axis: the volume is that of the ring, pi (1^2 - 0.8^2) 0.1 / N.
    const double exact = M_PI * 0.36 * 0.1 / (form == SectorForm::half ? 24 : 12);
    EXPECT_NEAR(volumes(*read.triangulation, 6).at(ids::base) / exact, 1., 1e-11);
    const auto areas    = boundary_areas(*read.triangulation, 6),
               expected = boundary_areas(*original.triangulation, 6);
    ASSERT_EQ(areas.size(), expected.size());
    for (const auto &[id, area] : expected)
      EXPECT_NEAR(areas.at(id) / area, 1., 1e-12);
  }
}

TEST(ReadSector, RefusesFilesThatAreNoMesh)
{
  const Scratch scratch;
  expect_refusal(scratch.path("missing.msh"), "cannot be opened");
  for (const std::string content :
       {"", "subsection Motor\nend\n", "$MeshFormat\n2.2 0 8\n",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1000000\n1 0 0 0\n"})
  {
    std::ofstream(scratch.path("junk.msh")) << content;
    expect_refusal(scratch.path("junk.msh"), "not a mesh");
  }
  std::filesystem::create_directory(scratch.path("folder.msh"));
  expect_refusal(scratch.path("folder.msh"), "");
}

TEST(ReadSector, RefusesTetrahedra)
{
  // With and without surfaces that are marked as a hexahedral mesh would have them
  const Scratch scratch;
  const std::string nodes = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 1 0 0\n2 2 0 0\n"
                            "3 1 1 0\n4 1 0 1\n$EndNodes\n$Elements\n";
  std::ofstream(scratch.path("bare.msh")) << nodes << "1\n1 4 2 1 1 1 2 3 4\n$EndElements\n";
  expect_refusal(scratch.path("bare.msh"), "hexahedra");
  std::ofstream(scratch.path("marked.msh"))
      << nodes << "3\n1 4 2 1 1 1 2 3 4\n2 2 2 11 1 1 2 4\n3 2 2 12 1 1 3 4\n$EndElements\n";
  expect_refusal(scratch.path("marked.msh"), "hexahedra");
}

TEST(ReadSector, RefusesUnknownIds)
{
  expect_refusal_after([](dealii::Triangulation<3> &mesh)
                       { mesh.begin_active()->set_material_id(4); },
                       "physical id 4");
  expect_refusal_after(
      [](dealii::Triangulation<3> &mesh)
      {
        for_each_boundary_face(mesh,
                               [](const auto &face)
                               {
                                 if (face->boundary_id() == ids::free)
                                   face->set_boundary_id(17);
                               });
      },
      "physical id 17");
}

TEST(ReadSector, RefusesMissingAndMixedCuts)
{
  const auto rename = [](const unsigned int from, const unsigned int to)
  {
    return [from, to](dealii::Triangulation<3> &mesh)
    {
      for_each_boundary_face(mesh,
                             [&](const auto &face)
                             {
                               if (face->boundary_id() == from)
                                 face->set_boundary_id(to);
                             });
    };
  };
  expect_refusal_after(rename(ids::cut, ids::free), "cuts are not marked");
  expect_refusal_after(rename(ids::mirror, ids::cut_low), "cuts are not marked");
}

TEST(ReadSector, RefusesInvertedCells)
{
  // A vertex pulled through the cell to beyond the opposite side
  expect_refusal_after(
      [](dealii::Triangulation<3> &mesh)
      {
        dealii::Point<3> &vertex = mesh.begin_active()->vertex(0);
        vertex += 1.5 * (mesh.begin_active()->vertex(7) - vertex);
      },
      "inverted");
}
