// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/cyclic_factors.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** If the cut has more than this fraction of a field, its dense matrix costs more than it
     * saves. */
    constexpr double largest_cut = 0.12;
  } // namespace

  CyclicFactors::CyclicFactors(const CyclicSector &sector)
      : sector(sector), cut_place(sector.n_unknowns(), numbers::invalid_unsigned_int)
  {
    const CyclicSector::RealField &field = sector.field(0);
    if (field.cut.empty() || field.cut.size() > largest_cut * field.size)
    {
      together = std::make_unique<SparseLDLT>(sector.n_unknowns(), sector.communicator());
      return;
    }
    const auto add_sparse_part = [&](const std::vector<unsigned int> &parts)
    {
      const CyclicSector::RealField &field = sector.field(parts[0]);
      sparse_parts.push_back(
          {std::make_unique<SparseLDLT>(field.size, sector.communicator(), field.cut), parts});
    };
    if (sector.is_complex())
      add_sparse_part({0, 1});
    else
    {
      add_sparse_part({0});
      add_sparse_part({1});
    }
    for (const unsigned int part : {0u, 1u})
      for (const CyclicSector::Tie &tie : sector.ties(part, 0))
        if (cut_place[tie.unknown] == numbers::invalid_unsigned_int)
        {
          cut_place[tie.unknown] = cut_unknowns.size();
          cut_unknowns.push_back(tie.unknown);
        }
  }

  void CyclicFactors::factorise(const unsigned int k, const double shift)
  {
    if (together)
    {
      factorise_together(k, shift);
      return;
    }
    if (shift != factorised_shift)
      for (const SparsePart &sparse : sparse_parts)
      {
        SymmetricTriplets triplets = sector.shifted_stiffness(sparse.parts[0], shift);
        sparse.factors->factorise(triplets);
      }
    factorised_shift = shift;
    factorise_cut(k);
  }

  void CyclicFactors::factorise_cut(const unsigned int k)
  {
    const std::size_t size = cut_unknowns.size();
    std::vector<double> matrix(size * size, 0.);
    for (const SparsePart &sparse : sparse_parts)
      for (const unsigned int part : sparse.parts)
      {
        const std::vector<double> &schur = sparse.factors->schur_complement();
        const std::size_t n_cut          = sector.field(part).cut.size();
        ties[part]                       = sector.ties(part, k);
        for (const CyclicSector::Tie &a : ties[part])
          for (const CyclicSector::Tie &b : ties[part])
          {
            const std::size_t row = cut_place[a.unknown], column = cut_place[b.unknown];
            if (row >= column)
              matrix[column * size + row] += a.factor * b.factor *
                                             schur[std::min(a.position, b.position) * n_cut +
                                                   std::max(a.position, b.position)];
          }
      }
    cut.factorise(size, std::move(matrix));
  }

  void CyclicFactors::factorise_together(const unsigned int k, const double shift)
  {
    struct Weighted
    {
      unsigned int unknown;
      double factor;
    };
    SymmetricTriplets all;
    for (const unsigned int part : {0u, 1u})
    {
      const CyclicSector::RealField &field = sector.field(part);
      std::vector<std::vector<Weighted>> follows(field.size); ///< by number in the field
      for (const auto &[number, unknown] : field.inner)
        follows[number] = {{unknown, 1.}};
      for (const CyclicSector::Tie &tie : sector.ties(part, k))
        follows[field.cut[tie.position]].push_back({tie.unknown, tie.factor});

      const SymmetricTriplets of_field = sector.shifted_stiffness(part, shift);
      for (std::size_t entry = 0; entry < of_field.values.size(); ++entry)
      {
        const unsigned int row = of_field.rows[entry] - 1, column = of_field.columns[entry] - 1;
        for (const Weighted &a : follows[row])
          for (const Weighted &b : follows[column])
          {
            // An entry off the diagonal stands for two; where both meet in one unknown, they add
            // up.
            const double twice = row != column && a.unknown == b.unknown ? 2. : 1.;
            if (row != column || a.unknown >= b.unknown)
              all.add(a.unknown, b.unknown, twice * a.factor * b.factor * of_field.values[entry]);
          }
      }
    }
    together->factorise(all);
  }

  unsigned int CyclicFactors::n_negative() const
  {
    if (together)
      return together->n_negative();
    unsigned int count = cut.n_negative();
    for (const SparsePart &sparse : sparse_parts)
      count += sparse.parts.size() * sparse.factors->n_negative();
    return count;
  }

  void CyclicFactors::solve(std::vector<double> &right_hand_sides)
  {
    if (together)
    {
      together->solve(right_hand_sides);
      return;
    }
    const std::size_t n_unknowns = sector.n_unknowns(), n_on_cut = cut_unknowns.size(),
                      n_sides = right_hand_sides.size() / n_unknowns;
    std::vector<double> of_cut;
    for (std::size_t side = 0; side < n_sides; ++side)
      for (const unsigned int unknown : cut_unknowns)
        of_cut.push_back(right_hand_sides[side * n_unknowns + unknown]);

    for (const SparsePart &sparse : sparse_parts)
    {
      const CyclicSector::RealField &like = sector.field(sparse.parts[0]);
      const std::size_t n_parts           = sparse.parts.size();
      std::vector<double> loads(n_sides * n_parts * like.size, 0.);
      for (std::size_t block = 0; block < n_sides * n_parts; ++block)
        for (const auto &[number, unknown] : sector.field(sparse.parts[block % n_parts]).inner)
          loads[block * like.size + number] =
              right_hand_sides[block / n_parts * n_unknowns + unknown];
      const std::vector<double> reduced = sparse.factors->condense(loads);
      for (std::size_t block = 0; block < n_sides * n_parts; ++block)
        for (const CyclicSector::Tie &tie : ties[sparse.parts[block % n_parts]])
          of_cut[block / n_parts * n_on_cut + cut_place[tie.unknown]] +=
              tie.factor * reduced[block * like.cut.size() + tie.position];
    }
    cut.solve(of_cut);

    for (const SparsePart &sparse : sparse_parts)
    {
      const CyclicSector::RealField &like = sector.field(sparse.parts[0]);
      const std::size_t n_parts           = sparse.parts.size();
      std::vector<double> on_cut(n_sides * n_parts * like.cut.size(), 0.);
      for (std::size_t block = 0; block < n_sides * n_parts; ++block)
        for (const CyclicSector::Tie &tie : ties[sparse.parts[block % n_parts]])
          on_cut[block * like.cut.size() + tie.position] +=
              tie.factor * of_cut[block / n_parts * n_on_cut + cut_place[tie.unknown]];
      const std::vector<double> solution = sparse.factors->expand(std::move(on_cut));
      for (std::size_t block = 0; block < n_sides * n_parts; ++block)
        for (const auto &[number, unknown] : sector.field(sparse.parts[block % n_parts]).inner)
          right_hand_sides[block / n_parts * n_unknowns + unknown] =
              solution[block * like.size + number];
    }
    for (std::size_t side = 0; side < n_sides; ++side)
      for (std::size_t i = 0; i < n_on_cut; ++i)
        right_hand_sides[side * n_unknowns + cut_unknowns[i]] = of_cut[side * n_on_cut + i];
  }
} // namespace ringmotor
