// SPDX-License-Identifier: LGPL-2.1-or-later

// Rings of ceramic between two electrodes. Expected values: frequencies, capacitances and charges
// of the axisymmetric vibrations of a thin ring in its plane, from Bessel functions (plane stress),
// for both faces at one potential and for an insulated face. Consistency: the modes of half and
// whole sectors; the pole of the response at a mode against the charge of that mode.

#include "output/scratch.h"
#include "support/materials.h"
#include "support/ring_sector.h"

#include <ringmotor/parameters/errors.h>
#include <ringmotor/structure/electric_response.h>
#include <ringmotor/structure/modes.h>
#include <ringmotor/structure/motion_products.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::numbers::PI;

namespace
{
  /** A ceramic poled along z.
   * @param c c11, c12, c13, c33, c44 in GPa
   * @param e e31, e33, e15 in C/m^2
   * @param permittivity eps11, eps33 at constant strain in nF/m */
  PiezoelectricLaw law_of(const std::array<double, 5> &c, const std::array<double, 3> &e,
                          const std::array<double, 2> &permittivity)
  {
    Piezoelectricity constants;
    constants.c11            = 1e9 * c[0];
    constants.c12            = 1e9 * c[1];
    constants.c13            = 1e9 * c[2];
    constants.c33            = 1e9 * c[3];
    constants.c44            = 1e9 * c[4];
    constants.coupling31     = e[0];
    constants.coupling33     = e[1];
    constants.coupling15     = e[2];
    constants.permittivity11 = 1e-9 * permittivity[0];
    constants.permittivity33 = 1e-9 * permittivity[1];
    return constants.law();
  }

  /** PZT-4 as in the tables. */
  Material ceramic(const double e31 = -4.1)
  {
    Material material{80e9, 0.3, 7500., 0.};
    material.law = law_of({{132., 71., 73., 115., 26.}}, {{e31, 14.1, 10.5}}, {{7.124, 5.841}});
    return material;
  }

  /** A ring of 0.1 to 0.6 m in radius. It is so thin that stresses across it hardly matter. */
  class ThinRing
  {
  public:
    explicit ThinRing(const Material &material)
        : mesh(rectangular_ring(0.1, std::vector<double>(5, 0.1), thickness, 1, 24,
                                SectorForm::half, 1)),
          response(mesh, all_of(material), 4)
    {
    }

    /** In F, for a thickness of 20 mm. */
    double capacitance(const double frequency)
    {
      const double square = std::pow(2. * PI * frequency, 2);
      response.condense(square);
      return response.capacitances(0, {0})(0, 0).real() * thickness / 0.02;
    }

    /** Where @p function has a zero near a frequency. */
    template <typename Function>
    static double zero(const Function &function, const double near)
    {
      double a = near, b = near * (1. + 1e-3), at_a = function(a), at_b = function(b);
      for (unsigned int i = 0; i < 6 && std::abs(b - a) > 1e-9 * near; ++i)
      {
        const double c = b - at_b * (b - a) / (at_b - at_a);
        a = b, at_a = at_b, b = c, at_b = function(c);
      }
      return b;
    }
    double short_circuit(const double near)
    {
      return zero([&](const double f) { return 1. / capacitance(f); }, near);
    }
    double open_circuit(const double near)
    {
      return zero([&](const double f) { return capacitance(f); }, near);
    }

  private:
    static constexpr double thickness = 0.002;
    const SectorMesh mesh;
    ElectricResponse response;
  };
} // namespace

TEST(PiezoelectricRing, ContourModes)
{
  ThinRing ring(ceramic());
  const auto expect = [&](const double found, const double expected)
  { EXPECT_NEAR(found, expected, 1e-4 * expected); };
  const double short_circuit[] = {1669.69493, 4293.58556, 7235.99064, 10443.1644};
  const double open[]          = {1852.40002, 4475.64566, 7258.18770, 10539.5779};
  const double k_square[]      = {0.187535, 0.0797012, 0.00610707, 0.0182118};
  for (unsigned int m = 0; m < 4; ++m)
  {
    const double f_r = ring.short_circuit(short_circuit[m]), f_a = ring.open_circuit(open[m]);
    expect(f_r, short_circuit[m]);
    expect(f_a, open[m]);
    EXPECT_NEAR(1. - std::pow(f_r / f_a, 2), k_square[m], 1e-4 * k_square[m] + 2e-5);
  }
}

TEST(PiezoelectricRing, ChargesPerVolt)
{
  ThinRing ring(ceramic());
  const auto expect = [&](const double frequency, const double expected)
  { EXPECT_NEAR(ring.capacitance(frequency), expected, 1e-4 * std::abs(expected)) << frequency; };
  expect(1., 5.8591936e-7);
  expect(834.8474659, 6.2464154e-7);
  expect(1758.6764679, -5.3718765e-7);
  expect(2820.1840299, 4.4323219e-7);
  expect(5690.8461663, 3.8691367e-7);
}

