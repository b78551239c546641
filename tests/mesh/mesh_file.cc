// SPDX-License-Identifier: LGPL-2.1-or-later

// Every mistake in a mesh file is refused in one line that says where it is and what to do. Tested
// with a ring of six sectors with six cells each, written as Gmsh would, and with damaged copies of
// a file in meshes/; deal.II's reader must not print anything, hang or crash.

#include "mesh/small_sector.h"

#include <algorithm>
#include <functional>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  const std::string half_sector_file = RINGMOTOR_SOURCE_DIR "/meshes/canon_half_sector.msh";

  using Change = std::function<void(SmallSector &)>;

  void expect_refusal_after(const Change &change, const std::vector<std::string> &words,
                            const SectorForm form = SectorForm::whole)
  {
    const Scratch scratch;
    SmallSector sector(form);
    change(sector);
    expect_refusal(sector.write(scratch), words);
  }

} // namespace

TEST(MeshFile, TakesWellMadeFiles)
{
  const Scratch scratch;
  for (const auto form : {SectorForm::half, SectorForm::whole})
  {
    const SectorMesh mesh = read(SmallSector(form).write(scratch), 6);
    EXPECT_EQ(mesh.form, form);
    EXPECT_EQ(mesh.triangulation->n_active_cells(), 6u);
  }

  // Cuts need not be planes, only rotated copies of each other.
  SmallSector skewed;
  for (auto &node : skewed.nodes)
    node[1] += 1e3 * (node[0] - 25e-3) + 500. * node[2];
  EXPECT_EQ(read(skewed.write(scratch), 6).form, SectorForm::whole);

  // Line ends of another operating system
  std::string text = content_of(half_sector_file);
  for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + 2))
    text.insert(i, "\r");
  std::ofstream(scratch.path("dos.msh")) << text;
  EXPECT_EQ(read(scratch.path("dos.msh"), 90).triangulation->n_active_cells(), 111u);
}

TEST(MeshFile, RefusesFilesThatAreNoMeshes)
{
  const Scratch scratch;
  expect_refusal(scratch.path("missing.msh"), {"missing.msh", "cannot be opened"});
  expect_refusal(scratch.path(""), {"damaged, or not a mesh in Gmsh's ASCII format"});
  const auto refuse_text = [&](const std::string &text, const std::string &word)
  {
    std::ofstream(scratch.path("x.msh")) << text;
    expect_refusal(scratch.path("x.msh"), {word});
  };
  refuse_text("", "damaged");
  refuse_text("subsection Motor\nend\n", "damaged");
  refuse_text("$MeshFormat\n4.1 1 8\n\1\0\0\0\n$EndMeshFormat\n", "version 2.2 or 4.1");
  refuse_text("$MeshFormat\n4 0 8\n$EndMeshFormat\n", "version 2.2 or 4.1");
  refuse_text("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"base\"\n", "damaged");
}

TEST(MeshFile, RefusesNumbersOfNodesThatAreNoIntegers)
{
  const Scratch scratch;
  const std::string whole = content_of(SmallSector().write(scratch));
  const std::size_t fifth = whole.find("\n5 ") + 1;
  for (const std::string number : {".5", "-5", "5.5", "1e1", "99999999999999999999", "x"})
  {
    std::ofstream(scratch.path("other.msh"))
        << whole.substr(0, fifth) + number + whole.substr(fifth + 1);
    expect_refusal(scratch.path("other.msh"), {"damaged"});
  }
}

TEST(MeshFile, RefusesATruncatedFile)
{
  const Scratch scratch;
  const std::string path = scratch.path("part.msh");
  for (const std::string &whole :
       {content_of(half_sector_file), content_of(SmallSector().write(scratch))})
    for (std::size_t size = 0; size + 2 < whole.size(); size += 1 + whole.size() / 60)
    {
      std::ofstream(path) << whole.substr(0, size);
      expect_refusal(path, {"damaged"});
    }
}

