// SPDX-License-Identifier: LGPL-2.1-or-later

// The preconditioner of large systems: it is the inverse of the couplings that it retains, tested
// with manufactured solutions.

#include "support/row_systems.h"

#include <ringmotor/contact/solve/chain_of_blocks.h>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  /** Blocks of points on a ring, coupled through far shapes only. In the steady state slips are
   * measured relative to the previous block. */
  class RingOfBlocks : public DenseContact, public BlockStructure
  {
  public:
    RingOfBlocks(const unsigned int n_blocks, const bool is_steady)
        : DenseContact(n_blocks * of_block, 2), is_steady(is_steady), blocks(n_blocks)
    {
      const unsigned int n = 3 * n_points();
      for (unsigned int a = 0; a < 3 * of_block; ++a)
        for (unsigned int s = 0; s < n_far; ++s)
          shapes[a][s] = random_number();
      for (unsigned int moved = 0; moved < n_blocks; ++moved)
        for (unsigned int loaded = 0; loaded < n_blocks; ++loaded)
          kernels.push_back(random_kernel());
      dealii::FullMatrix<double> positions(n, n), rise(n, 2);
      for (unsigned int i = 0; i < n; ++i)
      {
        rise(i, 0) = 1. + 0.2 * random_number();
        rise(i, 1) = random_number();
        for (unsigned int j = 0; j < n; ++j)
        {
          const unsigned int moved = i / (3 * of_block), loaded = j / (3 * of_block);
          if (moved == loaded)
            positions(i, j) = 2. * (i == j) + 0.1 * random_number();
          else
            for (unsigned int s = 0; s < n_far; ++s)
              for (unsigned int t = 0; t < n_far; ++t)
                positions(i, j) += shape(i, s) * (*far_kernel(moved, loaded))(s, t) * shape(j, t);
        }
      }
      for (unsigned int i = 0; i < n; ++i)
      {
        const bool is_slip        = is_steady && i % 3 > 0;
        const unsigned int before = (i + n - 3 * of_block) % n;
        for (unsigned int j = 0; j < n; ++j)
          compliance(i, j) = positions(i, j) - (is_slip ? positions(before, j) : 0.);
        for (unsigned int r = 0; r < 2; ++r)
        {
          rigid_motion(i, r) = rise(i, r) - (is_slip ? rise(before, r) : 0.);
          balance(r, i)      = rise(i, r);
        }
      }
    }

    const BlockStructure &structure() const override { return *this; }
    unsigned int n_blocks() const override { return blocks; }
    unsigned int block_of_point(const unsigned int point) const override
    {
      return point / of_block;
    }
    unsigned int block_before(const unsigned int block) const override
    {
      return is_steady ? (block + blocks - 1) % blocks : no_part;
    }
    unsigned int n_far_shapes() const override { return n_far; }
    double far_shape(const unsigned int point, const unsigned int component,
                     const unsigned int shape) const override
    {
      return shapes[3 * (point % of_block) + component][shape];
    }
    const dealii::FullMatrix<double> *far_kernel(const unsigned int moved,
                                                 const unsigned int loaded) const override
    {
      return moved == loaded ? nullptr : &kernels[moved * blocks + loaded];
    }

  private:
    static constexpr unsigned int of_block = 4, n_far = 3;

    double shape(const unsigned int row, const unsigned int which) const
    {
      return far_shape(row / 3, row % 3, which);
    }
    static dealii::FullMatrix<double> random_kernel()
    {
      dealii::FullMatrix<double> kernel(n_far, n_far);
      for (unsigned int s = 0; s < n_far; ++s)
        for (unsigned int t = 0; t < n_far; ++t)
          kernel(s, t) = 0.02 * random_number();
      return kernel;
    }

    const bool is_steady;
    const unsigned int blocks;
    double shapes[3 * of_block][n_far];
    std::vector<dealii::FullMatrix<double>> kernels;
  };
} // namespace

TEST(ChainOfBlocks, IsTheInverseWhereBlocksKnowFarShapesOnly)
{
  for (const bool is_steady : {false, true})
    for (const bool is_whole : {false, true})
    {
      // The whole ring, whose chain must be cut, and one in which a block does not touch.
      const RingOfBlocks problem(9, is_steady);
      std::vector<unsigned int> touching;
      for (unsigned int i = 0; i < problem.n_points(); ++i)
        if (is_whole || (i % 7 != 2 && problem.block_of_point(i) != 5))
          touching.push_back(i);
      const System system(problem, touching);
      const ContactRows rows(problem, touching, system.rows);
      const ChainOfBlocks chain(rows);
      ASSERT_TRUE(chain.is_regular());
      EXPECT_TRUE(chain.fit(rows));
      dealii::Vector<double> solution(rows.size());
      chain.vmult(solution, system.right_hand_side);
      for (const unsigned int i : rows.unknowns())
        EXPECT_NEAR(solution[i], system.chosen[i], 1e-9) << is_steady << is_whole << " " << i;
    }
}

TEST(ChainOfBlocks, SaysWhenABlockIsSingular)
{
  const RingOfBlocks problem(4, false);
  System system(problem, all_but_some(problem.n_points()));
  system.rows[3].by_motion = system.rows[3].by_force = dealii::Tensor<2, 3>();
  system.rows[3].has_friction                        = true;
  const ContactRows rows(problem, system.touching, system.rows);
  EXPECT_FALSE(ChainOfBlocks(rows).is_regular());
}

TEST(ChainOfBlocks, FitsNoOtherPoints)
{
  const RingOfBlocks problem(4, false);
  const System system(problem, all_but_some(problem.n_points())), other(problem, {1, 2, 3});
  const ChainOfBlocks chain(ContactRows(problem, system.touching, system.rows));
  EXPECT_FALSE(chain.fit(ContactRows(problem, other.touching, other.rows)));
}
