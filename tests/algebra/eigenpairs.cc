// SPDX-License-Identifier: LGPL-2.1-or-later

// Factorisation, inertia and eigensolver on chains of equal masses and springs, whose eigenvalues
// are known: 2 - 2 cos(j pi / (n + 1)) between two walls, and 2 - 2 cos((2 pi j + phase) / n) for a
// closed chain whose last spring carries a complex factor exp(i phase) (a Hermitian matrix).

#include <ringmotor/algebra/dense_ldlt.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/structure/modes.h>

#include <gtest/gtest.h>

#include <support/triplets.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

using namespace ringmotor;
using ringmotor::tests::SymmetricTriplets;

namespace
{
  constexpr unsigned int n_masses = 60;

  SymmetricTriplets chain(const double shift)
  {
    SymmetricTriplets triplets;
    for (unsigned int i = 0; i < n_masses; ++i)
    {
      triplets.add(i, i, 2.);
      triplets.add(i, i, -shift); // duplicate entries are added
      if (i > 0)
        triplets.add(i - 1, i, -1.); // either triangle is accepted
    }
    return triplets;
  }

  double chain_value(const unsigned int j)
  {
    return 2. - 2. * std::cos((j + 1) * M_PI / (n_masses + 1));
  }

  /** The closed chain as a real matrix: real parts first, then imaginary parts. */
  SymmetricTriplets closed_chain(const double phase, const double shift)
  {
    SymmetricTriplets triplets;
    for (unsigned int i = 0; i < n_masses; ++i)
      for (const unsigned int part : {0u, n_masses})
      {
        triplets.add(part + i, part + i, 2. - shift);
        if (i > 0)
          triplets.add(part + i, part + i - 1, -1.);
      }
    const unsigned int first = 0, last = n_masses - 1;
    const double c = std::cos(phase), s = std::sin(phase);
    // row `last`, column `first` has -(c + i s)
    triplets.add(last, first, -c);
    triplets.add(n_masses + last, n_masses + first, -c);
    triplets.add(last, n_masses + first, s);
    triplets.add(n_masses + last, first, -s);
    return triplets;
  }

  std::vector<double> generic_vector(const unsigned int size)
  {
    std::mt19937 random;
    std::vector<double> start(size);
    for (double &entry : start)
      entry = std::generate_canonical<double, 53>(random) - 0.5;
    return start;
  }

  ShiftInvertedPencil pencil_of(SparseLDLT &factors, const unsigned int size, const bool is_complex,
                                const double shift, const double mass)
  {
    ShiftInvertedPencil pencil;
    pencil.size    = size;
    pencil.complex = is_complex;
    pencil.shift   = shift;
    pencil.solve   = [&factors](std::vector<double> &x) { factors.solve(x); };
    pencil.mass    = [mass](const std::vector<double> &x, std::vector<double> &product)
    {
      product = x;
      for (double &entry : product)
        entry *= mass;
    };
    return pencil;
  }
} // namespace

TEST(SparseLDLT, SolvesAndCounts)
{
  SparseLDLT factors(n_masses, MPI_COMM_SELF);
  SymmetricTriplets stiffness = chain(0.);
  factors.factorise(stiffness);
  EXPECT_EQ(factors.n_negative(), 0u);

  // A force in the middle deflects the chain into a triangle.
  std::vector<double> x(n_masses, 0.);
  x[20] = 1.;
  factors.solve(x);
  for (unsigned int i = 0; i < n_masses; ++i)
    EXPECT_NEAR(x[i], std::min(i + 1, 21u) * (n_masses - std::max(i, 20u)) / (n_masses + 1.),
                1e-12);

  // The same pattern again with other values
  for (const unsigned int j : {1u, 17u, 59u})
  {
    SymmetricTriplets shifted = chain(0.5 * (chain_value(j - 1) + chain_value(j)));
    factors.factorise(shifted);
    EXPECT_EQ(factors.n_negative(), j);
  }
}