TEST(MeshFile, RefusesAFileThatLacksALine)
{
  const Scratch scratch;
  const std::string whole = content_of(half_sector_file);
  const std::string path  = scratch.path("part.msh");
  unsigned int n_lines    = 0;
  // Lines of the geometry before the nodes may be missing.
  for (std::size_t begin = whole.find("$Nodes"); begin < whole.size(); ++n_lines)
  {
    const std::size_t end = whole.find('\n', begin) + 1;
    if (n_lines % 10 == 0)
    {
      std::ofstream(path) << whole.substr(0, begin) << whole.substr(end);
      expect_refusal(path, {"damaged"});
    }
    begin = end;
  }
  EXPECT_GT(n_lines, 500u);
}

TEST(MeshFile, RefusesOtherElements)
{
  const auto replace_by = [](const int type, const std::vector<int> &nodes)
  {
    return [=](SmallSector &sector)
    {
      sector.elements[3].type  = type;
      sector.elements[3].nodes = nodes;
    };
  };
  const int first = SmallSector::at(0, 1, 1);
  expect_refusal_after(replace_by(4, {first, first + 1, first + 2, first + 8}), {"tetrahedra"});
  expect_refusal_after(
      replace_by(6, {first, first + 1, first + 2, first + 8, first + 9, first + 10}),
      {"not hexahedra of first order"});
  expect_refusal_after(replace_by(17, std::vector<int>(20, first)), {"first order", "recombine"});
  expect_refusal_after(
      [](SmallSector &sector)
      { sector.elements.erase(sector.elements.begin(), sector.elements.begin() + 6); },
      {"no volume elements", "physical volumes 1 (base), 2 (tooth) and 3"});
  expect_refusal_after([](SmallSector &sector) { sector.elements[0].nodes[2] = 99; }, {"damaged"});
}

TEST(MeshFile, RefusesUnknownAndMissingIds)
{
  const auto rename = [](const int id, const int other)
  { return [=](SmallSector &sector) { sector.mark_all(id, other); }; };
  expect_refusal_after(rename(ids::tooth, 9), {"physical id 9", "1 (base), 2 (tooth) and 3"});
  expect_refusal_after(rename(ids::tooth, 0), {"physical id 0"});
  expect_refusal_after(rename(ids::tooth_top, 22), {"physical id 22", "15 (tooth top)"});
  expect_refusal_after(rename(ids::cut_low, 0), {"the cuts are not marked", "11", "13 and 14"});
  expect_refusal_after(rename(ids::cut, 0), {"the cuts are not marked"}, SectorForm::half);
  expect_refusal_after(rename(ids::tooth_top, ids::mirror), {"half and of a whole"});
  expect_refusal_after(rename(ids::cut_low, ids::cut_high), {"the cuts are not marked"});
  const auto inside = [](SmallSector &sector)
  {
    sector.add(3, ids::tooth_top,
               {sector.at(0, 0, 1), sector.at(1, 0, 1), sector.at(1, 1, 1), sector.at(0, 1, 1)});
  };
  expect_refusal_after(inside, {"physical surface lies inside the body"});
}

TEST(MeshFile, RefusesLengthsInOtherUnitsAndABodyAtTheAxis)
{
  const Scratch scratch;
  expect_refusal(SmallSector().write(scratch, 1e3), {"30 m", "mm", "ScalingFactor = 0.001"});
  expect_refusal(SmallSector().write(scratch, 1e-3), {"30 um", "in m"});
  expect_refusal_after(
      [](SmallSector &sector)
      {
        for (auto &node : sector.nodes)
          node[0] -= 20e-3;
      },
      {"axis of rotation"});
}

TEST(MeshFile, RefusesASectorThatDoesNotFitTheNumberOfTeeth)
{
  const Scratch scratch;
  expect_refusal(SmallSector().write(scratch),
                 {"is 60 degrees", "must be 51.428571 degrees", "Motor/Number of teeth = 7"}, 7);
  expect_refusal(SmallSector(SectorForm::half).write(scratch),
                 {"cut (physical id 12)", "theta = 30 degrees", "at 25.714286 degrees",
                  "Motor/Number of teeth = 7"},
                 7);
  const auto turn = [](const double angle)
  {
    return [=](SmallSector &sector)
    {
      for (auto &node : sector.nodes)
        node[1] += angle;
    };
  };
  expect_refusal_after(turn(1.), {"mirror plane (physical id 11)", "at 0 degrees"},
                       SectorForm::half);
  expect_refusal_after(turn(90.), {"from 60 degrees to 120 degrees", "theta = 0"});
  expect_refusal_after(turn(180.), {"from the cut 13 to the cut 14", "theta = 0 in between"});
  const auto swap = [](SmallSector &sector)
  {
    sector.mark_all(ids::cut_low, 99);
    sector.mark_all(ids::cut_high, ids::cut_low);
    sector.mark_all(99, ids::cut_high);
  };
  expect_refusal_after(swap, {"is -60 degrees", "must be 60 degrees"});
}

