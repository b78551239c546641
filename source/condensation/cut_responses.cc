// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/dense_ldlt.h>
#include <ringmotor/algebra/rank_factors.h>
#include <ringmotor/condensation/cut_responses.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr double largest_growth = 1e-8; ///< of a trace by the last solution
    constexpr double negligible     = 1e-7; ///< part of a unit motion that the basis may miss

    FullMatrix<double> times_transposed(const FullMatrix<double> &a, const FullMatrix<double> &b)
    {
      FullMatrix<double> result(a.m(), b.m());
      if (!a.empty() && !b.empty())
        a.mTmult(result, b);
      return result;
    }

    /** One below the other. */
    FullMatrix<double> stacked(const FullMatrix<double> &a, const FullMatrix<double> &b)
    {
      if (a.empty())
        return b;
      FullMatrix<double> result(a.m() + b.m(), a.n());
      result.fill(a);
      result.fill(b, a.m(), 0);
      return result;
    }

    /** About ten values from the first to the last, in a geometric sequence. */
    std::vector<unsigned int> spread(const std::vector<unsigned int> &values)
    {
      constexpr double ratio = 1.3;
      std::vector<unsigned int> chosen;
      for (const unsigned int value : values)
        if (chosen.empty() || value >= ratio * chosen.back() || value == values.back())
          chosen.push_back(value);
      return chosen;
    }

    /** Combinations of loads by which the trace of a response is estimated (Hutchinson). */
    FullMatrix<double> random_signs(const unsigned int n_loads)
    {
      constexpr unsigned int n_combinations = 16;
      std::mt19937 generator; // the same signs in each run
      FullMatrix<double> signs(n_combinations, n_loads);
      for (unsigned int i = 0; i < n_combinations; ++i)
        for (unsigned int j = 0; j < n_loads; ++j)
          signs(i, j) = generator() % 2 == 0 ? 1. : -1.;
      return signs;
    }

    /** Of a b^T. */
    double trace(const FullMatrix<double> &a, const FullMatrix<double> &b)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < a.m(); ++i)
        for (unsigned int j = 0; j < a.n(); ++j)
          sum += a(i, j) * b(i, j);
      return sum;
    }
  } // namespace

  CutResponses::CutResponses(const InterfaceCompliance &interface, const Held &held)
      : interface(interface), held(held)
  {
    if (interface.shapes(0).n() + interface.shapes(1).n() == 0)
      return;
    std::vector<unsigned int> without_supports;
    for (unsigned int k = 0; 2 * k <= interface.sector().sector_mesh().n_sectors; ++k)
      if (held(k).empty())
        without_supports.push_back(k);
    if (without_supports.empty())
      return;
    divide_into_pieces();
    choose_basis(spread(without_supports));
  }

  void CutResponses::divide_into_pieces()
  {
    const std::map<unsigned int, unsigned int> places = interface.places();
    scale.assign(places.size(), 0.);
    for (const unsigned int part : {0u, 1u})
      for (unsigned int function = 0; function < 3; ++function)
      {
        Piece piece;
        piece.part     = part;
        piece.function = function;
        CyclicSector::WaveFunctions alone{};
        alone[function] = 1.;
        for (CyclicSector::Tie tie : interface.sector().ties(part, alone))
          if (tie.factor != 0.)
          {
            tie.unknown = places.at(tie.unknown);
            scale[tie.unknown] += interface.fields[part].cut(tie.position, tie.position);
            piece.ties.push_back(tie);
          }
        if (!piece.ties.empty())
          pieces.push_back(std::move(piece));
      }
    for (double &value : scale)
      value = value == 0. ? 1. : std::sqrt(std::abs(value));
  }

  void CutResponses::choose_basis(const std::vector<unsigned int> &candidates)
  {
    const FullMatrix<double> combinations =
        random_signs(interface.shapes(0).n() + interface.shapes(1).n());
    std::map<unsigned int, double> traces;
    const auto growth = [&](const unsigned int k)
    {
      const FullMatrix<double> all_loads = loads(k);
      FullMatrix<double> some(combinations.m(), all_loads.n());
      combinations.mmult(some, all_loads);
      const InterfaceCompliance::CutSolutions found = projected(k, some);
      const double now = trace(found.loads, found.motions), before = traces[k];
      traces[k] = now;
      return now == 0. ? 0. : std::abs(now - before) / std::abs(now);
    };
    extend_by(candidates.front());
    if (candidates.back() != candidates.front())
      extend_by(candidates.back());
    while (chosen.size() < candidates.size())
    {
      unsigned int next = candidates.front();
      double largest    = 0.;
      for (const unsigned int k : candidates)
        if (std::find(chosen.begin(), chosen.end(), k) == chosen.end())
          if (const double grown = growth(k); grown >= largest)
          {
            largest = grown;
            next    = k;
          }
      if (largest <= largest_growth)
        return;
      extend_by(next);
    }
  }

  void CutResponses::extend_by(const unsigned int k)
  {
    chosen.push_back(k);
    const InterfaceCompliance::CutSolutions exact = interface.solve_cut(k, {});
    // Each with an energy of one half.
    FullMatrix<double> motions(exact.motions.n(), exact.motions.m());
    for (unsigned int shape = 0; shape < exact.motions.m(); ++shape)
    {
      double work = 0.;
      for (unsigned int i = 0; i < exact.motions.n(); ++i)
        work += exact.loads(shape, i) * exact.motions(shape, i);
      for (unsigned int i = 0; i < exact.motions.n() && work != 0.; ++i)
        motions(i, shape) = exact.motions(shape, i) * scale[i] / std::sqrt(std::abs(work));
    }
    const double whole = motions.frobenius_norm();
    const auto remove  = [&](FullMatrix<double> &columns)
    {
      for (unsigned int repeat = 0; repeat < 2 && !basis.empty(); ++repeat) // rounding
      {
        FullMatrix<double> shares(basis.m(), columns.n()), part(columns.m(), columns.n());
        basis.mmult(shares, columns);
        basis.Tmmult(part, shares);
        columns.add(-1., part);
      }
    };
    remove(motions);
    const double rest = motions.frobenius_norm();
    if (rest <= negligible * whole)
      return;
    RankFactors added(motions, std::min(negligible * whole / rest, 0.1));
    FullMatrix<double> vectors(added.columns.n(), added.columns.m());
    vectors.copy_transposed(added.columns);
    project(vectors);
  }

  FullMatrix<double> CutResponses::rows_of(const Piece &piece, const FullMatrix<double> &vectors)
  {
    FullMatrix<double> rows(vectors.m(), piece.ties.size());
    for (unsigned int v = 0; v < vectors.m(); ++v)
      for (unsigned int i = 0; i < piece.ties.size(); ++i)
        rows(v, i) = piece.ties[i].factor * vectors(v, piece.ties[i].unknown);
    return rows;
  }

  FullMatrix<double> CutResponses::stiffness_between(const Piece &a, const Piece &b) const
  {
    const FullMatrix<double> &whole = interface.fields[a.part].cut;
    FullMatrix<double> part(a.ties.size(), b.ties.size());
    for (unsigned int i = 0; i < a.ties.size(); ++i)
      for (unsigned int j = 0; j < b.ties.size(); ++j)
        part(i, j) = whole(a.ties[i].position, b.ties[j].position);
    return part;
  }

  void CutResponses::project(const FullMatrix<double> &vectors)
  {
    basis                       = stacked(basis, vectors);
    FullMatrix<double> unscaled = vectors;
    for (unsigned int v = 0; v < vectors.m(); ++v)
      for (unsigned int i = 0; i < vectors.n(); ++i)
        unscaled(v, i) /= scale[i];

    const unsigned int n_before = basis.m() - vectors.m();
    for (Piece &piece : pieces)
    {
      const unsigned int n_real         = interface.shapes(0).n();
      const FullMatrix<double> &of_cut  = interface.fields[piece.part].loads;
      const FullMatrix<double> new_rows = rows_of(piece, unscaled);
      piece.basis                       = stacked(piece.basis, new_rows);
      FullMatrix<double> loads(n_real + interface.shapes(1).n(), basis.m()),
          at_rows(of_cut.m(), piece.ties.size());
      for (unsigned int shape = 0; shape < of_cut.m(); ++shape)
        for (unsigned int i = 0; i < piece.ties.size(); ++i)
          at_rows(shape, i) = of_cut(shape, piece.ties[i].position);
      loads.fill(times_transposed(at_rows, piece.basis), piece.part == 0 ? 0 : n_real, 0);
      piece.loads = std::move(loads);
    }
    for (unsigned int a = 0; a < pieces.size(); ++a)
      for (unsigned int b = 0; b < pieces.size(); ++b)
        if (pieces[a].part == pieces[b].part)
        {
          const FullMatrix<double> moved = times_transposed(
              rows_of(pieces[b], unscaled), stiffness_between(pieces[a], pieces[b]));
          const FullMatrix<double> columns = times_transposed(pieces[a].basis, moved);
          // The rows of new vectors follow from the symmetry, K_ab = K_ba^T.
          FullMatrix<double> &ab = stiffness[{a, b}], old = ab;
          ab.reinit(basis.m(), basis.m());
          ab.fill(old);
          ab.fill(columns, 0, n_before);
        }
    for (auto &[pair, ab] : stiffness)
    {
      const FullMatrix<double> &ba = stiffness.at({pair.second, pair.first});
      for (unsigned int i = n_before; i < basis.m(); ++i)
        for (unsigned int j = 0; j < n_before; ++j)
          ab(i, j) = ba(j, i);
    }
  }

  FullMatrix<double> CutResponses::loads(const unsigned int k) const
  {
    const CyclicSector::WaveFunctions values = interface.sector().wave_functions(k);
    FullMatrix<double> loads(pieces.front().loads.m(), basis.m());
    for (const Piece &piece : pieces)
      loads.add(values[piece.function], piece.loads);
    return loads;
  }

  InterfaceCompliance::CutSolutions CutResponses::projected(const unsigned int k,
                                                            const FullMatrix<double> &loads) const
  {
    const CyclicSector::WaveFunctions values = interface.sector().wave_functions(k);
    const std::size_t size                   = basis.m();
    FullMatrix<double> matrix(size, size);
    for (const auto &[pair, part] : stiffness)
      matrix.add(values[pieces[pair.first].function] * values[pieces[pair.second].function], part);
    DenseLDLT factors;
    factors.factorise(size, std::vector<double>(&matrix(0, 0), &matrix(0, 0) + size * size));
    std::vector<double> motions(&loads(0, 0), &loads(0, 0) + loads.m() * size);
    factors.solve(motions);
    return {loads, FullMatrix<double>(loads.m(), size, motions.data())};
  }

  FullMatrix<double> CutResponses::at(const unsigned int k) const
  {
    const std::vector<unsigned int> supports = held(k);
    return basis.empty() || !supports.empty() ? interface.through_cut(k, supports)
                                              : projected(k, loads(k)).response();
  }
} // namespace ringmotor