TEST(SparseLDLT, LeavesTheSchurComplementOfKeptUnknowns)
{
  // As with the whole matrix: the deflection for two load cases together, and the inertia for a
  // shift between two eigenvalues, which is the sum of those of the inner unknowns and of the
  // complement.
  const std::vector<unsigned int> kept{45, 10, 46};
  for (const unsigned int j : {0u, 1u, 17u, 59u})
  {
    const double shift = j == 0 ? 0. : 0.5 * (chain_value(j - 1) + chain_value(j));
    SparseLDLT whole(n_masses, MPI_COMM_SELF), factors(n_masses, MPI_COMM_SELF, kept);
    SymmetricTriplets matrix = chain(shift), same = chain(shift);
    whole.factorise(matrix);
    factors.factorise(same);
    DenseLDLT complement;
    complement.factorise(kept.size(), factors.schur_complement());
    EXPECT_EQ(factors.n_negative() + complement.n_negative(), j);

    const std::vector<double> generic = generic_vector(2 * n_masses);
    std::vector<double> loads         = generic;
    for (const unsigned int unknown : kept) // their own loads are added to the condensed ones below
      loads[unknown] = loads[n_masses + unknown] = 0.;
    const std::vector<double> reduced = factors.condense(loads);
    std::vector<double> solutions;
    for (const unsigned int column : {0u, 1u})
    {
      std::vector<double> of_kept;
      for (unsigned int i = 0; i < kept.size(); ++i)
        of_kept.push_back(reduced[column * kept.size() + i] + generic[column * n_masses + kept[i]]);
      complement.solve(of_kept);
      solutions.insert(solutions.end(), of_kept.begin(), of_kept.end());
    }
    const std::vector<double> expanded = factors.expand(solutions);
    for (const unsigned int column : {0u, 1u})
    {
      std::vector<double> x(generic.begin() + column * n_masses,
                            generic.begin() + (column + 1) * n_masses);
      whole.solve(x);
      const double largest = std::abs(*std::max_element(x.begin(), x.end(),
                                                        [](const double a, const double b)
                                                        { return std::abs(a) < std::abs(b); }));
      for (unsigned int i = 0; i < n_masses; ++i)
        EXPECT_NEAR(expanded[column * n_masses + i], x[i], 1e-10 * largest) << j << " " << i;
    }
  }
}

TEST(DenseLDLT, SolvesAndCounts)
{
  // Eigenvalues of [[0, 2], [2, 0]] are 2 and -2: a pivot block of two rows; 3 and -5 stand alone.
  const std::vector<double> matrix{0., 2., 0., 0., 2., 0., 0., 0., 0., 0., 3., 0., 0., 0., 0., -5.};
  DenseLDLT factors;
  factors.factorise(4, matrix);
  EXPECT_EQ(factors.n_negative(), 2u);
  std::vector<double> x{2., 4., 6., 10.};
  factors.solve(x);
  const std::vector<double> exact{2., 1., 2., -2.};
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_NEAR(x[i], exact[i], 1e-13);
  EXPECT_THROW(factors.factorise(2, {1., 1., 1., 1.}), ComputationError);
  factors.factorise(0, {});
  EXPECT_EQ(factors.n_negative(), 0u);
}

TEST(CommonShifts, AreFewAndInTheWindows)
{
  const std::map<unsigned int, std::vector<ShiftWindow>> windows{
      {0, {{1., 2.}, {6., 9.}}}, {1, {{1.4, 4.}}}, {2, {{5., 8.}}}, {3, {{7., 7.5}}}};
  const std::map<unsigned int, double> shifts = common_shifts(windows);
  ASSERT_EQ(shifts.size(), windows.size());
  std::set<double> different;
  for (const auto &[k, shift] : shifts)
  {
    EXPECT_TRUE(std::any_of(windows.at(k).begin(), windows.at(k).end(),
                            [shift = shift](const ShiftWindow &window)
                            { return window.low <= shift && shift <= window.high; }))
        << k;
    different.insert(shift);
  }
  EXPECT_EQ(different.size(), 2u); // 0, 2 and 3 share one; 1 needs its own
}

