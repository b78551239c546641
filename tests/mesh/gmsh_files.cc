// SPDX-License-Identifier: LGPL-2.1-or-later

// Gmsh saves one mesh in many ways: in several versions of its format, with parametric coordinates,
// divided for several processes, with sections that say nothing of the mesh, and with all or few
// digits. The files tests/fuzz/meshes/gmsh_*.msh were saved by Gmsh 4.8.4 from
// meshes/canon_sector.geo (half of it, with fewer cells); their names say how. What is not read is
// refused with its cause.

#include "mesh/small_sector.h"

#include <ringmotor/mesh/places.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <utility>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  const std::filesystem::path folder = RINGMOTOR_SOURCE_DIR "/tests/fuzz/meshes";

  /** What a mesh is, whatever the order of its cells: (r, z) of the middle of each cell with its
   * id, and of each marked face, in units of 0.1 um. */
  std::multiset<std::vector<long>> content(const SectorMesh &mesh)
  {
    std::multiset<std::vector<long>> content;
    const auto add = [&](const auto &part, const long id)
    {
      const dealii::Point<3> x = cylindrical(part->center());
      content.insert({std::lround(1e7 * x[0]), std::lround(1e7 * x[2]), id});
    };
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
    {
      add(cell, cell->material_id());
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() != ids::free)
          add(face, face->boundary_id());
    }
    return content;
  }

  /** @p text with @p after inserted behind each @p before. */
  std::string with(std::string text, const std::string &before, const std::string &after)
  {
    const std::size_t at = text.find(before);
    EXPECT_NE(at, std::string::npos);
    return text.insert(at + before.size(), after);
  }

  std::string write(const Scratch &scratch, const std::string &text)
  {
    std::ofstream(scratch.path("other.msh")) << text;
    return scratch.path("other.msh");
  }
} // namespace

TEST(GmshFiles, AreTheSameMeshHoweverTheyAreSaved)
{
  const auto plain = content(read(folder / "gmsh_plain.msh", 90));
  EXPECT_EQ(plain.size(), 10u + 6u + 4u + 2u); // cells, mirror plane, cut, top
  unsigned int n_files = 0;
  for (const auto &entry : std::filesystem::directory_iterator(folder))
    if (entry.path().filename().string().rfind("gmsh_", 0) == 0)
    {
      ++n_files;
      EXPECT_EQ(content(read(entry.path(), 90)), plain) << entry.path();
    }
  EXPECT_EQ(n_files, 8u);
}

TEST(GmshFiles, MayHaveOtherSections)
{
  const Scratch scratch;
  const std::string comments = "$Comments\nmade by hand\n$EndComments\n",
                    data     = "$NodeData\n1\n\"T\"\n1\n0.\n3\n0\n1\n1\n1 5.\n$EndNodeData\n",
                    empty    = "$Periodic\n$EndPeriodic\n";
  for (const std::string name : {"gmsh_plain.msh", "gmsh_plain_2.msh"})
  {
    const std::string text = content_of(folder / name);
    const auto plain       = content(read(folder / name, 90));
    for (const std::string &section : {comments, data, empty})
      for (const std::string &changed :
           {section + text, with(text, "$EndMeshFormat\n", section),
            with(text, "$EndNodes\n", section), with(text, "$EndElements\n", section)})
        EXPECT_EQ(content(read(write(scratch, changed), 90)), plain) << section;
    EXPECT_EQ(content(read(write(scratch, "\xEF\xBB\xBF" + text), 90)), plain);
    expect_refusal(write(scratch, text + "$Comments\nwithout an end\n"), {"damaged"}, 90);
    expect_refusal(write(scratch, with(text, "$EndNodes\n", "words outside of sections\n")),
                   {"damaged", "line "}, 90);
  }
}