// The sign of e31 opposite to that of e33, as it must be in a ceramic: otherwise a fifth remains.
TEST(PiezoelectricRing, WrongSignOfCoupling)
{
  ThinRing ring(ceramic(4.1));
  const double f_r = ring.short_circuit(1669.);
  EXPECT_NEAR(1. - std::pow(f_r / ring.open_circuit(1.018 * f_r), 2), 0.035, 5e-4);
}

TEST(PiezoelectricRing, HalfAndWholeSectors)
{
  std::vector<Mode> modes[2];
  for (const SectorForm form : {SectorForm::half, SectorForm::whole})
  {
    const SectorMesh mesh =
        rectangular_ring(0.8, {0.1, 0.1}, 0.1, 2, 12, form, form == SectorForm::half ? 1 : 2);
    const CyclicSector sector(mesh, all_of(ceramic()), 3);
    ModeSolver solver(sector);
    const double shift               = solver.shift_above(3, 4, 0.);
    modes[form == SectorForm::whole] = solver.below(3, shift); // complete, or it throws
  }
  ASSERT_GE(modes[0].size(), 4);
  ASSERT_EQ(modes[0].size(), modes[1].size());
  for (unsigned int i = 0; i < modes[0].size(); ++i)
    EXPECT_NEAR(modes[1][i].eigenvalue, modes[0][i].eigenvalue, 1e-8 * modes[0][i].eigenvalue);
}

// Near a mode the charge of harmonic l per volt of harmonic k is Q_l conj(Q_k) / (mass times the
// distance of the squares of frequencies), with charges Q and the mass of the ring's mode.
class PoleOfTheResponse : public ::testing::TestWithParam<SectorForm>
{
};

TEST_P(PoleOfTheResponse, FollowsFromTheMode)
{
  const SectorForm form = GetParam();
  const bool is_half    = form == SectorForm::half;
  const SectorMesh mesh = rectangular_ring(0.8, {0.1, 0.1}, 0.1, 1, 12, form, is_half ? 1 : 2);
  const CyclicSector sector(mesh, all_of(ceramic()), 3);
  ModeSolver solver(sector);
  ElectricResponse response(mesh, all_of(ceramic()), 3);
  const std::vector<int> harmonics{3, -9, 15};
  const auto at = [&](const double shift)
  {
    response.condense(shift);
    return response.capacitances(3, harmonics);
  };
  for (const Mode &mode : solver.below(3, solver.shift_above(3, 3, 0.)))
  {
    const double mass =
        motion_products(sector, {&mode.motion}).front().mass * 12 * (is_half ? 2. : 1.);
    const double distance = 1e-4 * mode.eigenvalue;
    const auto below = at(mode.eigenvalue - distance), above = at(mode.eigenvalue + distance);
    const std::vector<std::complex<double>> charges =
        electrode_charges(sector, mode.motion, harmonics);
    double largest = 0.;
    for (const std::complex<double> &charge : charges)
      largest = std::max(largest, std::norm(charge) / mass / distance);
    for (unsigned int l = 0; l < harmonics.size(); ++l)
      for (unsigned int k = 0; k < harmonics.size(); ++k)
      {
        const std::complex<double> expected = charges[l] * std::conj(charges[k]) / mass / distance;
        EXPECT_LT(std::abs(0.5 * (below(l, k) - above(l, k)) - expected), 1e-4 * largest);
        EXPECT_LT(std::abs(below(l, k) - std::conj(below(k, l))), 1e-8 * largest);
      }
  }
}

INSTANTIATE_TEST_SUITE_P(PiezoelectricRing, PoleOfTheResponse,
                         ::testing::Values(SectorForm::half, SectorForm::whole));

namespace
{
  /** PIC 255 as fitted by Parashar, DasGupta and Hagedorn (2013), poled along x: the radius in the
   * middle of a sector. In narrow sectors the constants turn with it. */
  Material radially_poled()
  {
    const PiezoelectricLaw along_z =
        law_of({{110.8, 63.26, 68.96, 110.8, 19.09}}, {{-5.6, 12.8, 10.3}}, {{9.06, 10.28}});
    // x, y, z there are z, x, y here.
    const std::array<unsigned int, 6> strain{{2, 0, 1, 5, 3, 4}};
    const std::array<unsigned int, 3> axis{{2, 0, 1}};
    Material material{60e9, 0.3, 7800., 0.};
    material.law = along_z;
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        material.law->stiffness[i][j] = along_z.stiffness[strain[i]][strain[j]];
    for (unsigned int a = 0; a < 3; ++a)
    {
      for (unsigned int j = 0; j < 6; ++j)
        material.law->coupling[a][j] = along_z.coupling[axis[a]][strain[j]];
      for (unsigned int b = 0; b < 3; ++b)
        material.law->permittivity[a][b] = along_z.permittivity[axis[a]][axis[b]];
    }
    return material;
  }

