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
      joint = std::make_unique<JointFactors>(sector);
      return;
    }
    inside =
        std::make_unique<SectorFactors>(sector, SectorFactors::PerField<std::vector<unsigned int>>{
                                                    {sector.field(0).cut, sector.field(1).cut}});
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
    if (joint)
    {
      joint->factorise(k, shift);
      return;
    }
    if (shift != factorised_shift)
      inside->factorise(shift);
    factorised_shift = shift;
    factorise_cut(k);
  }

  void CyclicFactors::factorise_cut(const unsigned int k)
  {
    const std::size_t size = cut_unknowns.size();
    std::vector<double> matrix(size * size, 0.);
    for (const unsigned int part : {0u, 1u})
    {
      const std::vector<double> &of_field = inside->matrix(part);
      const std::size_t n_cut             = sector.field(part).cut.size();
      ties[part]                          = sector.ties(part, k);
      for (const CyclicSector::Tie &b : ties[part])
        for (const CyclicSector::Tie &a : ties[part])
          if (cut_place[a.unknown] >= cut_place[b.unknown])
            matrix[cut_place[b.unknown] * size + cut_place[a.unknown]] +=
                a.factor * b.factor * of_field[b.position * n_cut + a.position];
    }
    cut.factorise(size, std::move(matrix));
  }

  unsigned int CyclicFactors::n_negative() const
  {
    return joint ? joint->n_negative() : cut.n_negative() + inside->n_negative();
  }

  void CyclicFactors::solve(std::vector<double> &right_hand_sides)
  {
    if (joint)
    {
      joint->solve(right_hand_sides);
      return;
    }
    const std::size_t n_unknowns = sector.n_unknowns(), n_on_cut = cut_unknowns.size(),
                      n_sides = right_hand_sides.size() / n_unknowns;
    SectorFactors::PerField<std::vector<double>> loads, on_cut;
    for (const unsigned int part : {0u, 1u})
    {
      const CyclicSector::RealField &field = sector.field(part);
      loads[part].assign(n_sides * field.size, 0.);
      for (std::size_t side = 0; side < n_sides; ++side)
        for (const auto &[number, unknown] : field.inner)
          loads[part][side * field.size + number] = right_hand_sides[side * n_unknowns + unknown];
    }
    const auto left = inside->condense(loads);
    std::vector<double> of_cut;
    for (std::size_t side = 0; side < n_sides; ++side)
      for (const unsigned int unknown : cut_unknowns)
        of_cut.push_back(right_hand_sides[side * n_unknowns + unknown]);
    const auto for_each_tie = [&](const auto &visit)
    {
      for (const unsigned int part : {0u, 1u})
        for (std::size_t side = 0; side < n_sides; ++side)
          for (const CyclicSector::Tie &tie : ties[part])
            visit(part, side * sector.field(part).cut.size() + tie.position,
                  side * n_on_cut + cut_place[tie.unknown], tie.factor);
    };
    for_each_tie([&](const unsigned int part, const std::size_t position, const std::size_t place,
                     const double factor) { of_cut[place] += factor * left[part][position]; });
    cut.solve(of_cut);

    for (const unsigned int part : {0u, 1u})
      on_cut[part].assign(n_sides * sector.field(part).cut.size(), 0.);
    for_each_tie([&](const unsigned int part, const std::size_t position, const std::size_t place,
                     const double factor) { on_cut[part][position] += factor * of_cut[place]; });
    const auto solutions = inside->expand(on_cut);
    for (std::size_t side = 0; side < n_sides; ++side)
    {
      double *solution = right_hand_sides.data() + side * n_unknowns;
      for (const unsigned int part : {0u, 1u})
        for (const auto &[number, unknown] : sector.field(part).inner)
          solution[unknown] = solutions[part][side * sector.field(part).size + number];
      for (std::size_t i = 0; i < n_on_cut; ++i)
        solution[cut_unknowns[i]] = of_cut[side * n_on_cut + i];
    }
  }
} // namespace ringmotor
