// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The small dense system of ChainOfBlocks, for what its blocks have in common.

#include <ringmotor/contact/solve/chain_of_blocks.h>

#include <algorithm>
#include <iterator>

namespace ringmotor
{
  using namespace dealii;

  LAPACKFullMatrix<double>
  ChainOfBlocks::forces_by_shared(const Block &block, const LAPACKFullMatrix<double> &before,
                                  const std::vector<unsigned int> &place_of,
                                  const unsigned int n_columns) const
  {
    LAPACKFullMatrix<double> forces(block.unknowns.size(), n_columns);
    if (block.continues_chain() && before.n() > 0)
    {
      LAPACKFullMatrix<double> handed_on(block.slips.size(), before.n());
      block.by_before.mmult(handed_on, before);
      for (unsigned int j = 0; j < before.n(); ++j)
        for (unsigned int i = 0; i < block.slips.size(); ++i)
          forces(block.slips[i], j) = handed_on(i, j);
    }
    for (unsigned int j = 0; j < block.shared.size(); ++j)
      for (unsigned int i = 0; i < block.unknowns.size(); ++i)
        forces(i, place_of[block.shared[j]]) += block.by_shared(i, j);
    if (n_columns > 0)
      block.own.solve(forces);
    return forces;
  }

  void ChainOfBlocks::make_small_system(const ContactRows &rows)
  {
    small.reinit(n_small);
    for (auto begin = order.begin(); begin != order.end();)
    {
      const auto end =
          std::find_if(std::next(begin), order.end(),
                       [&](const unsigned int b) { return !blocks[b].continues_chain(); });
      add_chain({begin, end});
      begin = end;
    }
    for (unsigned int i = 0; i < n_far + n_cuts; ++i)
      small(i, i) += 1.;
    const LAPACKFullMatrix<double> of_rigid =
        rows.matrix_of(rows.rigid_unknowns(), rows.rigid_unknowns());
    for (unsigned int r = 0; r < n_rigid; ++r)
      for (unsigned int s = 0; s < n_rigid; ++s)
        small(n_far + n_cuts + r, n_far + n_cuts + s) += of_rigid(r, s);
  }

  void ChainOfBlocks::add_chain(const std::vector<unsigned int> &chain)
  {
    std::vector<unsigned int> columns, n_columns, place_of(n_small, none); // of the small system
    for (const unsigned int b : chain)
    {
      for (const unsigned int column : blocks[b].shared)
        if (place_of[column] == none)
        {
          place_of[column] = columns.size();
          columns.push_back(column);
        }
      n_columns.push_back(columns.size());
    }
    LAPACKFullMatrix<double> far_forces(n_shapes * chain.size(), columns.size()),
        far_kernel(n_far, n_shapes * chain.size()), far_motion(n_far, columns.size()), forces;
    for (unsigned int place = 0; place < chain.size(); ++place)
    {
      const Block &block = blocks[chain[place]];
      forces             = forces_by_shared(block, forces, place_of, n_columns[place]);
      add_handed_on(chain[place], forces, columns, small);
      LAPACKFullMatrix<double> of_shapes(n_shapes, n_columns[place]);
      if (n_shapes > 0)
        block.shapes.Tmmult(of_shapes, forces);
      for (unsigned int s = 0; s < n_shapes; ++s)
      {
        for (unsigned int j = 0; j < n_columns[place]; ++j)
          far_forces(n_shapes * place + s, j) = of_shapes(s, j);
        for (unsigned int i = 0; i < n_far; ++i)
          far_kernel(i, n_shapes * place + s) = kernel(i, n_shapes * chain[place] + s);
      }
    }
    if (n_far > 0)
      far_kernel.mmult(far_motion, far_forces);
    for (unsigned int j = 0; j < columns.size(); ++j)
      for (unsigned int i = 0; i < n_far; ++i)
        small(i, columns[j]) -= far_motion(i, j);
  }

  void ChainOfBlocks::add_handed_on(const unsigned int place,
                                    const LAPACKFullMatrix<double> &forces,
                                    const std::vector<unsigned int> &columns,
                                    LAPACKFullMatrix<double> &matrix) const
  {
    for (const unsigned int cut : cuts)
      if (const Block &after = blocks[cut]; after.place_before == place)
        for (unsigned int k = 0; k < after.slips.size(); ++k)
          for (unsigned int j = 0; j < forces.n(); ++j)
            for (unsigned int i = 0; i < forces.m(); ++i)
              matrix(n_far + after.first_cut + k, columns[j]) -=
                  after.by_before(k, i) * forces(i, j);
    for (unsigned int r = 0; r < n_rigid; ++r)
      for (unsigned int i = 0; i < forces.m(); ++i)
      {
        const double balance = balances(r, blocks[place].unknowns[i]);
        if (balance != 0.)
          for (unsigned int j = 0; j < forces.n(); ++j)
            matrix(n_far + n_cuts + r, columns[j]) += balance * forces(i, j);
      }
  }

  Vector<double> ChainOfBlocks::solve_small_system(const std::vector<Vector<double>> &forces,
                                                   const Vector<double> &vector) const
  {
    LAPACKFullMatrix<double> defect(n_small, 1);
    Vector<double> far_forces(kernel.n()), solution(n_small);
    for (unsigned int b = 0; b < blocks.size(); ++b)
    {
      LAPACKFullMatrix<double> column(forces[b].size(), 1);
      for (unsigned int i = 0; i < forces[b].size(); ++i)
      {
        column(i, 0) = forces[b][i];
        for (unsigned int s = 0; s < n_shapes; ++s)
          far_forces[n_shapes * b + s] += blocks[b].shapes(i, s) * forces[b][i];
      }
      add_handed_on(b, column, {0}, defect);
    }
    for (unsigned int i = n_far; i < n_small; ++i)
      solution[i] = -defect(i, 0);
    if (n_far > 0)
    {
      Vector<double> far_motion(n_far);
      kernel.vmult(far_motion, far_forces);
      std::copy(far_motion.begin(), far_motion.end(), solution.begin());
    }
    for (unsigned int r = 0; r < n_rigid; ++r)
      solution[n_far + n_cuts + r] += vector[balances.n() + r];
    small.solve(solution);
    return solution;
  }
} // namespace ringmotor
