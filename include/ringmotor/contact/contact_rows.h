// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_problem.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace ringmotor
{
  /** The three rows of a touching node in a linear system: a block times the change of its motion,
   * and another one times the change of its force. */
  struct ContactRow
  {
    dealii::Tensor<2, 3> by_motion, by_force; ///< N/m, and a pure number
    PointVector right_hand_side;              ///< N
    bool has_friction = true;                 ///< otherwise it has none now and had none before
  };

  /**
   * Solves the rows of touching nodes, together with the balances, for the changes of the forces
   * and of the rigid motions: by LAPACK with a dense matrix, or with one for each part of a problem
   * of several parts, whichever takes fewer operations; if these matrices would be too large, by
   * GMRES, which applies the compliance without a matrix.
   *
   * @param solution the right-hand side, three entries for each touching node and one for each
   * balance; replaced by the solution
   * @return false if a matrix is singular or GMRES does not converge
   */
  bool solve_contact_rows(const ContactProblem &problem, const std::vector<unsigned int> &touching,
                          const std::vector<ContactRow> &rows, dealii::Vector<double> &solution);
} // namespace ringmotor
