// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/lu_factors.h>
#include <ringmotor/contact/solve/chain_of_blocks.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The blocks of the problem that touch, and those whose far motions matter. */
    struct TouchingBlocks
    {
      explicit TouchingBlocks(const ContactRows &rows)
      {
        constexpr unsigned int none     = BlockStructure::no_part;
        const BlockStructure &structure = rows.contact_problem().structure();
        unsigned int last               = none; // neighbours are in the same block
        for (const unsigned int point : rows.touching_points())
        {
          const unsigned int block = structure.block_of_point(point);
          if (block == last)
            continue;
          last = block;
          touching.insert(block);
          felt.insert(block);
          const unsigned int before = structure.block_before(block);
          if (before == none || before == block) // no slip at all
            continue;
          felt.insert(before);
          has_chains = true;
        }
      }

      /** The number of far shapes of each. The first shapes are the most significant. Along chains
       * the Krylov method takes some 10 steps with three to six of them, which take less time than
       * the larger small system of more; without chains six do as well as more. */
      unsigned int n_shapes(const BlockStructure &structure) const
      {
        constexpr unsigned int fewest = 3, affordable = 600, without_chains = 6;
        return std::min(structure.n_far_shapes(),
                        has_chains ? std::max<unsigned int>(fewest, affordable / felt.size())
                                   : without_chains);
      }

      std::set<unsigned int> touching, felt;
      bool has_chains = false; ///< slips are measured from other blocks
    };
  } // namespace

  ChainOfBlocks::Cost ChainOfBlocks::cost_of(const ContactRows &rows)
  {
    const TouchingBlocks of(rows);
    if (of.touching.empty())
      return {false, 0, 0.};
    const double n = rows.unknowns().size(), of_block = n / of.touching.size();
    const unsigned int n_shapes = of.n_shapes(rows.contact_problem().structure());
    const double n_far          = n_shapes * of.felt.size(),
                 n_small        = n_far + rows.n_rigid() + (of.has_chains ? of_block : 0.);
    // Along a chain the forces of its last blocks depend on all unknowns of the small system.
    const double n_columns = of.has_chains ? n_small : n_shapes + rows.n_rigid();
    return {of.has_chains, static_cast<unsigned int>(n_small),
            2. / 3. * (std::pow(n_small, 3) + n * of_block * of_block) +
                2. * n_columns * (2. * n * of_block + n_far * n_far)};
  }

  ChainOfBlocks::ChainOfBlocks(const ContactRows &rows)
      : made_for(rows), n_rigid(rows.n_rigid()), balances(n_rigid, rows.n_of_nodes())
  {
    for (unsigned int r = 0; r < n_rigid; ++r)
      for (unsigned int i = 0; i < rows.n_of_nodes(); ++i)
        balances(r, i) = rows.balance_of(r, i);
    find_blocks(rows);
    choose_shapes(rows);
    make_kernel(rows.contact_problem().structure());
    cut_chains(rows);
    n_small = n_far + n_cuts + n_rigid;
    for (Block &block : blocks)
    {
      block.own = near_matrix(rows, block, block);
      if (!factorise(block.own))
        return;
      share_columns(rows, block);
    }
    make_small_system(rows);
    regular = n_small == 0 || factorise(small);
  }

  bool ChainOfBlocks::fit(const ContactRows &rows) const
  {
    return made_for.are_of(rows);
  }

  void ChainOfBlocks::find_blocks(const ContactRows &rows)
  {
    const BlockStructure &structure = rows.contact_problem().structure();
    std::vector<unsigned int> place(structure.n_blocks(), none);
    for (const unsigned int unknown : rows.unknowns())
    {
      if (unknown >= rows.n_of_nodes())
        break;
      const unsigned int number = structure.block_of_point(rows.point_of(unknown));
      if (place[number] == none)
      {
        place[number] = blocks.size();
        blocks.emplace_back();
        blocks.back().number = number;
        blocks.back().before = structure.block_before(number);
      }
      Block &block                  = blocks[place[number]];
      const Tensor<1, 3> &by_motion = rows.by_motion(unknown);
      if (block.before != none && (by_motion[1] != 0. || by_motion[2] != 0.))
        block.slips.push_back(block.unknowns.size());
      block.unknowns.push_back(unknown);
    }
    for (Block &block : blocks)
    {
      if (block.before == block.number) // no slip at all
        block.before = none;
      block.place_before = block.before == none ? none : place[block.before];
    }
    const TouchingBlocks of(rows);
    felt.assign(of.felt.begin(), of.felt.end()); // in ascending order
    n_shapes = of.n_shapes(structure);
    n_far    = n_shapes * felt.size();
  }

  void ChainOfBlocks::choose_shapes(const ContactRows &rows)
  {
    const BlockStructure &structure = rows.contact_problem().structure();
    for (Block &block : blocks)
    {
      const unsigned int n = block.unknowns.size();
      for (LAPACKFullMatrix<double> *matrix : {&block.shapes, &block.by_motion, &block.by_slip})
        matrix->reinit(n, n_shapes);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int s = 0; s < n_shapes; ++s)
          {
            const unsigned int unknown = block.unknowns[i];
            const double shape         = structure.far_shape(rows.point_of(unknown), c, s);
            if (c == unknown % 3)
              block.shapes(i, s) = shape;
            block.by_motion(i, s) += rows.by_motion(unknown)[c] * shape;
            if (c > 0)
              block.by_slip(i, s) += rows.by_motion(unknown)[c] * shape;
          }
    }
  }

  void ChainOfBlocks::make_kernel(const BlockStructure &structure)
  {
    kernel.reinit(n_far, n_shapes * blocks.size());
    for (unsigned int b = 0; b < blocks.size() && n_shapes > 0; ++b)
      for (unsigned int g = 0; g < felt.size(); ++g)
        if (const FullMatrix<double> *of_pair = structure.far_kernel(felt[g], blocks[b].number))
          for (unsigned int s = 0; s < n_shapes; ++s)
            for (unsigned int t = 0; t < n_shapes; ++t)
              kernel(n_shapes * g + s, n_shapes * b + t) = (*of_pair)(s, t);
  }

  void ChainOfBlocks::cut_chains(const ContactRows &rows)
  {
    std::vector<unsigned int> after(blocks.size(), none);
    for (unsigned int b = 0; b < blocks.size(); ++b)
      if (blocks[b].place_before != none)
        after[blocks[b].place_before] = b;
    std::vector<char> is_done(blocks.size(), false);
    for (unsigned int first = 0; first < blocks.size(); ++first)
    {
      if (is_done[first])
        continue;
      // Back to where the chain begins or, once around a ring, to where the least is handed on.
      unsigned int begin = first, b = first;
      do
      {
        if (blocks[b].place_before == none || blocks[b].slips.size() < blocks[begin].slips.size())
          begin = b;
        b = blocks[b].place_before;
      } while (b != none && b != first);
      cuts.push_back(begin);
      blocks[begin].is_cut    = true;
      blocks[begin].first_cut = n_cuts;
      if (blocks[begin].place_before != none)
        n_cuts += blocks[begin].slips.size();
      for (b = begin; b != none && !is_done[b]; b = after[b])
      {
        is_done[b] = true;
        order.push_back(b);
      }
    }
    for (Block &block : blocks)
      if (block.place_before != none)
      {
        const Block &before                   = blocks[block.place_before];
        const LAPACKFullMatrix<double> matrix = near_matrix(rows, block, before);
        block.by_before.reinit(block.slips.size(), before.unknowns.size());
        for (unsigned int i = 0; i < block.slips.size(); ++i)
          for (unsigned int j = 0; j < before.unknowns.size(); ++j)
            block.by_before(i, j) = -matrix(block.slips[i], j);
      }
  }

  LAPACKFullMatrix<double> ChainOfBlocks::near_matrix(const ContactRows &rows, const Block &block,
                                                      const Block &loaded) const
  {
    LAPACKFullMatrix<double> matrix = rows.matrix_of(block.unknowns, loaded.unknowns);
    const auto add =
        [&](const LAPACKFullMatrix<double> &motions, const unsigned int moved, const double factor)
    {
      const FullMatrix<double> *of_pair =
          rows.contact_problem().structure().far_kernel(moved, loaded.number);
      if (!of_pair || n_shapes == 0)
        return;
      FullMatrix<double> first_shapes(n_shapes, n_shapes);
      first_shapes.fill(*of_pair);
      LAPACKFullMatrix<double> between(n_shapes), by_shapes(motions.m(), n_shapes),
          entries(matrix.m(), matrix.n());
      between = first_shapes;
      motions.mmult(by_shapes, between);
      by_shapes.mTmult(entries, loaded.shapes);
      matrix.add(factor, entries);
    };
    add(block.by_motion, block.number, -1.);
    if (block.before != none)
      add(block.by_slip, block.before, 1.); // slips are differences
    return matrix;
  }

  void ChainOfBlocks::share_columns(const ContactRows &rows, Block &block) const
  {
    const unsigned int n = block.unknowns.size();
    std::vector<Vector<double>> columns;
    const auto add = [&](const unsigned int number, const Vector<double> &column)
    {
      block.shared.push_back(number);
      columns.push_back(column);
    };
    const auto add_far =
        [&](const unsigned int of, const LAPACKFullMatrix<double> &motions, const double factor)
    {
      const unsigned int place = std::lower_bound(felt.begin(), felt.end(), of) - felt.begin();
      for (unsigned int s = 0; s < n_shapes; ++s)
      {
        Vector<double> column(n);
        for (unsigned int i = 0; i < n; ++i)
          column[i] = factor * motions(i, s);
        add(n_shapes * place + s, column);
      }
    };
    add_far(block.number, block.by_motion, -1.);
    if (block.before != none)
      add_far(block.before, block.by_slip, 1.);
    if (block.is_cut && block.place_before != none)
      for (unsigned int i = 0; i < block.slips.size(); ++i)
      {
        Vector<double> column(n);
        column[block.slips[i]] = 1.;
        add(n_far + block.first_cut + i, column);
      }
    const LAPACKFullMatrix<double> by_rigid = rows.matrix_of(block.unknowns, rows.rigid_unknowns());
    for (unsigned int r = 0; r < n_rigid; ++r)
    {
      Vector<double> column(n);
      for (unsigned int i = 0; i < n; ++i)
        column[i] = -by_rigid(i, r);
      if (column.linfty_norm() > 0.)
        add(n_far + n_cuts + r, column);
    }
    block.by_shared.reinit(n, columns.size());
    for (unsigned int j = 0; j < columns.size(); ++j)
      for (unsigned int i = 0; i < n; ++i)
        block.by_shared(i, j) = columns[j][i];
  }

  std::vector<Vector<double>> ChainOfBlocks::forces(const Vector<double> &vector,
                                                    const Vector<double> *shared) const
  {
    std::vector<Vector<double>> result(blocks.size());
    for (const unsigned int b : order)
    {
      const Block &block  = blocks[b];
      Vector<double> &own = result[b];
      own.reinit(block.unknowns.size());
      for (unsigned int i = 0; i < own.size(); ++i)
        own[i] = vector[block.unknowns[i]];
      if (block.continues_chain())
      {
        Vector<double> handed_on(block.slips.size());
        block.by_before.vmult(handed_on, result[block.place_before]);
        for (unsigned int i = 0; i < handed_on.size(); ++i)
          own[block.slips[i]] += handed_on[i];
      }
      if (shared && !block.shared.empty())
      {
        Vector<double> values(block.shared.size());
        for (unsigned int j = 0; j < values.size(); ++j)
          values[j] = (*shared)[block.shared[j]];
        block.by_shared.vmult(own, values, /*adding =*/true);
      }
      block.own.solve(own);
    }
    return result;
  }

  Vector<double> ChainOfBlocks::start(const Vector<double> &right_hand_side) const
  {
    return Vector<double>(right_hand_side.size());
  }

  void ChainOfBlocks::vmult(Vector<double> &result, const Vector<double> &vector) const
  {
    std::vector<Vector<double>> of_blocks = forces(vector, nullptr);
    result                                = 0.;
    if (n_small > 0)
    {
      const Vector<double> shared = solve_small_system(of_blocks, vector);
      of_blocks                   = forces(vector, &shared);
      for (unsigned int r = 0; r < n_rigid; ++r)
        result[balances.n() + r] = shared[n_far + n_cuts + r];
    }
    for (unsigned int b = 0; b < blocks.size(); ++b)
      for (unsigned int i = 0; i < of_blocks[b].size(); ++i)
        result[blocks[b].unknowns[i]] = of_blocks[b][i];
  }
} // namespace ringmotor