TEST(MeshFile, RefusesCutsThatDoNotMatch)
{
  expect_refusal_after([](SmallSector &sector) { sector.nodes[sector.at(1, 3, 1)][2] += 1e-5; },
                       {"do not match", "r = 30 mm, theta = 30 degrees, z = 5.01 mm", "Periodic"});
  expect_refusal_after([](SmallSector &sector) { sector.nodes[sector.at(1, 3, 1)][1] += 1e-3; },
                       {"60.001 degrees"});
  const auto unmark = [](const unsigned int face)
  { return [=](SmallSector &sector) { sector.elements[face].id = 0; }; };
  expect_refusal_after(unmark(6), {"has no partner on 13"});
  expect_refusal_after(unmark(7), {"6 and 4 nodes"});
  expect_refusal_after(
      [&](SmallSector &sector)
      {
        unmark(6)(sector);
        unmark(7)(sector);
      },
      {"theta = -30 degrees", "not marked", "physical surface 13"});
  expect_refusal_after(unmark(6), {"theta = 0 degrees", "not marked", "physical surface 11"},
                       SectorForm::half);
}

TEST(MeshFile, RefusesCellsOutsideTheSector)
{
  // The tooth of a half sector reaches beyond the cut, or beyond the mirror plane.
  for (const int j : {0, 3})
    expect_refusal_after(
        [&](SmallSector &sector)
        {
          sector.elements[j == 0 ? 8 : 9].id = 0;
          for (const int i : {0, 1})
            sector.nodes[sector.at(i, j, 2)][1] += j == 0 ? -1. : 1.;
        },
        {j == 0 ? "theta = -1 degrees" : "theta = 31 degrees", "outside the sector"},
        SectorForm::half);
}

TEST(MeshFile, RefusesDamagedCells)
{
  expect_refusal_after([](SmallSector &sector)
                       { std::swap(sector.elements[3].nodes[0], sector.elements[3].nodes[1]); },
                       {"inverted or has no volume"});
  expect_refusal_after([](SmallSector &sector) { sector.nodes[sector.at(0, 1, 2)][2] = 4e-3; },
                       {"inverted or has no volume", "deg"});
  expect_refusal_after(
      [](SmallSector &sector)
      {
        for (auto &[r, theta, z] : sector.nodes)
          z = std::min(z, 5e-3); // a tooth without height
      },
      {"inverted or has no volume", "z = 5 mm"});
  expect_refusal_after([](SmallSector &sector)
                       { sector.elements[3].nodes[0] = sector.elements[3].nodes[1]; },
                       {"a node twice", "no volume", "theta = "});
  const auto repeat = [](const unsigned int element)
  { return [=](SmallSector &sector) { sector.elements.push_back(sector.elements[element]); }; };
  expect_refusal_after(repeat(0), {"cells lie on one another"});
  expect_refusal_after(repeat(1), {"more than two cells meet", "theta = ", "one physical id"});
}

TEST(MeshFile, RefusesABodyInPieces)
{
  const auto part_tooth = [](const double gap)
  {
    return [=](SmallSector &sector)
    {
      for (int i = 0; i < 8; ++i)
      {
        sector.nodes.push_back(sector.nodes[8 + i]);
        sector.nodes.back()[2] += gap;
      }
      for (auto &element : sector.elements)
        if (element.id == ids::tooth || (element.type == 3 && element.nodes[3] >= 16))
          for (int &node : element.nodes)
            node = node >= 8 && node < 16 ? node + 16 : node;
    };
  };
  expect_refusal_after(part_tooth(0.), {"8 nodes lie on others", "BooleanFragments"});
  expect_refusal_after(part_tooth(1e-4), {"only 3 of its 6 cells are connected"});
}
