// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/condensation_reduced.h>
#include <ringmotor/structure/sparse_ldlt.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int none = numbers::invalid_unsigned_int;
  }

  std::vector<double> Condensation::field_solutions(const Reduced &reduced, const unsigned int part,
                                                    const std::vector<double> &unknowns) const
  {
    const std::size_t n_rows = fields[part].kept.size(), n_loads = unknowns.size() / reduced.size;
    std::vector<double> kept(n_loads * n_rows, 0.);
    for (std::size_t l = 0; l < n_loads; ++l)
    {
      const double *stays = unknowns.data() + l * reduced.size;
      std::vector<double> cut(reduced.n_cut, 0.);
      for (std::size_t column = 0; column < reduced.size; ++column)
        for (std::size_t i = 0; i < cut.size(); ++i)
          cut[i] -= reduced.cut_response[column * cut.size() + i] * stays[column];
      for (std::size_t row = 0; row < n_rows; ++row)
        for (const Reduced::Part &entry : reduced.rows[part][row])
          kept[l * n_rows + row] += entry.factor * (reduced.place[entry.unknown] != none
                                                        ? stays[reduced.place[entry.unknown]]
                                                        : cut[reduced.cut_place[entry.unknown]]);
    }
    SparseLDLT &factors     = *fields[part].factors;
    const auto n_of_field   = std::count_if(supports.begin(), supports.end(),
                                            [&](const auto &s) { return s.part == part; });
    const std::size_t width = sector.field(part).size + n_of_field;
    factors.condense(std::vector<double>(n_loads * width, 0.));
    return factors.expand(std::move(kept));
  }

  std::vector<SectorMotion> Condensation::interior(const unsigned int k,
                                                   const std::vector<unsigned int> &held,
                                                   const std::vector<CondensationLoad> &loads) const
  {
    AssertThrow(fields[0].factors, ExcMessage("the inside of this body has not been kept"));
    if (loads.empty())
      return {};
    const Reduced reduced              = reduce(k, held);
    const std::vector<double> unknowns = solutions(reduced, held, loads);
    const std::array<std::vector<double>, 2> solved{
        {field_solutions(reduced, 0, unknowns), field_solutions(reduced, 1, unknowns)}};
    std::vector<SectorMotion> motions;
    for (std::size_t l = 0; l < loads.size(); ++l)
    {
      std::array<Vector<double>, 2> motion;
      for (const unsigned int part : {0u, 1u})
      {
        motion[part].reinit(sector.n_dofs());
        const std::vector<unsigned int> &number = sector.field(part).number;
        const std::size_t width                 = solved[part].size() / loads.size();
        for (SectorNodes::Dof dof = 0; dof < number.size(); ++dof)
          if (number[dof] != none)
            motion[part][dof] = solved[part][l * width + number[dof]];
      }
      motions.push_back(sector.to_motion(std::move(motion)));
    }
    return motions;
  }
} // namespace ringmotor
