// SPDX-License-Identifier: LGPL-2.1-or-later
//
// VTU files against the known wave of wave_field.h, evaluated at the positions found in the file.
// The order of the nodes in a Lagrange hexahedron is VTK's: corners, edges, faces, inside; the last
// two edges are 2-6, 3-7 in files of version 2.2 and vice versa before (release notes of VTK 9.1,
// "node numbering for VTK_LAGRANGE_HEXAHEDRON").

#include "scratch.h"
#include "vtu_file.h"
#include "wave_field.h"

#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/rotor_sector.h>
#include <ringmotor/output/body_vtu.h>
#include <ringmotor/output/files.h>
#include <ringmotor/output/vtu.h>
#include <ringmotor/parameters/errors.h>

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <numeric>
#include <regex>
#include <set>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  // Files hold floats, so positions are accurate to 2e-9 m and the wave to 1e-6 of its amplitude.
  constexpr double tolerance = 5e-12;

  void expect_motion(const VtuFile &file, const std::string &name, const WaveRing &ring,
                     const double time_angle)
  {
    const auto places = file.vectors(""), motions = file.vectors(name);
    ASSERT_EQ(places.size(), motions.size());
    double worst = 0.;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const auto exact = ring.motion(places[i], time_angle);
      for (unsigned int d = 0; d < 3; ++d)
        worst = std::max(worst, std::abs(motions[i][d] - exact[d]));
    }
    EXPECT_LT(worst, tolerance) << name;
  }

  void expect_energies(const VtuFile &file, const std::string &name, const WaveRing &ring,
                       const double factor)
  {
    const auto places = file.vectors("");
    const auto values = file.array<float>(name);
    ASSERT_EQ(places.size(), values.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      EXPECT_NEAR(values[i],
                  factor * ring.energy(std::hypot(places[i][0], places[i][1]), places[i][2]),
                  1e-4 * factor);
  }

  void expect_materials(const VtuFile &file, const WaveRing &ring)
  {
    // On the interface, points belong to one of the materials.
    const auto places    = file.vectors("");
    const auto materials = file.array<float>("material");
    ASSERT_EQ(places.size(), materials.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      if (std::abs(places[i][2] - ring.height / 2.) > 1e-6)
      {
        EXPECT_EQ(materials[i], places[i][2] < ring.height / 2. ? 1.f : 2.f);
      }
  }
} // namespace

TEST(Vtu, SectorShowsTheComplexAmplitude)
{
  const Scratch scratch;
  const WaveRing ring;
  write_sector(scratch.path("sector.vtu"), ring.field());
  const VtuFile file(scratch.path("sector.vtu"));

  EXPECT_EQ(file.count("Cells"), 8u);
  EXPECT_EQ(file.count("Points"), 8u * 27u);
  // Re(U e^{i omega t}): at omega t = 0 the real part, at a quarter of a period minus the
  // imaginary one, which is what the wave shows three quarters of a period after the start.
  expect_motion(file, "displacement_real", ring, 0.);
  expect_motion(file, "displacement_imaginary", ring, 1.5 * M_PI);
  expect_materials(file, ring);

  const auto places                           = file.vectors("");
  const std::array<std::string, 3> components = {{"radial", "tangential", "axial"}};
  for (unsigned int d = 0; d < 3; ++d)
  {
    const auto amplitudes = file.array<float>("amplitude_" + components[d]);
    ASSERT_EQ(amplitudes.size(), places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const double radius = std::hypot(places[i][0], places[i][1]);
      EXPECT_NEAR(amplitudes[i], std::abs(ring.profile(radius, places[i][2])[d]), tolerance);
    }
  }
  expect_energies(file, "strain_energy", ring, 1.);
}

TEST(Vtu, RingShowsAScalarInAllSectors)
{
  const Scratch scratch;
  const WaveRing ring;
  const SectorField field = ring.field();
  std::vector<std::vector<double>> values;
  for (const SectorField::Cell &cell : field.cells)
  {
    values.push_back(cell.strain_energy);
    for (double &value : values.back())
      value *= 3.;
  }
  write_ring_scalar(scratch.path("ring.vtu"), field, {"loss", 1, "W/m^3"}, values);
  const VtuFile file(scratch.path("ring.vtu"));
  EXPECT_EQ(file.count("Cells"), 8u * ring.n_sectors);
  expect_materials(file, ring);
  expect_energies(file, "loss", ring, 3.);
  double x = 0., y = 0.; // sectors all around
  for (const auto &place : file.vectors(""))
  {
    x += place[0];
    y += place[1];
  }
  EXPECT_LT(std::hypot(x, y), 1e-6 * file.count("Points") * ring.outer_radius);
}

TEST(Vtu, CellsAreLagrangeHexahedraInTheOrderOfVtk)
{
  const Scratch scratch;
  const WaveRing ring;
  write_sector(scratch.path("sector.vtu"), ring.field());
  const VtuFile file(scratch.path("sector.vtu"));

  const std::uint8_t lagrange_hexahedron = 72;
  EXPECT_EQ(file.array<std::uint8_t>("types"), std::vector<std::uint8_t>(8, lagrange_hexahedron));
  const auto offsets = file.array<std::int32_t>("offsets");
  for (unsigned int cell = 0; cell < 8; ++cell)
    EXPECT_EQ(offsets.at(cell), 27 * (static_cast<int>(cell) + 1));

  // Cells are boxes in (r, theta, z): a node between others lies at their mean there.
  const auto places                              = file.vectors("");
  const auto nodes                               = file.array<std::int32_t>("connectivity");
  std::vector<std::vector<unsigned int>> between = {{0, 1},
                                                    {1, 2},
                                                    {3, 2},
                                                    {0, 3},
                                                    {4, 5},
                                                    {5, 6},
                                                    {7, 6},
                                                    {4, 7},
                                                    {0, 4},
                                                    {1, 5},
                                                    {2, 6},
                                                    {3, 7},
                                                    {0, 3, 4, 7},
                                                    {1, 2, 5, 6},
                                                    {0, 1, 4, 5},
                                                    {3, 2, 7, 6},
                                                    {0, 1, 2, 3},
                                                    {4, 5, 6, 7},
                                                    {0, 1, 2, 3, 4, 5, 6, 7}};
  if (file.has_old_node_order())
    std::swap(between[10], between[11]);
  for (unsigned int cell = 0; cell < 8; ++cell)
  {
    const auto box = [&](const unsigned int node) -> std::array<double, 3>
    {
      const auto &place = places.at(nodes.at(27 * cell + node));
      return {{std::hypot(place[0], place[1]), std::atan2(place[1], place[0]), place[2]}};
    };
    // right-handed: 0-1 along r, 0-3 along theta, 0-4 along z
    EXPECT_GT(box(1)[0], box(0)[0] + 1e-3);
    EXPECT_GT(box(3)[1], box(0)[1] + 0.1);
    EXPECT_GT(box(4)[2], box(0)[2] + 1e-3);
    for (unsigned int i = 0; i < between.size(); ++i)
      for (unsigned int d = 0; d < 3; ++d)
      {
        double mean = 0.;
        for (const unsigned int corner : between[i])
          mean += box(corner)[d] / between[i].size();
        EXPECT_NEAR(box(8 + i)[d], mean, 1e-6) << "node " << 8 + i;
      }
  }
}

TEST(Vtu, RingAnimationIsTheTravellingWave)
{
  const Scratch scratch;
  WaveRing ring;
  ring.order = 3;
  write_ring_animation(scratch.path("wave"), ring.field(), 8);
  EXPECT_EQ(scratch.n_entries(), 9u);

  const std::string record = content_of(scratch.path("wave.pvd"));
  const std::regex entry("timestep=\"([^\"]+)\"[^>]*file=\"([^\"]+)\"");
  unsigned int frame = 0;
  for (std::sregex_iterator match(record.begin(), record.end(), entry), end; match != end;
       ++match, ++frame)
  {
    const double time = std::stod((*match)[1]);
    EXPECT_NEAR(time, frame / 8. / 30e3, 1e-16);
    const VtuFile file(scratch.path((*match)[2]));
    EXPECT_EQ(file.count("Cells"), 12u * 8u);
    EXPECT_EQ(file.count("Points"), 12u * 2u * 7u * 6u * 4u); // r, theta, z of both materials
    expect_motion(file, "displacement", ring, ring.angular_frequency * time);
    if (frame == 0)
      expect_materials(file, ring);
  }
  EXPECT_EQ(frame, 8u);
}

TEST(Vtu, RingHasItsNodesInTheOrderOfTheOtherWriter)
{
  const Scratch scratch;
  for (const unsigned int order : {1u, 2u, 3u, 4u})
  {
    WaveRing ring;
    ring.order = order;
    write_ring_animation(scratch.path("wave"), ring.field(), 1);
    write_sector(scratch.path("sector.vtu"), ring.field()); // by deal.II
    const VtuFile shared(scratch.path("wave_00.vtu")), apart(scratch.path("sector.vtu"));
    const auto nodes  = shared.array<std::int32_t>("connectivity");
    const auto other  = apart.array<std::int32_t>("connectivity");
    const auto places = shared.vectors(""), other_places = apart.vectors("");
    const unsigned int n_nodes = (order + 1) * (order + 1) * (order + 1), of_edge = order - 1;
    ASSERT_EQ(nodes.size(), 12u * 8u * n_nodes);
    ASSERT_EQ(other.size(), 8u * n_nodes); // the sector is the ring's first
    double worst = 0.;
    for (unsigned int i = 0; i < other.size(); ++i)
    {
      const unsigned int edge = of_edge > 0 && i % n_nodes >= 8 ? (i % n_nodes - 8) / of_edge : 0;
      unsigned int there      = i;
      if (shared.has_old_node_order() != apart.has_old_node_order())
        there = edge == 10 ? i + of_edge : edge == 11 ? i - of_edge : i;
      for (unsigned int d = 0; d < 3; ++d)
        worst =
            std::max(worst, std::abs(places.at(nodes[i])[d] - other_places.at(other[there])[d]));
    }
    EXPECT_LT(worst, 1e-8) << "order " << order;
  }
}

namespace
{
  /** Closed rings of hexahedra: each face belongs to two cells or, on the skin, to one, and the
   * number of edges of the skin's faces is that of tori (Euler: points - edges + faces = 0). */
  void expect_closed_ring(const VtuFile &file, const int points_per_cell)
  {
    const auto nodes                   = file.array<std::int32_t>("connectivity");
    const auto offsets                 = file.array<std::int32_t>("offsets");
    constexpr unsigned int sides[6][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                          {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    std::map<std::set<std::int32_t>, unsigned int> n_cells_of;
    std::map<std::set<std::int32_t>, std::array<std::int32_t, 4>> around;
    for (unsigned int cell = 0; cell < file.count("Cells"); ++cell)
    {
      EXPECT_EQ(offsets[cell], points_per_cell * static_cast<int>(cell + 1));
      for (const auto &side : sides)
      {
        std::array<std::int32_t, 4> corners;
        for (unsigned int v = 0; v < 4; ++v)
          corners[v] = nodes[points_per_cell * cell + side[v]];
        const std::set<std::int32_t> key(corners.begin(), corners.end());
        EXPECT_EQ(key.size(), 4u);
        ++n_cells_of[key];
        around[key] = corners;
      }
    }
    std::set<std::int32_t> points;
    std::map<std::set<std::int32_t>, unsigned int> edges;
    unsigned int n_faces = 0;
    for (const auto &[key, n] : n_cells_of)
    {
      EXPECT_LE(n, 2u);
      if (n == 1)
      {
        ++n_faces;
        points.insert(key.begin(), key.end());
        for (unsigned int v = 0; v < 4; ++v)
          ++edges[{around[key][v], around[key][(v + 1) % 4]}];
      }
    }
    for (const auto &[edge, n] : edges)
      EXPECT_EQ(n % 2, 0u);
    EXPECT_EQ(points.size() + n_faces, edges.size());
  }
} // namespace

TEST(Vtu, RingIsClosed)
{
  const Scratch scratch;
  const WaveRing ring;
  write_ring_animation(scratch.path("wave"), ring.field(), 1);
  // One of the corners per cell lies on each of 24 rays: 12 sectors of 2 cells.
  std::vector<unsigned int> n_per_ray(24, 0);
  const VtuFile file(scratch.path("wave_00.vtu"));
  const auto places = file.vectors("");
  const auto nodes  = file.array<std::int32_t>("connectivity");
  for (unsigned int cell = 0; cell < file.count("Cells"); ++cell)
  {
    const auto &corner = places.at(nodes.at(27 * cell));
    const double rays  = std::atan2(corner[1], corner[0]) / (2. * M_PI) * 24. + 24.;
    EXPECT_NEAR(rays, std::round(rays), 1e-5);
    ++n_per_ray[std::lround(rays) % 24];
  }
  EXPECT_EQ(n_per_ray, std::vector<unsigned int>(24, 4));
  expect_closed_ring(file, 27); // one of each material
}

TEST(Vtu, NoRecordOfFramesThatWereNotWritten)
{
  const Scratch scratch;
  write_ring_animation(scratch.path("wave"), WaveRing().field(), 2);
  std::filesystem::create_symlink("/dev/full", scratch.path("wave_01.vtu.part"));
  const std::string message = message_of<UserError>(
      [&]() { write_ring_animation(scratch.path("wave"), WaveRing().field(), 2); });
  EXPECT_NE(message.find("wave_01.vtu"), std::string::npos) << message;
  EXPECT_FALSE(std::filesystem::exists(scratch.path("wave.pvd")));
}

TEST(Vtu, BodyIsWhatItWasGiven)
{
  const Scratch scratch;
  const unsigned int n_sectors = 12;
  const SectorMesh mesh        = make_rotor_sector(rotor_body(RotorGeometry(), n_sectors),
                                                   SectorForm::half, {}, MPI_COMM_SELF);
  const SectorElements sector(
      mesh, {{ids::rotor, {68.9e9, 0.33, 2700., 0.}}, {ids::lip_shell, {68.9e9, 0.33, 2700., 0.}}},
      2);
  const RingBody body(sector, 1, 5e-3);
  PointField field{"displacement", "m", 3, {}}, gap{"gap", "m", 1, {}};
  for (const auto &point : body.points())
  {
    for (unsigned int d = 0; d < 3; ++d)
      field.values.push_back(static_cast<float>(1e-3 * point[(d + 1) % 3]));
    gap.values.push_back(point[0] > 0. ? std::numeric_limits<float>::quiet_NaN() : 1.f);
  }
  write_body(scratch.path("body.vtu"), body, {field, gap});

  const VtuFile file(scratch.path("body.vtu"));
  ASSERT_EQ(file.count("Points"), body.points().size());
  ASSERT_EQ(file.count("Cells"), 2 * n_sectors * mesh.n_cells());
  const auto places = file.vectors(""), values = file.vectors("displacement");
  const auto gaps = file.array<float>("gap");
  for (unsigned int i = 0; i < places.size(); ++i)
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      EXPECT_NEAR(places[i][d], body.points()[i][d], 1e-8);
      EXPECT_NEAR(values[i][d], 1e-3 * places[i][(d + 1) % 3], 1e-11);
    }
    EXPECT_EQ(std::isnan(gaps[i]), body.points()[i][0] > 0.);
  }
  expect_closed_ring(file, 8);
}

TEST(Vtu, NeighboursAtTheSameTimeArePartsOfOnePicture)
{
  const Scratch scratch;
  write_pvd(scratch.path("a.pvd"), {{0., "a"}, {0., "b"}, {0.5, "c"}});
  const std::string record = content_of(scratch.path("a.pvd"));
  for (const char *entry :
       {"timestep=\"0\" part=\"0\" file=\"a\"", "timestep=\"0\" part=\"1\" file=\"b\"",
        "timestep=\"0.5\" part=\"0\" file=\"c\""})
    EXPECT_NE(record.find(entry), std::string::npos) << record;
}
