// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/mpi.h>

#include <memory>
#include <vector>

namespace ringmotor
{
  /**
   * Entries of a symmetric sparse matrix, lower triangle (row >= column), distributed over the
   * ranks in any way; entries given more than once are added.
   */
  struct SymmetricTriplets
  {
    std::vector<int> rows, columns; ///< counted from 1, as MUMPS expects them
    std::vector<double> values;

    void reserve(const std::size_t n_entries)
    {
      rows.reserve(n_entries);
      columns.reserve(n_entries);
      values.reserve(n_entries);
    }

    void add(const unsigned int row, const unsigned int column, const double value)
    {
      rows.push_back(1 + static_cast<int>(row >= column ? row : column));
      columns.push_back(1 + static_cast<int>(row >= column ? column : row));
      values.push_back(value);
    }
  };

  /**
   * L D L^T factorisation of a real symmetric indefinite sparse matrix by MUMPS, in parallel. Its
   * inertia counts the eigenvalues below a shift (Sylvester's law).
   *
   * Some unknowns can be kept: the others, the inner ones, are eliminated, and the dense Schur
   * complement of the kept ones remains, which can be coupled to other bodies.
   */
  class SparseLDLT
  {
  public:
    SparseLDLT(const unsigned int size, MPI_Comm communicator,
               const std::vector<unsigned int> &kept = {});
    ~SparseLDLT();
    SparseLDLT(const SparseLDLT &)            = delete;
    SparseLDLT &operator=(const SparseLDLT &) = delete;

    /**
     * Factorises the sum of @p triplets over all ranks. A repeated call with the same rows and
     * columns reuses the symbolic analysis.
     * @throws ComputationError if MUMPS fails or the matrix is singular, std::bad_alloc if memory
     * is short
     */
    void factorise(SymmetricTriplets &triplets);

    /** Number of negative eigenvalues of the factorised matrix (of its inner unknowns, if some are
     * kept). */
    unsigned int n_negative() const;

    /** Replaces right-hand sides, one or several one after the other (the same on all ranks), by
     * the solutions (on all ranks). Not for matrices with kept unknowns. */
    void solve(std::vector<double> &right_hand_sides);

    /** The Schur complement by columns, lower triangle, on all ranks; rows in the order of the kept
     * unknowns. */
    const std::vector<double> &schur_complement() const { return schur; }

    /**
     * First half of a solution with kept unknowns: the right-hand sides of the kept unknowns, one
     * after the other, that are left when the inner unknowns are eliminated from @p
     * right_hand_sides (one after the other, the same on all ranks).
     */
    std::vector<double> condense(const std::vector<double> &right_hand_sides);

    /**
     * Second half, to follow condense(): the solutions for all unknowns from those of the kept
     * ones. Arguments and results are the same on all ranks.
     */
    std::vector<double> expand(std::vector<double> kept_solutions);

  private:
    void run(const int job, const char *what);
    void broadcast(std::vector<double> &numbers) const;

    struct Mumps;
    std::unique_ptr<Mumps> mumps;
    MPI_Comm communicator;
    std::vector<int> kept_rows; ///< counted from 1
    std::vector<double> schur, right_hand_sides;
    bool analysed = false;
  };
} // namespace ringmotor
