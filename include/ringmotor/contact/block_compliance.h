// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_problem.h>
#include <ringmotor/contact/ring_compliance.h>

#include <vector>

namespace ringmotor
{
  /**
   * How the contact points of a ring move under forces on them at one or several samples. Points
   * come in blocks, a tooth at a sample each, numbered by sample and tooth.
   *
   * What bodies do at once, forces of a sample move at that sample only. What modes with inertia
   * add, forces move at all samples; all that counts is how long ago a tooth was where another one
   * is: the blocks are the instants of one history, which form a ring of their own.
   */
  class BlockCompliance
  {
  public:
    /** Of bodies without inertia. @p at_once must outlive this object. */
    BlockCompliance(const RingCompliance &at_once, const unsigned int n_samples);

    /** @param of_modes what modes add, by instants
     * @param instant of each block, the same steps apart from tooth to tooth at all samples */
    BlockCompliance(const RingCompliance &at_once, const unsigned int n_samples,
                    RingCompliance of_modes, std::vector<unsigned int> instant);

    unsigned int n_blocks() const { return n_samples * at_once.n_sectors(); }
    /** Blocks move those of the same part only. */
    unsigned int part_of(const unsigned int block) const
    {
      return instant.empty() ? sample(block) : 0;
    }

    /** Adds the motions (m) of all points by forces (N). */
    void add_motions(const std::vector<PointVector> &force, std::vector<PointVector> &motion) const;
    /** The same without what modes add. */
    void add_motions_at_once(const std::vector<PointVector> &force,
                             std::vector<PointVector> &motion) const;

    /** Adds the motions of the nodes @p rows of block @p moved by forces on the nodes @p columns of
     * block @p loaded to a matrix, see RingCompliance::add_entries(). */
    void add_entries(const unsigned int moved, const unsigned int loaded,
                     const std::vector<unsigned int> &rows,
                     const std::vector<unsigned int> &columns, const double factor,
                     const unsigned int first, dealii::FullMatrix<double> &matrix,
                     const unsigned int row, const unsigned int column) const;

    /** See ContactProblem::far_kernel(). */
    const dealii::FullMatrix<double> &far_shapes() const { return far().shapes; }
    const dealii::FullMatrix<double> *far_kernel(const unsigned int moved,
                                                 const unsigned int loaded) const;

    /** Values by instant and node from values by point, and back. */
    std::vector<PointVector> by_instant(const std::vector<PointVector> &of_points) const;
    std::vector<PointVector> by_point(const std::vector<PointVector> &of_instants) const;

  private:
    unsigned int sample(const unsigned int block) const { return block / at_once.n_sectors(); }
    /** Teeth, or instants, from one block to another one. */
    unsigned int teeth_between(const unsigned int moved, const unsigned int loaded) const
    {
      const unsigned int n = at_once.n_sectors();
      return (n + moved % n - loaded % n) % n;
    }
    unsigned int instants_between(const unsigned int moved, const unsigned int loaded) const
    {
      return (n_blocks() + instant[moved] - instant[loaded]) % n_blocks();
    }
    const RingCompliance::Far &far() const
    {
      return instant.empty() ? at_once.far() : far_with_modes;
    }

    const RingCompliance &at_once;
    const unsigned int n_samples;
    RingCompliance of_modes;
    const std::vector<unsigned int> instant; ///< of each block; empty without modes
    RingCompliance::Far far_with_modes;
    std::vector<dealii::FullMatrix<double>> all; ///< entries of both by instants, where both have
                                                 ///< a table of them
  };
} // namespace ringmotor
