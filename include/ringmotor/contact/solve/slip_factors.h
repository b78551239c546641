// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/contact_rows.h>

#include <vector>

namespace ringmotor
{
  /**
   * LU factors, in single precision, of contact rows without most friction forces of slipping
   * nodes. The friction of such a node is the coefficient times the pressure, along its slip: one
   * combination of its rows, in which motion barely occurs, states this and gives one of its two
   * friction forces directly. Two of three unknowns remain, and a third of the operations.
   *
   * A preconditioner for contact rows, exact but for rounding and the small terms in motion that
   * are neglected, for vectors that are zero in those combinations; start() makes the residual so.
   */
  class SlipFactors
  {
  public:
    /** What an object for some rows takes, estimated before it is made: operations of matrix
     * products in double precision that take as long. */
    static double cost_of(const ContactRows &rows);

    explicit SlipFactors(const ContactRows &rows);

    bool is_regular() const { return regular; }

    /** Whether the factors are those of rows with the same unknowns. */
    bool fit(const ContactRows &rows) const;

    /** The solution of the rows without motion, and zero for all other unknowns: with this start
     * the residual vanishes in those rows. */
    dealii::Vector<double> start(const dealii::Vector<double> &right_hand_side) const;

    void vmult(dealii::Vector<double> &result, const dealii::Vector<double> &vector) const;

  private:
    /** How the three rows and forces of a node are combined. */
    struct Node
    {
      unsigned int n_kept;        ///< rows, and unknowns
      dealii::Tensor<2, 3> row;   ///< combinations of rows; the kept ones first
      dealii::Tensor<2, 3> force; ///< changes of the force by unknowns; of the kept ones first
      double coupling[2];         ///< of the eliminated force into the kept rows
    };
    static Node node_of(const ContactRow &row);
    void assemble(const ContactRows &rows);
    /** Sets consecutive rows of the matrix, from derivatives by all components of the forces and by
     * rigid motions. */
    void set_lines(const unsigned int first_line, const dealii::FullMatrix<double> &lines);

    const RowUnknowns made_for;
    unsigned int n_rigid;
    std::vector<Node> nodes;
    std::vector<unsigned int> first; ///< unknown kept of each node; then those of rigid motions
    dealii::LAPACKFullMatrix<float> factors;
    bool regular = false;
  };
} // namespace ringmotor
