// SPDX-License-Identifier: LGPL-2.1-or-later

// The rotors of prm/soft_spring.prm and prm/stiff_spring.prm, flange solid and without bars,
// against an independent finite-element program: CalculiX 2.20, quadratic bricks (C3D20), a quarter
// of a wave with nine cells, cells of 0.08, 0.04 and 0.02 mm at the two re-entrant corners where
// the flange leaves the ring. Its frequencies are extrapolated from the last two meshes with the
// exponent of these corners, 1.089; their uncertainty is half of that step, and 4e-5 for the cells
// far from the corners. benchmarks/against_calculix.py prints them.

#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/wave/body_modes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  struct Frequency
  {
    std::string motor;
    unsigned int n_waves;
    Family family;
    double value;       ///< Hz, extrapolated
    double uncertainty; ///< Hz
  };
  // The four lowest modes with 7 and with 14 waves, ascending.
  const std::vector<Frequency> frequencies{
      {"Reference", 7, Family::in_plane, 35090.3, 1.6},
      {"Reference", 7, Family::out_of_plane, 38073.2, 3.8},
      {"Reference", 7, Family::cross_section, 46161.2, 20.7},
      {"Reference", 7, Family::torsion, 81163.9, 7.4},
      {"Reference", 14, Family::cross_section, 61703.8, 24.3},
      {"Reference", 14, Family::in_plane, 108837.8, 5.1},
      {"Reference", 14, Family::out_of_plane, 119680.5, 4.9},
      {"Reference", 14, Family::torsion, 156152.7, 7.5},
      {"StiffSpring", 7, Family::in_plane, 40526.5, 1.6},
      {"StiffSpring", 7, Family::out_of_plane, 42501.6, 1.8},
      {"StiffSpring", 7, Family::torsion, 80791.8, 8.6},
      {"StiffSpring", 7, Family::cross_section, 113746.0, 111.2},
      {"StiffSpring", 14, Family::cross_section, 116725.7, 84.5},
      {"StiffSpring", 14, Family::in_plane, 122417.3, 6.1},
      {"StiffSpring", 14, Family::out_of_plane, 126548.2, 24.4},
      {"StiffSpring", 14, Family::torsion, 167266.3, 14.8}};

  Parameters parameters_of(const std::string &motor)
  {
    Parameters parameters                 = paper_motor();
    parameters.modes.body                 = Body::rotor;
    parameters.modes.nodal_diameters      = {7, 14};
    parameters.modes.n_modes              = 4;
    parameters.rotor.flange_element       = ElementKind::solid;
    parameters.rotor.radial_bar_stiffness = 0.;
    parameters.accuracy.target            = 1e-3;
    if (motor == "StiffSpring")
    {
      stiffen_spring(parameters.rotor);
      parameters.accuracy.target = 2e-3; // to save time
    }
    return parameters;
  }

  /** Modes of @p n_waves, ascending. */
  std::vector<FoundMode> modes_of(const ModeSearch &search, const unsigned int n_waves)
  {
    std::vector<FoundMode> found;
    std::copy_if(search.modes().begin(), search.modes().end(), std::back_inserter(found),
                 [&](const FoundMode &mode) { return mode.mode.nodal_diameter == n_waves; });
    std::sort(found.begin(), found.end(),
              [](const FoundMode &a, const FoundMode &b)
              { return a.frequency.value < b.frequency.value; });
    return found;
  }

  class ReferenceRotor : public testing::TestWithParam<std::string>
  {
  };
} // namespace

TEST_P(ReferenceRotor, HasTheFrequenciesOfTheOtherProgram)
{
  BodyModes modes(parameters_of(GetParam()), MPI_COMM_WORLD);
  modes.find([](const Pass &) {});
  for (const unsigned int n_waves : {7u, 14u})
  {
    const std::vector<FoundMode> found = modes_of(modes.search(), n_waves);
    ASSERT_EQ(found.size(), 4u);
    auto mode = found.begin();
    for (const Frequency &row : frequencies)
      if (row.motor == GetParam() && row.n_waves == n_waves)
      {
        const Estimate &ours   = mode->frequency;
        const double tolerance = ours.error() + row.uncertainty;
        const std::string of   = "n = " + std::to_string(n_waves) + ", " + to_string(row.family);
        for (const double part :
             {ours.value / row.value - 1., ours.error() / ours.value, tolerance / row.value})
          record("relative difference, own error bar, tolerance: " + of, part);
        EXPECT_EQ(to_string(mode->content.family()), to_string(row.family)) << of;
        EXPECT_NEAR(ours.value, row.value, tolerance) << of;
        EXPECT_LT(tolerance, 3e-3 * row.value) << of; // a 1 % stiffer metal changes it by 5e-3
        ++mode;
      }
    EXPECT_EQ(mode, found.end());
  }
}

INSTANTIATE_TEST_SUITE_P(Motors, ReferenceRotor, testing::Values("Reference", "StiffSpring"),
                         [](const auto &info) { return info.param; });
