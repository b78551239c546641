// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/no_index.h>
#include <ringmotor/condensation/condensation_tied.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  SectorFactors::PerField<std::vector<double>>
  Condensation::field_solutions(const Tied &tied, const std::vector<double> &unknowns) const
  {
    const std::size_t n_loads = unknowns.size() / tied.size;
    SectorFactors::PerField<std::vector<double>> kept, no_loads;
    for (const unsigned int part : {0u, 1u})
    {
      const std::size_t n_rows = fields[part].kept.size();
      kept[part].assign(n_loads * n_rows, 0.);
      const auto n_supports = std::count_if(supports.begin(), supports.end(),
                                            [&](const auto &s) { return s.part == part; });
      no_loads[part].assign(n_loads * (sector.field(part).size + n_supports), 0.);
    }
    for (std::size_t l = 0; l < n_loads; ++l)
      for (const unsigned int part : {0u, 1u})
        for (std::size_t row = 0; row < fields[part].kept.size(); ++row)
          for (const auto &[place, factor] : tied.rows[part][row])
            kept[part][l * fields[part].kept.size() + row] +=
                factor * unknowns[l * tied.size + place];
    factors->condense(no_loads);
    return factors->expand(kept);
  }

  std::vector<SectorMotion> Condensation::interior(const unsigned int k,
                                                   const std::vector<unsigned int> &held,
                                                   const std::vector<CondensationLoad> &loads) const
  {
    AssertThrow(factors, ExcMessage("the inside of this body has not been kept"));
    if (loads.empty())
      return {};
    const Tied tied   = tie(k, held);
    const auto solved = field_solutions(tied, solutions(tied, held, loads));
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
