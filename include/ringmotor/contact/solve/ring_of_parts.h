// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/contact_rows.h>

#include <vector>

namespace ringmotor
{
  /**
   * Solves rows whose parts form a ring, D_p x_p + L_p x_(p-1) = b_p, by elimination: with y_p the
   * contribution of the previous part to the rows of part p, x_p = D_p^-1 (b_p + y_p) and
   * y_(p+1) = - L_(p+1) x_p. Once around the ring, y_0 is a linear function of itself. Rows to
   * which the previous part does not contribute are not in y. Unknowns of no part form the border
   * of that matrix.
   */
  class RingOfParts
  {
  public:
    /** @p rows must outlive this object. */
    explicit RingOfParts(const ContactRows &rows);

    unsigned int n_parts() const { return parts.size(); }
    unsigned int largest_part() const;
    /** Approximate cost of solve(): some eight times the cube of the size of each part, for its
     * factors and what it hands on. */
    double n_operations() const;

    /** @param solution the right-hand side; replaced by the solution
     * @return false if a matrix is singular */
    bool solve(dealii::Vector<double> &solution);

  private:
    struct Step
    {
      dealii::LAPACKFullMatrix<double> own; ///< factors of D_p, lost in copies
      dealii::FullMatrix<double> by_before; ///< - L_p, only rows that are not zero
      std::vector<unsigned int> rows;       ///< these rows
    };

    bool make_step(const unsigned int p, Step &step) const;
    dealii::FullMatrix<double> columns_of(const unsigned int p,
                                          const dealii::Vector<double> &given) const;
    /** x_p from y_p and, if given, right-hand sides. */
    dealii::FullMatrix<double> solved(const unsigned int p,
                                      const dealii::FullMatrix<double> &shared,
                                      const dealii::FullMatrix<double> *given) const;
    /** y_(p+1) */
    dealii::FullMatrix<double> next_shared(const unsigned int p,
                                           const dealii::FullMatrix<double> &unknowns) const;
    /** Replaces y_0, as it comes back around the ring from a zero start, by the self-consistent
     * one. */
    bool close(dealii::FullMatrix<double> &shared) const;
    bool solve_border(const std::vector<dealii::FullMatrix<double>> &unknowns,
                      dealii::Vector<double> &solution) const;

    const ContactRows &rows;
    std::vector<std::vector<unsigned int>> parts; ///< unknowns of each
    std::vector<unsigned int> border;             ///< unknowns of no part
    std::vector<Step> steps;
  };
} // namespace ringmotor
