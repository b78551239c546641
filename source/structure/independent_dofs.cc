// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/independent_dofs.h>

#include <algorithm>
#include <map>

namespace ringmotor
{
  using namespace dealii;

  FullMatrix<double> transformed(const FullMatrix<double> &matrix,
                                 const FullMatrix<double> &follows)
  {
    FullMatrix<double> times(matrix.m(), follows.n()), result(follows.n(), follows.n());
    if (!result.empty())
    {
      matrix.mmult(times, follows);
      follows.Tmmult(result, times);
    }
    return result;
  }

  IndependentDofs::IndependentDofs(const std::vector<SectorNodes::Dof> &dofs,
                                   const AffineConstraints<double> &dependent)
  {
    if (std::none_of(dofs.begin(), dofs.end(),
                     [&](const SectorNodes::Dof dof) { return dependent.is_constrained(dof); }))
    {
      independent = dofs;
      return;
    }
    all_independent = false;
    // Masters first, so that degrees of freedom inside a cell stay the last ones.
    std::map<SectorNodes::Dof, unsigned int> place;
    const auto list = [&](const SectorNodes::Dof dof)
    {
      if (place.emplace(dof, independent.size()).second)
        independent.push_back(dof);
    };
    for (const SectorNodes::Dof dof : dofs)
      if (dependent.is_constrained(dof))
        for (const auto &entry : *dependent.get_constraint_entries(dof))
          list(entry.first);
    for (const SectorNodes::Dof dof : dofs)
      if (!dependent.is_constrained(dof))
        list(dof);

    follows.reinit(dofs.size(), independent.size());
    for (unsigned int i = 0; i < dofs.size(); ++i)
      if (!dependent.is_constrained(dofs[i]))
        follows(i, place.at(dofs[i])) = 1.;
      else
        for (const auto &[master, weight] : *dependent.get_constraint_entries(dofs[i]))
          follows(i, place.at(master)) += weight;
  }

  void IndependentDofs::condense(FullMatrix<double> &matrix) const
  {
    if (!all_independent)
      matrix = transformed(matrix, follows);
  }
} // namespace ringmotor
