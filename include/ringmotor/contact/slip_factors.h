// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_rows.h>

#include <vector>

namespace ringmotor
{
  /**
   * LU factors, in single precision, of contact rows without most friction forces of slipping
   * nodes. The friction of such a node is the coefficient times the pressure, along its slip: one
   * combination of its rows says so, in which motion hardly occurs, and gives one of its two
   * friction forces directly. Two unknowns remain of three, and a third of the operations.
   *
   * A preconditioner for contact rows, exact but for rounding, for the little motion that is left
   * out, and for vectors that have something in those combinations; start() leaves nothing there.
   */
  class SlipFactors
  {
  public:
    explicit SlipFactors(const ContactRows &rows);

    bool is_regular() const { return regular; }

    /** Whether they are of rows with the same unknowns. */
    bool fit(const ContactRows &rows) const;

    /** What the rows without motion say, and zero for all other unknowns: with this start the
     * residual has nothing in those rows. */
    dealii::Vector<double> start(const dealii::Vector<double> &right_hand_side) const;

    void vmult(dealii::Vector<double> &result, const dealii::Vector<double> &vector) const;

  private:
    /** How the three rows and forces of a node are combined. */
    struct Node
    {
      unsigned int n_kept;        ///< rows, and unknowns
      dealii::Tensor<2, 3> row;   ///< combinations of rows; the kept ones first
      dealii::Tensor<2, 3> force; ///< changes of the force by unknowns; of the kept ones first
      double coupling[2];         ///< of the force that is left out into the kept rows
    };
    static Node node_of(const ContactRow &row);
    void assemble(const ContactRows &rows);

    std::vector<unsigned int> touching, unknowns; ///< of the rows
    unsigned int n_rigid;
    std::vector<Node> nodes;
    std::vector<unsigned int> first; ///< unknown kept of each node; then those of rigid motions
    dealii::LAPACKFullMatrix<float> factors;
    bool regular = false;
  };
} // namespace ringmotor