TEST(GmshFiles, MayNameTheirGroups)
{
  const std::map<int, std::string> names{{1, "base"},    {2, "tooth"},    {11, "mirror"},
                                         {12, "cut"},    {13, "cut low"}, {14, "cut high"},
                                         {15, "contact"}};
  const Scratch scratch;
  for (const auto form : {SectorForm::half, SectorForm::whole})
  {
    SmallSector sector(form);
    std::string section = "$EndMeshFormat\n$PhysicalNames\n7\n";
    for (const auto &[id, name] : names)
    {
      sector.mark_all(id, id + 100); // not ours
      section += (id < 10 ? "3 " : "2 ") + std::to_string(id + 100) + " \"" + name + "\"\n";
    }
    std::string text = content_of(sector.write(scratch));
    text.replace(text.find("$EndMeshFormat\n"), 15, section + "$EndPhysicalNames\n");
    std::ofstream(scratch.path("named.msh")) << text;
    const SectorMesh mesh  = read(scratch.path("named.msh"), 6),
                     plain = read(SmallSector(form).write(scratch), 6);
    EXPECT_EQ(mesh.form, form);
    for (auto a = mesh.triangulation->begin_active(), b = plain.triangulation->begin_active();
         a != mesh.triangulation->end(); ++a, ++b)
    {
      EXPECT_EQ(a->material_id(), b->material_id());
      for (const unsigned int face : a->face_indices())
        EXPECT_EQ(a->face(face)->boundary_id(), b->face(face)->boundary_id());
    }
  }
}

TEST(GmshFiles, MayHaveTagsOfPartitions)
{
  const Scratch scratch;
  const std::string text = content_of(SmallSector().write(scratch));
  const auto plain       = content(read(scratch.path("sector.msh"), 6));
  // number kind 2 id 1 nodes: the same without tags behind the id, and with partitions in turn
  const auto rewrite = [&](const std::function<std::string(int, int)> &tags)
  {
    std::istringstream lines(text);
    std::ostringstream out;
    bool in_elements = false;
    int number       = 0;
    for (std::string line; std::getline(lines, line); out << line << '\n')
    {
      in_elements = (in_elements || line == "$Elements") && line != "$EndElements";
      int e, kind, n_tags, id, entity;
      std::istringstream words(line);
      if (in_elements && words >> e >> kind >> n_tags >> id >> entity)
      {
        std::string rest;
        std::getline(words, rest);
        line = std::to_string(e) + ' ' + std::to_string(kind) + ' ' + tags(id, number++) + rest;
      }
    }
    return write(scratch, out.str());
  };
  const auto text_of = [](const int id) { return std::to_string(id); };
  EXPECT_EQ(content(read(rewrite([&](int id, int) { return "1 " + text_of(id); }), 6)), plain);
  EXPECT_EQ(content(read(rewrite([&](int id, int) { return "3 " + text_of(id) + " 1 0"; }), 6)),
            plain);
  EXPECT_EQ(content(read(rewrite([&](int id, int) { return "2 -" + text_of(id) + " 1"; }), 6)),
            plain);
  EXPECT_EQ(content(read(rewrite(
                             [&](int id, int number) {
                               return number % 2 == 0 ? "4 " + text_of(id) + " 1 1 1"
                                                      : "6 " + text_of(id) + " 1 3 2 -1 -3";
                             }),
                         6)),
            plain);
  // Part 2 of a mesh in several files
  std::string part = rewrite([&](int id, int) { return "4 " + text_of(id) + " 1 1 2"; });
  EXPECT_EQ(content(read(part, 6)), plain);
  expect_refusal(part, {"partition 2 alone", "PartitionSplitMeshFiles"}, 7);
  expect_refusal(rewrite([](int, int) { return "0"; }), {"its volumes have no physical ids"});
  expect_refusal(rewrite([](int, int) { return "2 0 1"; }),
                 {"its volumes have no physical ids", "1 (base)", "SaveAll"});
}

