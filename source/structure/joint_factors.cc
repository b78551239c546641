// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/no_index.h>
#include <ringmotor/structure/joint_factors.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The rows of the sparse matrix by unknown, none for those inside cells, which have one
     * unknown each. */
    std::vector<unsigned int> number_rows(const CyclicSector &sector,
                                          const SectorStiffness &stiffness)
    {
      std::vector<unsigned int> row(sector.n_unknowns(), 0);
      for (unsigned int part = 0; part < sector.n_fields(); ++part)
      {
        const CyclicSector::RealField &field = sector.field(part);
        std::vector<unsigned int> unknown(field.size, none);
        for (const auto &[number, inner_unknown] : field.inner)
          unknown[number] = inner_unknown;
        for (unsigned int dof = 0; dof < sector.n_dofs(); ++dof)
          if (stiffness.is_inner(dof))
            row[unknown[field.number[dof]]] = none;
      }
      unsigned int n_rows = 0;
      for (unsigned int &number : row)
        if (number != none)
          number = n_rows++;
      return row;
    }

    EliminationOrder order_for(const CyclicSector &sector)
    {
      return sector.sector_mesh().form == SectorForm::ring ? EliminationOrder::nested_dissection
                                                           : EliminationOrder::minimum_fill;
    }

    std::size_t count_rows(const std::vector<unsigned int> &row)
    {
      return row.size() - std::count(row.begin(), row.end(), none);
    }
  } // namespace

  JointFactors::JointFactors(const CyclicSector &sector)
      : sector(sector), stiffness(sector, std::vector<bool>(sector.n_dofs(), false)),
        row(number_rows(sector, stiffness)),
        sparse(count_rows(row), sector.communicator(), {}, order_for(sector))
  {
  }

  void JointFactors::follow_unknowns(const unsigned int k)
  {
    for (unsigned int part = 0; part < sector.n_fields(); ++part)
    {
      const CyclicSector::RealField &field = sector.field(part);
      std::vector<Sum> of_number(field.size);
      for (const auto &[number, unknown] : field.inner)
        of_number[number] = {{unknown, 1.}};
      for (const CyclicSector::Tie &tie : sector.ties(part, k))
        of_number[field.cut[tie.position]].emplace_back(tie.unknown, tie.factor);
      follows[part].assign(sector.n_dofs(), {});
      for (unsigned int dof = 0; dof < sector.n_dofs(); ++dof)
        if (field.number[dof] != none)
          follows[part][dof] = of_number[field.number[dof]];
    }
  }

  void JointFactors::add(const SectorStiffness::Element &element, const unsigned int part,
                         SymmetricElements &elements) const
  {
    std::map<unsigned int, unsigned int> place; // of an unknown in the element
    std::vector<unsigned int> rows;
    std::vector<Sum> sums; // of each degree of freedom, by these places
    for (const SectorNodes::Dof dof : element.dofs)
    {
      sums.emplace_back();
      for (const auto &[unknown, factor] : follows[part][dof])
      {
        const auto [found, is_new] = place.emplace(unknown, rows.size());
        if (is_new)
          rows.push_back(row[unknown]);
        sums.back().emplace_back(found->second, factor);
      }
    }
    std::vector<double> lower(rows.size() * (rows.size() + 1) / 2, 0.);
    for (std::size_t j = 0; j < sums.size(); ++j)
      for (const auto &[column, factor_j] : sums[j])
      {
        double *begin = lower.data() + column * rows.size() -
                        static_cast<std::size_t>(column) * (column + 1) / 2;
        for (std::size_t i = 0; i < sums.size(); ++i)
          for (const auto &[row, factor_i] : sums[i])
            if (row >= column)
              begin[row] += factor_i * factor_j * element(i, j);
      }
    if (!rows.empty())
      elements.add(rows, lower);
  }

  void JointFactors::factorise(const unsigned int k, const double shift)
  {
    if (shift != computed_shift)
      stiffness.compute(shift);
    computed_shift = shift;
    follow_unknowns(k);
    SymmetricElements elements;
    for (const SectorStiffness::Element &element : stiffness.elements())
      for (unsigned int part = 0; part < sector.n_fields(); ++part)
        add(element, part, elements);
    sparse.factorise(std::move(elements));
  }

  void JointFactors::solve(std::vector<double> &right_hand_sides)
  {
    const std::size_t n_unknowns = sector.n_unknowns(), n_dofs = sector.n_dofs(),
                      n_fields = sector.n_fields(), n_sides = right_hand_sides.size() / n_unknowns,
                      n_rows = count_rows(row);
    // Of each side the real field, then the imaginary one.
    const auto for_each = [&](const auto &visit)
    {
      for (std::size_t side = 0; side < n_sides; ++side)
        for (unsigned int part = 0; part < n_fields; ++part)
          for (std::size_t dof = 0; dof < n_dofs; ++dof)
            for (const auto &[unknown, factor] : follows[part][dof])
              visit(side * n_unknowns + unknown, side * n_rows + row[unknown],
                    (n_fields * side + part) * n_dofs + dof, stiffness.is_inner(dof), factor);
    };
    std::vector<double> loads(n_fields * n_sides * n_dofs, 0.), on_rows(n_sides * n_rows, 0.);
    for_each(
        [&](const std::size_t unknown, std::size_t, const std::size_t dof, const bool is_inner,
            double)
        {
          if (is_inner)
            loads[dof] = right_hand_sides[unknown];
        });
    stiffness.condense(loads);
    for (std::size_t side = 0; side < n_sides; ++side)
      for (std::size_t unknown = 0; unknown < n_unknowns; ++unknown)
        if (row[unknown] != none)
          on_rows[side * n_rows + row[unknown]] = right_hand_sides[side * n_unknowns + unknown];
    for_each(
        [&](std::size_t, const std::size_t row, const std::size_t dof, const bool is_inner,
            const double factor)
        {
          if (!is_inner)
            on_rows[row] += factor * loads[dof];
        });
    sparse.solve(on_rows);

    std::vector<double> motions(loads.size(), 0.);
    for_each(
        [&](std::size_t, const std::size_t row, const std::size_t dof, const bool is_inner,
            const double factor)
        {
          if (!is_inner)
            motions[dof] += factor * on_rows[row];
        });
    stiffness.expand(loads, motions);
    for_each([&](const std::size_t unknown, const std::size_t row, const std::size_t dof,
                 const bool is_inner, double)
             { right_hand_sides[unknown] = is_inner ? motions[dof] : on_rows[row]; });
  }
} // namespace ringmotor
