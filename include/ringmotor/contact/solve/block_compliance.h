// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/ring_compliance.h>
#include <ringmotor/contact/solve/contact_problem.h>

#include <optional>
#include <vector>

namespace ringmotor
{
  /**
   * The compliance of the contact nodes of a ring at one or several time samples. Nodes are grouped
   * in blocks, one for each tooth at each time sample, numbered by time sample and tooth.
   *
   * The instantaneous response of the bodies couples nodes of the same time sample only. Modes with
   * inertia couple all time samples; their response depends only on how long ago a tooth was where
   * another one is: the blocks are the instants of one history, which form a ring themselves.
   */
  class BlockCompliance
  {
  public:
    /** For bodies without inertia. @p at_once must outlive this object. */
    BlockCompliance(const RingCompliance &at_once, const unsigned int n_samples);

    /** @param of_modes contribution of the modes, by instants
     * @param instant of each block; the step from tooth to tooth is the same at all time samples */
    BlockCompliance(const RingCompliance &at_once, const unsigned int n_samples,
                    RingCompliance of_modes, std::vector<unsigned int> instant);

    unsigned int n_blocks() const { return n_samples * at_once.n_sectors(); }
    /** A block moves only blocks of the same part. */
    unsigned int part_of(const unsigned int block) const
    {
      return instant.empty() ? sample(block) : 0;
    }

    /** Adds the motions (m) of all nodes due to forces (N). */
    void add_motions(const std::vector<PointVector> &force, std::vector<PointVector> &motion) const;
    /** The same without the contribution of the modes. */
    void add_motions_at_once(const std::vector<PointVector> &force,
                             std::vector<PointVector> &motion) const;

    /** Adds the motions of the nodes @p rows of block @p moved by forces on the nodes @p columns of
     * block @p loaded to @p matrix, see RingCompliance::add_entries(). */
    void add_entries(const unsigned int moved, const unsigned int loaded,
                     const std::vector<unsigned int> &rows,
                     const std::vector<unsigned int> &columns, const double factor,
                     const unsigned int first, dealii::FullMatrix<double> &matrix,
                     const unsigned int row, const unsigned int column) const;

    /** See ContactProblem::far_kernel(). */
    const dealii::FullMatrix<double> &far_shapes() const { return far().shapes; }
    const dealii::FullMatrix<double> *far_kernel(const unsigned int moved,
                                                 const unsigned int loaded) const;

    /** Values by instant and node from values by contact point, and back. */
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
    const RingCompliance::Far &far() const;

    const RingCompliance &at_once;
    const unsigned int n_samples;
    RingCompliance of_modes;
    const std::vector<unsigned int> instant; ///< of each block; empty without modes
    mutable std::optional<RingCompliance::Far> far_with_modes; ///< computed when it is needed first
    /** Entries of the sum of both by instants, and the product with them; if both have a small
     * table. */
    std::vector<dealii::FullMatrix<double>> whole;
    mutable std::optional<CirculantProduct> product_with_whole; ///< made when it is needed first
  };
} // namespace ringmotor
