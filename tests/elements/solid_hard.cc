// SPDX-License-Identifier: LGPL-2.1-or-later

// Solid elements of difficult materials, against exact solutions: a thick ring under inner pressure
// in plane strain (Lame) that is almost incompressible; two bars in series, one of them 1e6 times
// as stiff as the other.

#include "support/record.h"
#include "support/static_solid.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr double inner = 1., outer = 2., height = 0.5, pressure = 1e6, young = 1e9;

  bool zero(const double x)
  {
    return std::abs(x) < 1e-9;
  }

  /** A quarter of a ring about the z axis with n cells across and 2 n around. */
  void make_quarter(const unsigned int n, dealii::Triangulation<3> &quarter)
  {
    dealii::GridGenerator::subdivided_hyper_rectangle(
        quarter, {n, 2 * n, 1}, Point<3>(inner, 0., 0.), Point<3>(outer, M_PI / 2., height));
    dealii::GridTools::transform(
        [](const Point<3> &x)
        { return Point<3>(x[0] * std::cos(x[1]), x[0] * std::sin(x[1]), x[2]); },
        quarter);
    quarter.set_all_manifold_ids(0);
    quarter.set_manifold(0, dealii::CylindricalManifold<3>(2));
  }

  struct Errors
  {
    double widening, work; ///< relative: of the inner radius; of the pressure
  };

  Errors lame_ring(const unsigned int n, const unsigned int degree, const double nu)
  {
    dealii::Triangulation<3> quarter;
    make_quarter(n, quarter);
    const StaticSolid ring(
        quarter, {{0, {young, nu, 1., 0.}}}, degree,
        [](const unsigned int component, const Point<3> &x)
        { return component == 2 ? zero(x[2]) || zero(x[2] - height) : zero(x[component]); },
        [](const Point<3> &x)
        {
          const Tensor<1, 3> outward({x[0], x[1], 0.});
          const double radius = outward.norm();
          return radius < inner + 0.003 ? pressure / radius * outward : Tensor<1, 3>();
        });
    const double widening = (1. + nu) / young * pressure * inner / (outer * outer - inner * inner) *
                            ((1. - 2. * nu) * inner * inner + outer * outer);
    return {ring.displacement(0, Point<3>(inner, 0., 0.)) / widening - 1.,
            ring.work() / (0.5 * M_PI * inner * height * pressure * widening) - 1.};
  }

  std::string named(const unsigned int degree, const unsigned int n, const double nu)
  {
    return "degree " + std::to_string(degree) + ", " + std::to_string(n) +
           " cells across, nu = 0." + std::to_string(std::lround(1000. * nu));
  }

  /** Two cubes of 1 m along x, fixed at x = 0, pulled with 1 Pa at x = 2 m. */
  StaticSolid pulled_pair(const double first_young, const double second_young,
                          const unsigned int degree)
  {
    dealii::Triangulation<3> pair;
    dealii::GridGenerator::subdivided_hyper_rectangle(pair, {2, 1, 1}, Point<3>(),
                                                      Point<3>(2., 1., 1.));
    for (const auto &cell : pair.active_cell_iterators())
      cell->set_material_id(cell->center()[0] < 1. ? 0 : 1);
    return StaticSolid(
        pair, {{0, {first_young, 0., 1., 0.}}, {1, {second_young, 0., 1., 0.}}}, degree,
        [](const unsigned int component, const Point<3> &x) { return zero(x[component]); },
        [](const Point<3> &x) {
          return Tensor<1, 3>({zero(x[0] - 2.) ? 1. : 0., 0., 0.});
        });
  }
} // namespace

TEST(SolidMaterialsHard, AlmostIncompressibleRing)
{
  // The error grows like 1/(1 - 2 nu), from nu = 0.3 to 0.499 by about 150 at any degree, but still
  // decreases with the cell size at nearly its order. With 2 x 4 cells, degree 2 misses a tenth of
  // the widening at 0.499, degree 3 2e-3, degree 4 4e-5; with 4 x 8 cells, 1e-2, 5e-5 and 2e-7.
  struct Limits
  {
    unsigned int degree;
    double coarse, fine; ///< at 0.499
  };
  for (const Limits &limit :
       {Limits{2, 0.12, 0.011}, Limits{3, 2.6e-3, 6e-5}, Limits{4, 4.1e-5, 2.6e-7}})
    for (const auto &[n, largest] : {std::pair{2u, limit.coarse}, std::pair{4u, limit.fine}})
      for (const double nu : {0.3, 0.49, 0.499})
      {
        const Errors errors      = lame_ring(n, limit.degree, nu);
        const std::string name   = named(limit.degree, n, nu);
        const double limit_at_nu = largest * std::min(1., 1.6 * (1. - 2. * 0.499) / (1. - 2. * nu));
        record("relative errors of widening, work: " + name, errors.widening);
        record("relative errors of widening, work: " + name, errors.work);
        EXPECT_LT(std::abs(errors.widening), limit_at_nu) << name;
        EXPECT_LT(std::abs(errors.work), limit_at_nu) << name;
      }
}

TEST(SolidMaterialsHard, BarsInSeriesOfVeryDifferentStiffness)
{
  for (const unsigned int degree : {1u, 2u, 4u})
    for (const double first : {1e11, 1e5})
    {
      const double second    = 1e16 / first;
      const StaticSolid pair = pulled_pair(first, second, degree);
      const double middle    = pair.displacement(0, Point<3>(1., 1., 1.)),
                   end       = pair.displacement(0, Point<3>(2., 1., 1.));
      // Behind the soft bar, the stiff one moves by 1e6 times its stretch: that many digits are
      // lost.
      EXPECT_NEAR(middle * first, 1., first < second ? 1e-8 : 1e-11) << degree;
      EXPECT_NEAR((end - middle) * second, 1., first < second ? 1e-7 : 1e-11) << degree;
      record("relative errors of both bars, degree " + std::to_string(degree) +
                 (first < second ? ", soft one first" : ", stiff one first"),
             middle * first - 1.);
      record("relative errors of both bars, degree " + std::to_string(degree) +
                 (first < second ? ", soft one first" : ", stiff one first"),
             (end - middle) * second - 1.);
    }
}