TEST(SparseLDLT, RefusesASingularMatrix)
{
  SparseLDLT factors(3, MPI_COMM_SELF);
  SymmetricTriplets triplets;
  triplets.add(0, 0, 1.);
  triplets.add(1, 1, 1.);
  triplets.add(2, 2, 0.);
  EXPECT_THROW(factors.factorise(triplets), ComputationError);
}

TEST(Eigenpairs, AreThoseOfAChain)
{
  const double mass  = 0.25;
  const double shift = (0.5 * (chain_value(9) + chain_value(10))) / mass;
  SparseLDLT factors(n_masses, MPI_COMM_SELF);
  SymmetricTriplets shifted = chain(mass * shift);
  factors.factorise(shifted);
  const ShiftInvertedPencil pencil = pencil_of(factors, n_masses, false, shift, mass);

  const auto below =
      eigenpairs(pencil, EigenvalueChoice::below, factors.n_negative(), generic_vector(n_masses));
  ASSERT_EQ(below.size(), 10u);
  for (unsigned int j = 0; j < 10; ++j)
  {
    EXPECT_NEAR(below[j].value, chain_value(j) / mass, 1e-12 * chain_value(9) / mass);
    // shape sin(i (j + 1) pi / (n + 1)), M-normalised: mass * (n + 1)/2 * amplitude^2 = 1
    const double amplitude = std::sqrt(2. / (mass * (n_masses + 1)));
    const double sign      = below[j].vector[0] > 0. ? 1. : -1.;
    for (unsigned int i = 0; i < n_masses; ++i)
      EXPECT_NEAR(sign * below[j].vector[i],
                  amplitude * std::sin((i + 1) * (j + 1) * M_PI / (n_masses + 1)), 1e-10);
  }

  const auto nearest = eigenpairs(pencil, EigenvalueChoice::nearest, 4, generic_vector(n_masses));
  ASSERT_EQ(nearest.size(), 4u);
  for (unsigned int j = 0; j < 4; ++j)
    EXPECT_NEAR(nearest[j].value, chain_value(j + 8) / mass, 1e-12);

  EXPECT_TRUE(eigenpairs(pencil, EigenvalueChoice::below, 0, generic_vector(n_masses)).empty());
}

TEST(Eigenpairs, AreThoseOfAComplexChain)
{
  const double phase = 0.7, shift = 0.11, mass = 1.;
  std::vector<double> exact;
  for (unsigned int j = 0; j < n_masses; ++j)
    exact.push_back(2. - 2. * std::cos((2. * M_PI * j + phase) / n_masses));
  std::sort(exact.begin(), exact.end());
  const auto n_below = std::lower_bound(exact.begin(), exact.end(), shift) - exact.begin();

  SparseLDLT factors(2 * n_masses, MPI_COMM_SELF);
  SymmetricTriplets shifted = closed_chain(phase, shift);
  factors.factorise(shifted);
  ASSERT_EQ(factors.n_negative(), 2 * n_below); // each eigenvalue twice in real numbers

  const auto pencil = pencil_of(factors, 2 * n_masses, true, shift, mass);
  const auto found =
      eigenpairs(pencil, EigenvalueChoice::below, n_below, generic_vector(2 * n_masses));
  ASSERT_EQ(found.size(), static_cast<std::size_t>(n_below));
  for (unsigned int j = 0; j < found.size(); ++j)
  {
    EXPECT_NEAR(found[j].value, exact[j], 1e-13);
    // All masses of a wave have the same amplitude.
    for (unsigned int i = 0; i < n_masses; ++i)
      EXPECT_NEAR(std::hypot(found[j].vector[i], found[j].vector[n_masses + i]),
                  1. / std::sqrt(n_masses), 1e-10);
  }
}
