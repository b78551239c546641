// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/cyclic_factors.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  CyclicFactors::CyclicFactors(const CyclicSector &sector)
      : sector(sector), cut_place(sector.n_unknowns(), numbers::invalid_unsigned_int)
  {
    const auto add_body = [&](const std::vector<unsigned int> &parts)
    {
      const CyclicSector::RealField &field = sector.field(parts[0]);
      bodies.push_back(
          {std::make_unique<SparseLDLT>(field.size, sector.dofs().get_communicator(), field.cut),
           parts});
    };
    if (sector.is_complex())
      add_body({0, 1});
    else
    {
      add_body({0});
      add_body({1});
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
    if (shift != factorised_shift)
      for (const Body &body : bodies)
      {
        SymmetricTriplets triplets = sector.shifted_stiffness(body.parts[0], shift);
        body.factors->factorise(triplets);
      }
    factorised_shift = shift;
    factorise_cut(k);
  }

  void CyclicFactors::factorise_cut(const unsigned int k)
  {
    const std::size_t size = cut_unknowns.size();
    std::vector<double> matrix(size * size, 0.);
    for (const Body &body : bodies)
      for (const unsigned int part : body.parts)
      {
        const std::vector<double> &schur = body.factors->schur_complement();
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

  unsigned int CyclicFactors::n_negative() const
  {
    unsigned int count = cut.n_negative();
    for (const Body &body : bodies)
      count += body.parts.size() * body.factors->n_negative();
    return count;
  }

  void CyclicFactors::solve(std::vector<double> &unknowns)
  {
    std::vector<double> of_cut;
    for (const unsigned int unknown : cut_unknowns)
      of_cut.push_back(unknowns[unknown]);

    for (const Body &body : bodies)
    {
      const CyclicSector::RealField &like = sector.field(body.parts[0]);
      std::vector<double> loads(body.parts.size() * like.size, 0.);
      for (unsigned int i = 0; i < body.parts.size(); ++i)
        for (const auto &[number, unknown] : sector.field(body.parts[i]).inner)
          loads[i * like.size + number] = unknowns[unknown];
      const std::vector<double> reduced = body.factors->condense(loads);
      for (unsigned int i = 0; i < body.parts.size(); ++i)
        for (const CyclicSector::Tie &tie : ties[body.parts[i]])
          of_cut[cut_place[tie.unknown]] +=
              tie.factor * reduced[i * like.cut.size() + tie.position];
    }
    cut.solve(of_cut);

    for (const Body &body : bodies)
    {
      const CyclicSector::RealField &like = sector.field(body.parts[0]);
      std::vector<double> on_cut(body.parts.size() * like.cut.size(), 0.);
      for (unsigned int i = 0; i < body.parts.size(); ++i)
        for (const CyclicSector::Tie &tie : ties[body.parts[i]])
          on_cut[i * like.cut.size() + tie.position] += tie.factor * of_cut[cut_place[tie.unknown]];
      const std::vector<double> solution = body.factors->expand(std::move(on_cut));
      for (unsigned int i = 0; i < body.parts.size(); ++i)
        for (const auto &[number, unknown] : sector.field(body.parts[i]).inner)
          unknowns[unknown] = solution[i * like.size + number];
    }
    for (std::size_t i = 0; i < cut_unknowns.size(); ++i)
      unknowns[cut_unknowns[i]] = of_cut[i];
  }
} // namespace ringmotor