  /** Natural frequencies (Hz) without waves around the ring, both faces short-circuited. */
  std::vector<double> frequencies(const SectorMesh &mesh, const MaterialTable &materials,
                                  const unsigned int n_modes)
  {
    const CyclicSector sector(mesh, materials, 4);
    ModeSolver solver(sector);
    std::vector<double> found;
    for (const Mode &mode : solver.below(0, solver.shift_above(0, n_modes, 0.)))
      found.push_back(std::sqrt(mode.eigenvalue) / (2. * PI));
    return found;
  }
} // namespace

// Two of the modes without waves that a voltage between the flat faces drives, as its field shears
// the ceramic: measured by Parashar et al., and from commercial solid models there with the same
// constants.
TEST(PiezoelectricRing, RadiallyPoled)
{
  constexpr unsigned int n = 180;
  const auto expect = [](const double found, const double solid_model, const double tolerance,
                         const double measured)
  {
    EXPECT_NEAR(found, solid_model, tolerance * solid_model);
    EXPECT_NEAR(found, measured, 0.07 * measured);
  };
  const SectorMesh free_ring =
      rectangular_ring(0.005, std::vector<double>(4, 0.001875), 0.004, 2, n, SectorForm::half, 1);
  const auto of_free = frequencies(free_ring, all_of(radially_poled()), 6); // two rigid
  expect(of_free[2], 26191., 1e-4, 27919.);
  expect(of_free[5], 132303., 1e-4, 131275.);

  // Where the inner rim is fixed, a core that is too heavy and too stiff to move
  const SectorMesh fixed_ring =
      rectangular_ring(0.0015, {0.0005, 0.0001, 0.0003, 0.0008, 0.0018, 0.0025, 0.0025, 0.002},
                       0.003, 4, n, SectorForm::half, 1);
  for (const auto &cell : fixed_ring.triangulation->active_cell_iterators())
    if (std::hypot(cell->center()[0], cell->center()[1]) < 0.002)
      cell->set_material_id(ids::tooth);
  MaterialTable materials = all_of(radially_poled());
  materials[ids::tooth]   = {60e14, 0.3, 7800e5, 0.};
  const auto of_fixed     = frequencies(fixed_ring, materials, 6);

  expect(of_fixed[3], 12651., 4e-4, 12224.); // stresses at the rim are singular
  expect(of_fixed[4], 55728., 4e-4, 54752.);
}

// Where the mesh is shared, modes and charges are the same.
TEST(PiezoelectricRanks, SameCharges)
{
  const auto charge = [](MPI_Comm communicator)
  {
    const SectorMesh mesh =
        rectangular_ring(0.8, {0.1, 0.1}, 0.1, 2, 12, SectorForm::half, 1, communicator);
    ElectricResponse response(mesh, all_of(ceramic()), 2);
    response.condense(1e6);
    return response.capacitances(3, {3})(0, 0).real();
  };
  const double alone = charge(MPI_COMM_SELF);
  EXPECT_NEAR(charge(MPI_COMM_WORLD), alone, 1e-9 * std::abs(alone));
}

TEST(PiezoelectricRing, MustBeAFlatLayer)
{
  // A step in the lower face, and a lower face that slopes everywhere
  for (const bool has_step : {true, false})
  {
    const SectorMesh mesh =
        rectangular_ring(0.1, std::vector<double>(4, 0.1), 0.02, 2, 24, SectorForm::half, 1);
    double lowest = 0.;
    for (const auto &x : mesh.triangulation->get_vertices())
      lowest = std::min(lowest, x[2]);
    std::set<unsigned int> moved;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const unsigned int i : cell->vertex_indices())
      {
        dealii::Point<3> &x = cell->vertex(i);
        const double r      = std::hypot(x[0], x[1]);
        if (x[2] < lowest + 1e-6 && moved.insert(cell->vertex_index(i)).second)
          x[2] += has_step ? (r > 0.25 ? 1e-3 : 0.) : 1e-3 * r;
      }
    const std::string message =
        message_of<UserError>([&]() { const CyclicSector sector(mesh, all_of(ceramic()), 1); });
    EXPECT_NE(message.find("must be a flat layer between two electrodes"), std::string::npos)
        << message;
  }
}
