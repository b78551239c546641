// SPDX-License-Identifier: LGPL-2.1-or-later

// The square plate 10 x 10 x 1 m with hard simple support (no deflection and no tangential motion
// on its four sides): one of the few bodies whose natural frequencies are known exactly in three
// dimensions. Bending: roots of the Rayleigh-Lamb equation for the wave number pi/10 sqrt(m^2+n^2)
// (Srinivas, Rao and Rao 1970); in-plane shear, m = 1: the shear wave's c/20 = 155.0434 Hz.
// Eigenvalues of elements of degree p converge like h^(2p).

#include "support/materials.h"
#include "support/plain_problem.h"
#include "support/record.h"

#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;

namespace
{
  constexpr double width = 10., thickness = 1.;

  // (1, 1), (1, 2) twice, (1, 0) shear twice, (2, 2), (1, 3) twice
  const std::array<double, 8> exact{
      {45.971212, 109.856862, 109.856862, 155.0434, 155.0434, 168.819294, 205.864612, 205.864612}};

  bool is_held(const unsigned int component, const Point<3> &x)
  {
    const auto at_side = [&](const unsigned int d)
    { return std::abs(x[d]) < 1e-9 || std::abs(x[d] - width) < 1e-9; };
    return (at_side(0) && component != 0) || (at_side(1) && component != 1);
  }

  std::vector<double> frequencies(const unsigned int n_cells, const unsigned int n_through,
                                  const unsigned int degree)
  {
    dealii::Triangulation<3> plate;
    dealii::GridGenerator::subdivided_hyper_rectangle(
        plate, {n_cells, n_cells, n_through}, Point<3>(), Point<3>(width, width, thickness));
    for (const auto &cell : plate.active_cell_iterators())
      cell->set_material_id(ids::base);
    const PlainProblem problem(plate, all_of(steel), degree, is_held);
    std::vector<double> found;
    for (const double value : problem.nearest(0., exact.size()))
      found.push_back(frequency_of(value));
    return found;
  }
} // namespace

TEST(ThickPlate, HasTheExactFrequencies)
{
  const std::vector<double> found = frequencies(4, 1, 5);
  for (unsigned int i = 0; i < exact.size(); ++i)
  {
    record("relative errors of the eight lowest frequencies", found[i] / exact[i] - 1.);
    EXPECT_NEAR(found[i] / exact[i], 1., 2e-5) << "mode " << i;
    // from above, up to the digits of the target
    EXPECT_GT(found[i] / exact[i], 1. - 4e-7) << "mode " << i;
  }
}

TEST(ThickPlate, ConvergesAtTheExpectedOrder)
{
  const std::vector<double> coarse = frequencies(6, 1, 2), fine = frequencies(12, 2, 2);
  for (const unsigned int i : {0u, 1u, 3u, 5u, 6u})
  {
    const double order = std::log2((coarse[i] / exact[i] - 1.) / (fine[i] / exact[i] - 1.));
    record("orders of frequencies 1, 2, 4, 6, 7", order);
    EXPECT_GT(order, 3.5) << "mode " << i;
    EXPECT_LT(order, 4.7) << "mode " << i;
  }
}
