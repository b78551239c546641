// SPDX-License-Identifier: LGPL-2.1-or-later

// Modes of a ring with three different ears, from a mesh of the whole ring, against those of
// CalculiX on meshes of its own (ring_with_ears.csv, by benchmarks/ring_with_ears.py).

#include "support/motor_model.h"
#include "support/record.h"

#include <ringmotor/wave/ring_search.h>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  struct Frequency
  {
    double value, uncertainty; ///< Hz
  };

  std::vector<Frequency> by_calculix()
  {
    std::ifstream file(RINGMOTOR_SOURCE_DIR "/tests/wave/ring_with_ears.csv");
    std::vector<Frequency> frequencies;
    for (std::string line; std::getline(file, line);)
      if (std::isdigit(static_cast<unsigned char>(line[0])))
      {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        unsigned int mode;
        frequencies.emplace_back();
        words >> mode >> frequencies.back().value >> frequencies.back().uncertainty;
      }
    return frequencies;
  }

  Parameters ring_with_ears()
  {
    Parameters parameters             = paper_motor();
    parameters.stator.mesh_file       = RINGMOTOR_SOURCE_DIR "/tests/wave/ring_with_ears.msh";
    parameters.materials.stator_metal = {110e9, 0.33, 8800., 1e-3};
    parameters.modes.domain           = Domain::ring;
    parameters.modes.n_modes          = 12;
    return parameters;
  }
} // namespace

TEST(WholeRingLong, WithEarsHasTheFrequenciesOfTheOtherProgram)
{
  const std::vector<Frequency> expected = by_calculix();
  ASSERT_EQ(expected.size(), 12u);
  Parameters parameters      = ring_with_ears();
  parameters.accuracy.target = 2e-3;
  RingSearch search(parameters, MPI_COMM_SELF);
  search.find([](const Pass &) {});
  ASSERT_GE(search.modes().size(), expected.size());
  double largest = 0.;
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    const FoundRingMode &found = search.modes()[i];
    EXPECT_LE(found.frequency.relative_error(), 2e-3);
    EXPECT_NEAR(found.frequency.value, expected[i].value,
                found.frequency.error() + expected[i].uncertainty)
        << "mode " << i + 1;
    largest = std::max(largest, std::abs(found.frequency.value / expected[i].value - 1.));
  }
  record("largest relative difference of frequencies from the other program", largest);
  // The ears split pairs, by much more than the error bars.
  EXPECT_GT(search.modes()[1].computed / search.modes()[0].computed - 1., 3e-3);
}
