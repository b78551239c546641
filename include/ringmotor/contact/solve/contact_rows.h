// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/contact_problem.h>

#include <deal.II/lac/lapack_full_matrix.h>
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
    bool has_friction = true;                 ///< otherwise it is zero now and was zero before
  };

  /**
   * The rows of touching nodes together with the balances, as an operator and as matrices of some
   * of its rows and columns. Entries of vectors are three for each touching node and one for each
   * rigid motion. Friction that is zero and stays zero is not among the unknowns.
   */
  class ContactRows
  {
  public:
    /** All must outlive this object. */
    ContactRows(const ContactProblem &problem, const std::vector<unsigned int> &touching,
                const std::vector<ContactRow> &rows);

    unsigned int size() const { return 3 * touching.size() + problem.n_rigid(); }
    unsigned int n_of_nodes() const { return 3 * touching.size(); }
    unsigned int n_rigid() const { return problem.n_rigid(); }

    /** The unknowns, in ascending order. */
    const std::vector<unsigned int> &unknowns() const { return all_unknowns; }
    /** The part of the problem that an unknown belongs to, see BlockStructure::no_part. */
    unsigned int part_of(const unsigned int unknown) const;

    /** The entries in the rows of some unknowns and the columns of others, both in ascending order.
     */
    dealii::LAPACKFullMatrix<double>
    matrix_of(const std::vector<unsigned int> &row_unknowns,
              const std::vector<unsigned int> &column_unknowns) const;

    void vmult(dealii::Vector<double> &product, const dealii::Vector<double> &vector) const;

    /** The unknowns of the rigid motions. */
    std::vector<unsigned int> rigid_unknowns() const;
    const ContactProblem &contact_problem() const { return problem; }
    const std::vector<unsigned int> &touching_points() const { return touching; }
    const ContactRow &row_of(const unsigned int node) const { return rows[node]; }
    /** The point of an unknown force. */
    unsigned int point_of(const unsigned int unknown) const { return touching[unknown / 3]; }
    /** How the row of an unknown force depends on the motion of its point. */
    const dealii::Tensor<1, 3> &by_motion(const unsigned int unknown) const
    {
      return rows[unknown / 3].by_motion[unknown % 3];
    }

    /** The contribution of an unknown force to the balance of a rigid motion. */
    double balance_of(const unsigned int motion, const unsigned int unknown) const
    {
      return balance(motion, unknown);
    }

  private:
    /** Adds the blocks ContactRow::by_force, each of which belongs to a single node. */
    void add_forces(const std::vector<unsigned int> &row_unknowns,
                    const std::vector<unsigned int> &column_unknowns,
                    dealii::LAPACKFullMatrix<double> &matrix) const;

    const ContactProblem &problem;
    const std::vector<unsigned int> &touching;
    const std::vector<ContactRow> &rows;
    std::vector<unsigned int> all_unknowns;
    dealii::FullMatrix<double> balance;
    mutable ContactState change; ///< zero where nothing touches
  };

  /** Which unknowns some rows had, to recognise others of the same form. */
  class RowUnknowns
  {
  public:
    explicit RowUnknowns(const ContactRows &rows)
        : touching(rows.touching_points()), unknowns(rows.unknowns())
    {
    }

    bool are_of(const ContactRows &rows) const
    {
      return touching == rows.touching_points() && unknowns == rows.unknowns();
    }

  private:
    const std::vector<unsigned int> touching, unknowns;
  };
} // namespace ringmotor
