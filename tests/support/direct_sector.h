// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/condensation/condensation.h>

#include <gtest/gtest.h>

#include <support/triplets.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace ringmotor::tests
{
  /** The loads on the unknowns due to forces (coefficients, N) on degrees of freedom of the real
   * field (part 0) or the imaginary one (1). */
  inline std::vector<double> loads_of_form(const CyclicSector &sector, const unsigned int k,
                                           const unsigned int part, const LinearForm &form)
  {
    dealii::Vector<double> along_axes(sector.n_dofs());
    for (const auto &[dof, coefficient] : form)
      along_axes[dof] += coefficient;
    sector.nodes().rotate_to_cartesian(along_axes);
    SectorMotion forces = sector.at_rest();
    auto &solid         = part == 0 ? forces.solid.real : forces.solid.imaginary;
    auto &shell         = part == 0 ? forces.shell.real : forces.shell.imaginary;
    std::copy(along_axes.begin(), along_axes.begin() + solid.size(), solid.begin());
    std::copy(along_axes.begin() + solid.size(), along_axes.end(), shell.begin());
    return sector.loads_of(k, forces);
  }

  /** Solves (K - shift M) u + P lambda = f, P^T u = g for one nodal diameter by one sparse
   * factorisation of all unknowns. */
  class DirectSector
  {
  public:
    /** @p conditions are the columns of P. */
    DirectSector(const CyclicSector &sector, const unsigned int k, const double shift,
                 const std::vector<std::vector<double>> &conditions)
        : n_unknowns(sector.n_unknowns()), size(n_unknowns + conditions.size()),
          factors(size, MPI_COMM_SELF)
    {
      SectorStiffness stiffness(sector, std::vector<bool>(sector.n_dofs(), true));
      stiffness.compute(shift);
      SymmetricTriplets triplets;
      for (const unsigned int part : {0u, 1u})
        add_field(sector, k, part, stiffness, triplets);
      for (unsigned int c = 0; c < conditions.size(); ++c)
      {
        triplets.add(n_unknowns + c, n_unknowns + c, 0.);
        for (unsigned int i = 0; i < n_unknowns; ++i)
          if (conditions[c][i] != 0.)
            triplets.add(n_unknowns + c, i, conditions[c][i]);
      }
      factors.factorise(triplets);
    }

    /** Returns (u, lambda) for the right-hand side (f, g); a missing g is zero. */
    std::vector<double> solve(std::vector<double> right_hand_side)
    {
      right_hand_side.resize(size, 0.);
      factors.solve(right_hand_side);
      return right_hand_side;
    }

  private:
    static void add_field(const CyclicSector &sector, const unsigned int k, const unsigned int part,
                          const SectorStiffness &stiffness, SymmetricTriplets &triplets)
    {
      const CyclicSector::RealField &field = sector.field(part);
      std::vector<std::vector<std::pair<unsigned int, double>>> terms(field.size);
      for (const auto &[number, unknown] : field.inner)
        terms[number].emplace_back(unknown, 1.);
      for (const CyclicSector::Tie &tie : sector.ties(part, k))
        terms[field.cut[tie.position]].emplace_back(tie.unknown, tie.factor);
      for (const SectorStiffness::Element &element : stiffness.elements())
      {
        std::set<unsigned int> unknowns;
        for (const auto dof : element.dofs)
          if (field.number[dof] != dealii::numbers::invalid_unsigned_int)
            for (const auto &term : terms[field.number[dof]])
              unknowns.insert(term.first);
        const std::vector<unsigned int> rows(unknowns.begin(), unknowns.end());
        dealii::FullMatrix<double> follow(element.dofs.size(), rows.size()),
            half(element.dofs.size(), rows.size()), whole(rows.size(), rows.size()),
            matrix(element.dofs.size(), element.dofs.size());
        for (unsigned int i = 0; i < element.dofs.size(); ++i)
        {
          for (unsigned int j = 0; j < element.dofs.size(); ++j)
            matrix(i, j) = element(i, j);
          if (const unsigned int number = field.number[element.dofs[i]];
              number != dealii::numbers::invalid_unsigned_int)
            for (const auto &[unknown, factor] : terms[number])
              follow(i, std::distance(unknowns.begin(), unknowns.find(unknown))) += factor;
        }
        if (rows.empty())
          continue;
        matrix.mmult(half, follow);
        follow.Tmmult(whole, half);
        triplets.add(rows, whole, std::vector<bool>(sector.n_unknowns(), false));
      }
    }

    const unsigned int n_unknowns, size;
    SparseLDLT factors;
  };

  /** Compares two motions of all nodes, relative to the largest displacement (and rotation). */
  inline void expect_motion(const SectorMotion &motion, const SectorMotion &expected,
                            const double tolerance)
  {
    for (const auto part : {&SectorMotion::solid, &SectorMotion::shell})
      for (const auto field : {&ComplexField::real, &ComplexField::imaginary})
      {
        dealii::Vector<double> difference = (motion.*part).*field;
        if (difference.size() == 0)
          continue;
        difference -= (expected.*part).*field;
        const double largest =
            std::max((expected.*part).real.linfty_norm(), (expected.*part).imaginary.linfty_norm());
        EXPECT_GT(largest, 0.);
        EXPECT_LT(difference.linfty_norm(), tolerance * largest);
      }
  }

  using Solver = std::function<std::vector<double>(const std::vector<double> &)>;

  /** Compares a compliance with the solutions for these loads, relative to its diagonal entries,
   * and checks its symmetry. */
  inline void expect_solutions(const dealii::FullMatrix<double> &compliance,
                               const std::vector<std::vector<double>> &loads, const Solver &solve,
                               const double tolerance)
  {
    ASSERT_EQ(compliance.m(), loads.size());
    ASSERT_EQ(compliance.n(), loads.size());
    std::vector<double> scale;
    double largest = 0., worst = 0., asymmetry = 0.;
    for (unsigned int i = 0; i < loads.size(); ++i)
    {
      scale.push_back(std::sqrt(std::abs(compliance(i, i))));
      largest = std::max(largest, scale.back());
    }
    for (double &entry : scale) // forms that symmetry constrains are pure roundoff
      entry = entry < 1e-6 * largest ? largest : entry;
    for (unsigned int j = 0; j < loads.size(); ++j)
    {
      const std::vector<double> solution = solve(loads[j]);
      for (unsigned int i = 0; i < loads.size(); ++i)
      {
        const double expected =
            std::inner_product(loads[i].begin(), loads[i].end(), solution.begin(), 0.);
        const double entry = compliance(i, j), size = scale[i] * scale[j];
        worst     = std::max(worst, std::abs(entry - expected) / size);
        asymmetry = std::max(asymmetry, std::abs(entry - compliance(j, i)) / size);
      }
    }
    EXPECT_LT(worst, tolerance);
    EXPECT_LT(asymmetry, 1e-12);
  }
} // namespace ringmotor::tests
