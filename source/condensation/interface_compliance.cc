// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/dense_ldlt.h>
#include <ringmotor/algebra/no_index.h>
#include <ringmotor/algebra/rank_factors.h>
#include <ringmotor/condensation/interface_compliance.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace ringmotor
{
  using namespace dealii;

  InterfaceCompliance::InterfaceCompliance(const Condensation &condensation)
      : condensation(condensation), fields{{split(condensation, 0), split(condensation, 1)}}
  {
  }

  InterfaceCompliance::Rows InterfaceCompliance::rows_of(const Condensation &condensation,
                                                         const unsigned int part)
  {
    const Condensation::Field &condensed = condensation.fields[part];
    const std::size_t n_rows             = condensed.kept.size();
    std::vector<bool> is_driven(n_rows, false);
    for (const SectorNodes::Dof dof : condensation.driven)
      if (condensed.row_of_dof[dof] != none)
        is_driven[condensed.row_of_dof[dof]] = true;
    Rows rows;
    std::vector<unsigned int> place(n_rows, none);
    for (unsigned int row = 0; row < n_rows; ++row)
      if (!is_driven[row])
      {
        const bool of_cut = condensed.unknown[row] == none ||
                            condensed.unknown[row] >= condensation.sector.n_unknowns();
        place[row] = of_cut ? rows.cut.size() : rows.inner.size();
        (of_cut ? rows.cut : rows.inner).push_back(row);
      }
    const std::size_t n_forms = condensation.interface.size();
    rows.by_cut.reinit(n_forms, rows.cut.size());
    rows.forms.resize(n_forms);
    for (std::size_t f = 0; f < n_forms; ++f)
      for (const auto &[dof, coefficient] : condensation.interface[f])
      {
        const unsigned int row = condensed.row_of_dof[dof];
        if (row == none || is_driven[row])
          continue;
        if (condensed.unknown[row] == none)
          rows.by_cut(f, place[row]) += coefficient;
        else
          rows.forms[f].emplace_back(place[row], coefficient);
      }
    return rows;
  }

  InterfaceCompliance::Field InterfaceCompliance::split(const Condensation &condensation,
                                                        const unsigned int part)
  {
    const Condensation::Field &condensed = condensation.fields[part];
    const auto stiffness                 = [&](const std::size_t i, const std::size_t j)
    { return condensed.matrix[j * condensed.kept.size() + i]; };
    Rows rows                 = rows_of(condensation, part);
    const std::size_t n_inner = rows.inner.size(), n_cut = rows.cut.size(),
                      n_forms = rows.forms.size();
    // Motions of the inner rows due to forces on the interface, and minus those due to the cut.
    std::vector<double> matrix(n_inner * n_inner), motions((n_forms + n_cut) * n_inner, 0.);
    FullMatrix<double> across(n_inner, n_cut), followed(n_inner, n_cut);
    for (std::size_t i = 0; i < n_inner; ++i)
    {
      for (std::size_t j = 0; j < n_inner; ++j)
        matrix[j * n_inner + i] = stiffness(rows.inner[i], rows.inner[j]);
      for (std::size_t j = 0; j < n_cut; ++j)
        motions[(n_forms + j) * n_inner + i] = across(i, j) = stiffness(rows.inner[i], rows.cut[j]);
    }
    for (std::size_t f = 0; f < n_forms; ++f)
      for (const auto &[place, coefficient] : rows.forms[f])
        motions[f * n_inner + place] += coefficient;
    DenseLDLT factors;
    factors.factorise(n_inner, std::move(matrix));
    factors.solve(motions);

    Field field;
    field.at_rest.reinit(n_forms, n_forms);
    for (std::size_t f = 0; f < n_forms; ++f)
      for (const auto &[place, coefficient] : rows.forms[f])
      {
        for (std::size_t g = 0; g < n_forms; ++g)
          field.at_rest(f, g) += coefficient * motions[g * n_inner + place];
        for (std::size_t j = 0; j < n_cut; ++j)
          rows.by_cut(f, j) -= coefficient * motions[(n_forms + j) * n_inner + place];
      }
    field.at_rest.symmetrize(); // symmetric up to rounding
    field.cut.reinit(n_cut, n_cut);
    for (std::size_t j = 0; j < n_cut; ++j)
    {
      for (std::size_t i = 0; i < n_inner; ++i)
        followed(i, j) = -motions[(n_forms + j) * n_inner + i];
      for (std::size_t i = 0; i < n_cut; ++i)
        field.cut(i, j) = stiffness(rows.cut[i], rows.cut[j]);
    }
    if (n_inner > 0 && n_cut > 0)
      across.Tmmult(field.cut, followed, true);
    find_shapes(rows.by_cut, field);
    return field;
  }

  void InterfaceCompliance::find_shapes(FullMatrix<double> by_cut, Field &field)
  {
    // Columns scaled to m/sqrt(N m): those that are small then barely move the interface.
    std::vector<double> scale(by_cut.n(), 1.);
    for (std::size_t j = 0; j < scale.size(); ++j)
      if (field.cut(j, j) != 0.)
        scale[j] = std::sqrt(std::abs(field.cut(j, j)));
    const auto scale_columns = [&](FullMatrix<double> &matrix, const int power)
    {
      for (std::size_t i = 0; i < matrix.m(); ++i)
        for (std::size_t j = 0; j < scale.size(); ++j)
          matrix(i, j) *= std::pow(scale[j], power);
    };
    constexpr double rounding = 1e-15;
    scale_columns(by_cut, -1);
    RankFactors factored(by_cut, rounding);
    field.shapes = std::move(factored.columns);
    field.loads  = std::move(factored.weights);
    scale_columns(field.loads, 1);
  }

  const CyclicSector &InterfaceCompliance::sector() const
  {
    return condensation.sector;
  }

  std::map<unsigned int, unsigned int> InterfaceCompliance::places() const
  {
    std::map<unsigned int, unsigned int> places;
    for (const unsigned int part : {0u, 1u})
      for (const CyclicSector::Tie &tie : sector().ties(part, 0))
        places.emplace(tie.unknown, places.size());
    return places;
  }

  InterfaceCompliance::CutSolutions
  InterfaceCompliance::solve_cut(const unsigned int k, const std::vector<unsigned int> &held) const
  {
    const CyclicSector &sector                 = condensation.sector;
    std::map<unsigned int, unsigned int> place = places();
    // How the rows of both cuts depend on the unknowns of the nodal diameter.
    std::array<std::vector<CyclicSector::Tie>, 2> ties;
    for (const unsigned int part : {0u, 1u})
    {
      ties[part]            = sector.ties(part, k);
      unsigned int position = sector.field(part).cut.size();
      for (unsigned int s = 0; s < condensation.supports.size(); ++s)
        if (condensation.supports[s].part == part)
        {
          if (std::find(held.begin(), held.end(), s) != held.end())
            ties[part].push_back({position, sector.n_unknowns() + s, 1.});
          ++position;
        }
      for (CyclicSector::Tie &tie : ties[part])
        tie.unknown = place.emplace(tie.unknown, place.size()).first->second;
    }
    const std::size_t size = place.size(), n_shapes = shapes(0).n() + shapes(1).n();
    if (size == 0 || n_shapes == 0)
      return CutSolutions();

    std::vector<double> matrix(size * size, 0.), loads(n_shapes * size, 0.);
    for (const unsigned int part : {0u, 1u})
    {
      const std::size_t first = part == 0 ? 0 : shapes(0).n();
      for (const CyclicSector::Tie &column : ties[part])
      {
        for (const CyclicSector::Tie &row : ties[part])
          matrix[column.unknown * size + row.unknown] +=
              row.factor * column.factor * fields[part].cut(column.position, row.position);
        for (std::size_t shape = 0; shape < shapes(part).n(); ++shape)
          loads[(first + shape) * size + column.unknown] +=
              column.factor * fields[part].loads(shape, column.position);
      }
    }
    DenseLDLT factors;
    factors.factorise(size, std::move(matrix));
    std::vector<double> motions = loads;
    factors.solve(motions);
    return {FullMatrix<double>(n_shapes, size, loads.data()),
            FullMatrix<double>(n_shapes, size, motions.data())};
  }

  FullMatrix<double> InterfaceCompliance::CutSolutions::response() const
  {
    FullMatrix<double> response(loads.m(), loads.m());
    if (!loads.empty())
      loads.mTmult(response, motions);
    response.symmetrize(); // symmetric up to rounding
    return response;
  }

  FullMatrix<double> InterfaceCompliance::compliance(const unsigned int k,
                                                     const std::vector<unsigned int> &held) const
  {
    const unsigned int n_forms = condensation.interface.size();
    FullMatrix<double> compliance(2 * n_forms, 2 * n_forms);
    const FullMatrix<double> response = through_cut(k, held);
    for (const unsigned int i : {0u, 1u})
    {
      for (unsigned int f = 0; f < n_forms; ++f)
        for (unsigned int g = 0; g < n_forms; ++g)
          compliance(i * n_forms + f, i * n_forms + g) = at_rest(i)(f, g);
      for (const unsigned int j : {0u, 1u})
      {
        const unsigned int m = shapes(i).n(), n = shapes(j).n();
        if (m == 0 || n == 0)
          continue;
        FullMatrix<double> block(m, n), half(n_forms, n), whole(n_forms, n_forms);
        block.fill(response, 0, 0, i * shapes(0).n(), j * shapes(0).n());
        shapes(i).mmult(half, block);
        half.mTmult(whole, shapes(j));
        compliance.add(whole, 1., i * n_forms, j * n_forms);
      }
    }
    compliance.symmetrize(); // symmetric up to rounding
    return compliance;
  }
} // namespace ringmotor