TEST(GmshFiles, AreRefusedWithTheOptionThatHelps)
{
  const Scratch scratch;
  const std::string text = content_of(folder / "gmsh_plain.msh");
  const std::size_t at   = text.find("4.1 0 8");
  const auto format      = [&](const std::string &words)
  { return write(scratch, text.substr(0, at) + words + text.substr(at + 7)); };
  expect_refusal(format("4.1 1 8"), {"binary", "Mesh.Binary = 0"}, 90);
  expect_refusal(format("2.2 1 8"), {"binary", "Mesh.Binary = 0"}, 90);
  expect_refusal(format("4 0 8"), {"version 4 of Gmsh's format", "Mesh.MshFileVersion"}, 90);
  expect_refusal(format("5.0 0 8"), {"version 5 of Gmsh's format", "2.2 or 4.1"}, 90);
  expect_refusal(format("4.1 0 4"), {"damaged"}, 90);
  expect_refusal(format("x 0 8"), {"damaged"}, 90);
}

TEST(GmshFiles, MayHaveFewDigits)
{
  const Scratch scratch;
  std::mt19937 random(1);
  for (const SectorForm form : {SectorForm::half, SectorForm::whole})
  {
    SmallSector sector(form);
    const auto exact = content(read(sector.write(scratch), 6));
    for (const int n_digits : {8, 9, 12})
      EXPECT_EQ(content(read(sector.write(scratch, 1., n_digits), 6)), exact) << n_digits;
    for (const int n_digits : {2, 3, 5, 6})
      expect_refusal(sector.write(scratch, 1., n_digits),
                     {"have " + std::to_string(n_digits) + " significant digits only",
                      "save at least 8 digits (Gmsh saves 16)"});
    // As single precision does, in every node otherwise
    std::uniform_real_distribution<double> error(-1., 1.);
    for (auto &[r, theta, z] : sector.nodes)
    {
      r *= 1. + 6e-8 * error(random);
      theta += 6e-8 * 180. / M_PI * error(random);
      z *= 1. + 6e-8 * error(random);
    }
    EXPECT_EQ(content(read(sector.write(scratch), 6)), exact);
  }
}

TEST(GmshFiles, HaveExactPlanesRadiiAndHeightsAfterReading)
{
  const Scratch scratch;
  for (const SectorForm form : {SectorForm::half, SectorForm::whole})
  {
    const SectorMesh mesh = read(SmallSector(form).write(scratch, 1., 8), 6);
    double r_outer = 0., z_top = 0.;
    for (const auto &x : mesh.triangulation->get_vertices())
    {
      r_outer = std::max(r_outer, cylindrical(x)[0]);
      z_top   = std::max(z_top, x[2]);
    }
    const double rounding = 1e-15;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        for (const unsigned int i : face->vertex_indices())
        {
          const dealii::Point<3> x = cylindrical(face->vertex(i));
          if (!face->at_boundary())
            continue;
          if (face->boundary_id() == ids::tooth_top)
          {
            EXPECT_EQ(x[2], z_top);
            EXPECT_LT(std::min(std::abs(x[0] - 30e-3), std::abs(x[0] - 20e-3)), 1e-9);
            if (x[0] > 25e-3)
            {
              EXPECT_NEAR(x[0], r_outer, rounding);
            }
          }
          if (face->boundary_id() == ids::mirror)
          {
            EXPECT_EQ(face->vertex(i)[1], 0.);
          }
          if (face->boundary_id() == ids::cut)
          {
            EXPECT_NEAR(x[1], M_PI / 6., rounding);
          }
        }
    if (form == SectorForm::whole)
    {
      std::map<dealii::types::boundary_id, std::multiset<std::vector<long>>> cuts;
      for (const auto &cell : mesh.triangulation->active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            for (const unsigned int i : face->vertex_indices())
            {
              dealii::Point<3> x = cylindrical(face->vertex(i));
              if (face->boundary_id() == ids::cut_high)
                x[1] -= M_PI / 3.;
              cuts[face->boundary_id()].insert(
                  {std::lround(1e14 * x[0]), std::lround(1e13 * x[1]), std::lround(1e16 * x[2])});
            }
      EXPECT_EQ(cuts[ids::cut_low], cuts[ids::cut_high]);
    }
  }
}
