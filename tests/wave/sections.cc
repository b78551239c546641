// SPDX-License-Identifier: LGPL-2.1-or-later

// Modes of bodies that are revolved cross-sections. Thin annular plates that are clamped at the
// inner and free at the outer edge, of one thickness and with a step, tend to Kirchhoff's plate,
// lambda^2 = omega a^2 sqrt(rho h / D), whose values are roots of determinants of Bessel functions
// (benchmarks/annular_plates.py): layers as wide as the plate is thick run along its edges, so
// three thicknesses are extrapolated with h and h^2. And the sections in meshes/ and tests/sections
// have the frequencies that CalculiX finds with meshes of its own
// (structure/sections_calculix.csv).

#include "support/materials.h"
#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/section_layers.h>
#include <ringmotor/wave/body_modes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;

namespace
{
  constexpr double inner = 10e-3, step = 20e-3, outer = 30e-3; // m

  /** Blocks between lines of r and z, some of which are missing. */
  template <typename IsThere>
  Section blocks(const std::vector<double> &r, const std::vector<double> &z,
                 const IsThere &is_there)
  {
    Section section;
    const unsigned int n = r.size();
    for (const double height : z)
      for (const double radius : r)
        section.points.emplace_back(radius, height);
    for (unsigned int j = 0; j + 1 < z.size(); ++j)
      for (unsigned int i = 0; i + 1 < n; ++i)
        if (is_there(i, j))
        {
          section.cells.push_back(
              {{{j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i}}, ids::base});
          if (i == 0)
            section.names[Section::edge(j * n, (j + 1) * n)] = ids::clamped;
        }
    return section;
  }

  Section even_plate(const double h)
  {
    return blocks({inner, 16e-3, 22e-3, outer - 2. * h, outer}, {-0.5 * h, 0.5 * h},
                  [](const unsigned int, const unsigned int) { return true; });
  }

  /** Twice as thick outside, both parts symmetric about z = 0. */
  Section stepped_plate(const double h)
  {
    return blocks({inner, 15e-3, step, 25e-3, outer - 4. * h, outer}, {-h, -0.5 * h, 0.5 * h, h},
                  [](const unsigned int i, const unsigned int j) { return i >= 2 || j == 1; });
  }

  /** The lowest frequency over that of Kirchhoff's plate. */
  double ratio(const Section &section, const double h, const unsigned int n, const double lambda)
  {
    const SectorMesh mesh = make_sector({section, {36}}, SectorForm::half, {1, 1}, MPI_COMM_SELF);
    const CyclicSector sector(mesh, all_of(steel), 4);
    const double nu = steel.poisson_ratio;
    const double thin =
        lambda / (outer * outer) *
        std::sqrt(steel.young_modulus * h * h / (12. * (1. - nu * nu) * steel.density));
    return std::sqrt(ModeSolver(sector).lowest(n, 1).front().eigenvalue) / thin;
  }

  void expect_limit(const std::function<Section(double)> &plate, const unsigned int n,
                    const double lambda)
  {
    std::vector<double> of_thickness;
    for (const double relative : {0.02, 0.01, 0.005})
      of_thickness.push_back(ratio(plate(relative * outer), relative * outer, n, lambda));
    const double limit = (8. * of_thickness[2] - 6. * of_thickness[1] + of_thickness[0]) / 3.;
    record("relative error of the limit, n = " + std::to_string(n), limit - 1.);
    EXPECT_NEAR(limit, 1., 5e-5) << n;
  }
} // namespace

TEST(ClampedPlate, TendsToKirchhoffs)
{
  const std::vector<double> exact{7.323520538, 7.28778487, 8.657463531, 13.69103714, 22.26153396};
  for (unsigned int n = 0; n < exact.size(); ++n)
    expect_limit(even_plate, n, exact[n]);
}

TEST(ClampedPlate, WithAStepTendsToKirchhoffs)
{
  const std::vector<double> exact{7.147523849, 6.571162951, 10.05181533, 21.66202724, 39.33751429};
  for (unsigned int n = 0; n < exact.size(); ++n)
    expect_limit(stepped_plate, n, exact[n]);
}

namespace
{
  struct Frequency
  {
    unsigned int n_waves;
    double value, uncertainty; ///< Hz
  };

