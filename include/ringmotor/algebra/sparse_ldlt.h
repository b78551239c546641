// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/mpi.h>

#include <memory>
#include <vector>

namespace ringmotor
{
  /**
   * A symmetric sparse matrix as the sum of small dense ones, the elements, distributed over the
   * ranks in any way.
   */
  struct SymmetricElements
  {
    std::vector<int> begin{1};  ///< of each element in `variables`, then their end; from 1
    std::vector<int> variables; ///< rows of each element; from 1
    std::vector<double> values; ///< lower triangles by columns, one after the other

    /** Adds a matrix, by its lower triangle (by columns), to these rows, none of which may appear
     * twice. */
    void add(const std::vector<unsigned int> &rows, const std::vector<double> &lower);
  };

  /** In which order unknowns are eliminated. */
  enum class EliminationOrder
  {
    minimum_fill,     ///< best for a sector
    nested_dissection ///< best for a whole ring
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
               const std::vector<unsigned int> &kept = {},
               const EliminationOrder order          = EliminationOrder::minimum_fill);
    ~SparseLDLT();
    SparseLDLT(const SparseLDLT &)            = delete;
    SparseLDLT &operator=(const SparseLDLT &) = delete;

    /**
     * Factorises the sum of @p elements over all ranks. A repeated call with the same variables
     * reuses the symbolic analysis.
     * @throws ComputationError if MUMPS fails or the matrix is singular, std::bad_alloc if memory
     * is short
     */
    void factorise(SymmetricElements elements);

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
    /** Finds factors for rows and columns that make inner diagonal entries one, and applies them.
     * For one kind of unknown that is enough, and cheap. */
    void scale(SymmetricElements &elements);
    void apply_scale(std::vector<double> &sides) const;

    struct Mumps;
    std::unique_ptr<Mumps> mumps;
    MPI_Comm communicator;
    std::vector<int> kept_rows;    ///< counted from 1
    std::vector<double> row_scale; ///< one for kept unknowns
    std::vector<double> schur, right_hand_sides;
    const EliminationOrder order;
    bool analysed = false;
  };
} // namespace ringmotor
