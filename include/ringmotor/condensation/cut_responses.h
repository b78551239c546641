// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/condensation/interface_compliance.h>

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace ringmotor
{
  /**
   * B_k of InterfaceCompliance for all nodal diameters 0 .. N / 2, from solutions at few of them.
   *
   * Forces on an interface reach the cut as smooth motions, which are much alike for all k. The
   * solutions X_k = K_k^-1 L_k^T of a few k therefore span those of all others (reduced basis), and
   * Galerkin's projection onto them has an error of second order in what they miss:
   *
   *   B_k ~ L_k V (V^T K_k V)^-1 V^T L_k^T
   *
   * K_k and L_k are sums of constant matrices times functions of k (CyclicSector::wave_functions),
   * so that they are projected once. For static compliances this approaches B_k from below, and the
   * growth of its trace by one more solution bounds all errors that this solution removed. The next
   * k is the one where the trace (estimated by random combinations of loads) grew most, until it
   * grows by less than 1e-8 everywhere.
   *
   * Nodal diameters with constrained supports are solved for themselves.
   */
  class CutResponses
  {
  public:
    /** The supports that must be constrained for a nodal diameter. */
    using Held = std::function<std::vector<unsigned int>(const unsigned int k)>;

    /** @p interface must outlive this object. */
    CutResponses(const InterfaceCompliance &interface, const Held &held);

    /** B_k, up to 1e-8 of its trace. */
    dealii::FullMatrix<double> at(const unsigned int k) const;

    /** Nodal diameters whose solutions are the basis, in the order in which they were chosen. */
    const std::vector<unsigned int> &solved() const { return chosen; }

  private:
    /** Rows of one field's cut that follow the unknowns by the same function of k. */
    struct Piece
    {
      unsigned int part, function;
      std::vector<CyclicSector::Tie> ties; ///< unknowns by their places, factors 1 or -1
      dealii::FullMatrix<double> basis;    ///< of the rows: one row for each vector
      dealii::FullMatrix<double> loads;    ///< products with them; rows as CutSolutions
    };

    void divide_into_pieces();
    void choose_basis(const std::vector<unsigned int> &candidates);
    /** Extends the basis by what the solutions at @p k add to it. */
    void extend_by(const unsigned int k);
    void project(const dealii::FullMatrix<double> &vectors);
    /** Columns of @p vectors at the unknowns of a piece. */
    static dealii::FullMatrix<double> rows_of(const Piece &piece,
                                              const dealii::FullMatrix<double> &vectors);
    dealii::FullMatrix<double> stiffness_between(const Piece &a, const Piece &b) const;
    /** L_k V: a row for each shape. */
    dealii::FullMatrix<double> loads(const unsigned int k) const;
    /** Solutions of the projected system, in terms of the basis, for combinations of its loads. */
    InterfaceCompliance::CutSolutions projected(const unsigned int k,
                                                const dealii::FullMatrix<double> &loads) const;

    const InterfaceCompliance &interface;
    const Held held;
    std::vector<unsigned int> chosen;
    std::vector<double> scale;        ///< of each unknown in the basis, N/m to the power of 1/2
    dealii::FullMatrix<double> basis; ///< orthonormal rows, unknowns times their scale
    std::vector<Piece> pieces;
    /** V_a^T K_ab V_b by the numbers of two pieces a and b of one field. */
    std::map<std::pair<unsigned int, unsigned int>, dealii::FullMatrix<double>> stiffness;
  };
} // namespace ringmotor
