// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>
#include <deal.II/lac/full_matrix.h>

#include <boost/serialization/is_bitwise_serializable.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ringmotor
{
  /** A force (N) or a motion (m) at a contact point. Components: normal (away from the stator),
   * along the driven direction t = -theta, radial. */
  using PointVector = dealii::Tensor<1, 3>;

  /** The length of the tangential part. */
  inline double tangential_norm(const PointVector &vector)
  {
    return std::sqrt(vector[1] * vector[1] + vector[2] * vector[2]); // hypot() is slow
  }

  /** The unknowns of a contact problem. */
  struct ContactState
  {
    std::vector<PointVector> force; ///< N, on the rotor, by contact point
    std::vector<double> rigid;      ///< rigid motions of the rotor that forces have to balance

    /** Number of points that are pressed together. */
    unsigned int n_pressed() const
    {
      return std::count_if(force.begin(), force.end(),
                           [](const PointVector &on_point) { return on_point[0] > 0.; });
    }
  };

  /** What the linear solver makes use of: how the points of a contact problem couple. Without
   * overrides it is a single block, of which nothing is known. */
  class BlockStructure
  {
  public:
    virtual ~BlockStructure() = default;

    /** The problem may consist of parts (the time samples of a steady state) in a ring, each of
     * which moves only itself and the next one. Rigid motions common to all parts belong to
     * no_part. */
    virtual unsigned int part_of_point(const unsigned int) const { return 0; }
    virtual unsigned int part_of_rigid(const unsigned int) const { return 0; }
    static constexpr unsigned int no_part = dealii::numbers::invalid_unsigned_int;

    /** Points are grouped in consecutive blocks (a tooth at a time sample). The coupling within a
     * block is far stronger than that between blocks. */
    virtual unsigned int n_blocks() const { return 1; }
    virtual unsigned int block_of_point(const unsigned int) const { return 0; }
    /** The block from whose motions the slips of a block are measured; no_part if they are measured
     * from given positions. */
    virtual unsigned int block_before(const unsigned int) const { return no_part; }
    /**
     * A low-rank approximation of the compliance between two blocks: far shapes, the most
     * significant first, each with a value for each component of a point, and a small matrix
     * between them, see far_kernel(). Its entry (i, j) is the share of shape i in the motion of a
     * block due to a unit force of shape j on another block.
     */
    virtual unsigned int n_far_shapes() const { return 0; }
    virtual double far_shape(const unsigned int /*point*/, const unsigned int /*component*/,
                             const unsigned int /*shape*/) const
    {
      return 0.;
    }
    /** @return nullptr for a block and itself, and for blocks that do not move each other */
    virtual const dealii::FullMatrix<double> *far_kernel(const unsigned int /*moved*/,
                                                         const unsigned int /*loaded*/) const
    {
      return nullptr;
    }
  };

  /**
   * The linear relation between the forces at contact points and the motions of the bodies there in
   * a time step: elastic bodies, condensed to their contact. Points touch where the gap closes; the
   * slip is the motion of the rotor over the stator in the step.
   */
  class ContactProblem
  {
  public:
    virtual ~ContactProblem() = default;

    virtual unsigned int n_points() const = 0;
    /** Number of rigid motions, and of the balances that go with them. */
    virtual unsigned int n_rigid() const = 0;

    /** For each point the gap (m), and the slip of the rotor over the stator in the step (m). */
    virtual std::vector<PointVector> relative_motion(const ContactState &state) const = 0;

    /** The linear part of the relative motion: how forces and rigid motions alone change it. */
    virtual std::vector<PointVector> motion_by(const ContactState &change) const = 0;

    /**
     * Derivatives of the relative motion of some points @p rows, three rows for each, by the forces
     * at points @p columns, three columns for each, and by the rigid motions, one column for each.
     * Sets size and all entries of @p matrix.
     */
    virtual void derivatives(const std::vector<unsigned int> &rows,
                             const std::vector<unsigned int> &columns,
                             dealii::FullMatrix<double> &matrix) const = 0;

    /** How its points couple, for the linear solver. */
    virtual const BlockStructure &structure() const
    {
      static const BlockStructure without;
      return without;
    }

    /** For each rigid motion the sum of forces that must vanish. */
    virtual std::vector<double> balances(const ContactState &state) const = 0;

    /** Derivatives of the balances, one row for each, by forces at some points and rigid motions.
     */
    virtual void balance_derivatives(const std::vector<unsigned int> &points,
                                     dealii::FullMatrix<double> &matrix) const = 0;
  };
} // namespace ringmotor

namespace boost::serialization
{
  /** Archives take arrays of them as a whole. */
  template <>
  struct is_bitwise_serializable<ringmotor::PointVector> : mpl::true_
  {
  };
} // namespace boost::serialization