  /** Those of a section, ascending for each nodal diameter. */
  std::vector<Frequency> by_calculix(const std::string &section)
  {
    std::ifstream file(RINGMOTOR_SOURCE_DIR "/tests/structure/sections_calculix.csv");
    std::vector<Frequency> frequencies;
    for (std::string line; std::getline(file, line);)
      if (line.rfind(section + ",", 0) == 0)
      {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        std::string name;
        unsigned int mode;
        frequencies.emplace_back();
        Frequency &row = frequencies.back();
        words >> name >> row.n_waves >> mode >> row.value >> row.uncertainty;
      }
    EXPECT_GE(frequencies.size(), 44u) << section;
    return frequencies;
  }

  Parameters with_section(const Body body, const std::string &file)
  {
    Parameters parameters    = paper_motor();
    parameters.modes.body    = body;
    parameters.motor.n_teeth = 90;
    (body == Body::rotor ? parameters.rotor.section_file : parameters.stator.section_file) =
        RINGMOTOR_SOURCE_DIR "/" + file;
    return parameters;
  }

  Parameters disc_rotor()
  {
    Parameters parameters                 = with_section(Body::rotor, "meshes/disc60_rotor.msh");
    parameters.rotor.radial_bar_stiffness = 0.;
    parameters.materials.rotor_metal      = {68.9e9, 0.33, 2700., 1e-3};
    parameters.materials.lining           = {2e9, 0.35, 1500., 1e-2};
    return parameters;
  }

  Parameters stepped_ring()
  {
    Parameters parameters = with_section(Body::stator, "tests/sections/stepped_ring.msh");
    parameters.materials.stator_metal = {110e9, 0.33, 8800., 1e-3};
    return parameters;
  }

  Parameters disc_stator()
  {
    Parameters parameters             = with_section(Body::stator, "meshes/disc60_stator.msh");
    parameters.stator.slot_width      = 0.7e-3;
    parameters.materials.stator_metal = {110e9, 0.33, 8800., 1e-3};
    parameters.materials.piezoceramic = {81e9, 0.31, 7600., 1e-3};
    return parameters;
  }

  void expect_frequencies(Parameters parameters, const std::string &section,
                          const std::vector<unsigned int> &n_waves, const unsigned int n_modes,
                          const double target)
  {
    parameters.modes.nodal_diameters = n_waves;
    parameters.modes.n_modes         = n_modes;
    parameters.accuracy.target       = target;
    BodyModes modes(parameters, MPI_COMM_WORLD);
    modes.find([](const Pass &) {});
    const std::vector<Frequency> expected = by_calculix(section);
    for (const unsigned int n : n_waves)
    {
      std::vector<Estimate> found;
      for (const FoundMode &mode : modes.search().modes())
        if (mode.mode.nodal_diameter == n)
          found.push_back(mode.frequency);
      std::sort(found.begin(), found.end(),
                [](const Estimate &a, const Estimate &b) { return a.value < b.value; });
      ASSERT_EQ(found.size(), n_modes);
      auto ours = found.begin();
      for (const Frequency &row : expected)
        if (row.n_waves == n && ours != found.end())
        {
          const std::string of   = section + ", n = " + std::to_string(n);
          const double tolerance = ours->error() + row.uncertainty;
          record("relative difference: " + of, ours->value / row.value - 1.);
          EXPECT_NEAR(ours->value, row.value, tolerance) << of;
          EXPECT_LT(tolerance, 2. * target * row.value) << of; // 1 % of stiffness: 5e-3
          ++ours;
        }
    }
  }
} // namespace

TEST(Sections, HaveTheFrequenciesOfTheOtherProgram)
{
  expect_frequencies(disc_rotor(), "disc_rotor", {2, 9}, 1, 2e-3);
  expect_frequencies(stepped_ring(), "stepped_ring", {0, 2, 9}, 2, 2e-3);
}

TEST(SectionsLong, HaveAllFrequenciesOfTheOtherProgram)
{
  std::vector<unsigned int> all;
  for (unsigned int n = 0; n <= 10; ++n)
    all.push_back(n);
  expect_frequencies(disc_rotor(), "disc_rotor", all, 4, 1e-3);
  expect_frequencies(stepped_ring(), "stepped_ring", all, 4, 1e-3);
  expect_frequencies(disc_stator(), "disc_stator", {0, 1, 2, 5, 9}, 3, 2e-3);
}
