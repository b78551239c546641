// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/blas.h>
#include <ringmotor/algebra/dense_ldlt.h>
#include <ringmotor/algebra/no_index.h>
#include <ringmotor/condensation/condensation_reduced.h>
#include <ringmotor/mesh/ids.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  Condensation::Condensation(const CyclicSector &sector, const std::vector<LinearForm> &interface,
                             const std::vector<SectorNodes::Dof> &driven,
                             const std::vector<CondensationSupport> &supports, const double shift,
                             const bool with_interior)
      : sector(sector), interface(interface), driven(driven), supports(supports),
        at_interface(sector.n_dofs(), false)
  {
    for (const LinearForm &form : interface)
      for (const auto &[dof, coefficient] : form)
        at_interface[dof] = true;
    for (const SectorNodes::Dof dof : driven)
    {
      at_interface[dof] = true;
      for (const auto cut : {ids::cut, ids::cut_low, ids::cut_high})
        AssertThrow(!sector.nodes().on(dof, cut), ExcMessage("nodes on a cut cannot be driven"));
    }
    for (SectorNodes::Dof dof = 0; dof < at_interface.size(); ++dof)
      AssertThrow(!at_interface[dof] || !sector.dependent().is_constrained(dof),
                  ExcMessage("an interface must not depend on other nodes"));
    for (const unsigned int part : {0u, 1u})
      choose_kept(part);
    factors = std::make_unique<SectorFactors>(
        sector,
        SectorFactors::PerField<std::vector<unsigned int>>{{fields[0].kept, fields[1].kept}},
        supports);
    factors->factorise(shift);
    for (const unsigned int part : {0u, 1u})
      fields[part].matrix = factors->matrix(part);
    if (!with_interior)
      factors.reset();
  }

  Condensation::~Condensation() = default;

  void Condensation::choose_kept(const unsigned int part)
  {
    const CyclicSector::RealField &real_field = sector.field(part);
    Field &field                              = fields[part];
    field.kept                                = real_field.cut;
    field.unknown.assign(field.kept.size(), none);
    std::vector<unsigned int> row(real_field.size, none), unknown(real_field.size, none);
    for (unsigned int i = 0; i < field.kept.size(); ++i)
      row[field.kept[i]] = i;
    for (const auto &[number, inner_unknown] : real_field.inner)
      unknown[number] = inner_unknown;
    field.row_of_dof.assign(sector.n_dofs(), none);
    for (SectorNodes::Dof dof = 0; dof < at_interface.size(); ++dof)
      if (const unsigned int number = real_field.number[dof]; at_interface[dof] && number != none)
      {
        if (row[number] == none)
        {
          row[number] = field.kept.size();
          field.kept.push_back(number);
          field.unknown.push_back(unknown[number]);
        }
        field.row_of_dof[dof] = row[number];
      }

    unsigned int size = real_field.size;
    for (unsigned int s = 0; s < supports.size(); ++s)
      if (supports[s].part == part)
      {
        field.unknown.push_back(sector.n_unknowns() + s);
        field.kept.push_back(size++);
      }
  }

  Condensation::Reduced Condensation::layout(const unsigned int k,
                                             const std::vector<unsigned int> &held) const
  {
    Reduced reduced;
    const unsigned int n_all = sector.n_unknowns() + supports.size();
    std::vector<bool> stays(n_all, false), is_held(n_all, false);
    for (const unsigned int support : held)
      is_held[sector.n_unknowns() + support] = true;
    for (const unsigned int part : {0u, 1u})
    {
      const Field &field = fields[part];
      auto &rows         = reduced.rows[part];
      rows.resize(field.kept.size());
      for (const CyclicSector::Tie &tie : sector.ties(part, k))
        rows[tie.position].push_back({tie.unknown, tie.factor});
      for (unsigned int row = 0; row < rows.size(); ++row)
        if (const unsigned int unknown = field.unknown[row];
            unknown != none && (unknown < sector.n_unknowns() || is_held[unknown]))
          rows[row].push_back({unknown, 1.});
      for (unsigned int row = 0; row < rows.size(); ++row)
        if (field.unknown[row] != none)
          for (const Reduced::Part &entry : rows[row])
            stays[entry.unknown] = true;
      for (const unsigned int row : field.row_of_dof)
        if (row != none)
          for (const Reduced::Part &entry : rows[row])
            stays[entry.unknown] = true;
    }
    reduced.place.assign(n_all, none);
    reduced.cut_place.assign(n_all, none);
    for (const unsigned int part : {0u, 1u})
      for (const auto &row : reduced.rows[part])
        for (const Reduced::Part &entry : row)
          if (stays[entry.unknown] && reduced.place[entry.unknown] == none)
            reduced.place[entry.unknown] = reduced.size++;
          else if (!stays[entry.unknown] && reduced.cut_place[entry.unknown] == none)
            reduced.cut_place[entry.unknown] = reduced.n_cut++;
    return reduced;
  }

  std::vector<double> Condensation::tied(const Reduced &reduced) const
  {
    const std::size_t n_all = reduced.n_cut + reduced.size;
    std::vector<double> matrix(n_all * n_all, 0.);
    struct Entry
    {
      std::size_t row, place;
      double factor;
    };
    for (const unsigned int part : {0u, 1u})
    {
      const std::size_t n_rows = reduced.rows[part].size();
      std::vector<Entry> entries;
      for (std::size_t row = 0; row < n_rows; ++row)
        for (const Reduced::Part &entry : reduced.rows[part][row])
        {
          const unsigned int stays = reduced.place[entry.unknown];
          entries.push_back(
              {row, stays != none ? reduced.n_cut + stays : reduced.cut_place[entry.unknown],
               entry.factor});
        }
      for (const Entry &column : entries)
      {
        const double *from = fields[part].matrix.data() + column.row * n_rows;
        double *to         = matrix.data() + column.place * n_all;
        for (const Entry &row : entries)
          to[row.place] += row.factor * column.factor * from[row.row];
      }
    }
    return matrix;
  }

  Condensation::Reduced Condensation::reduce(const unsigned int k,
                                             const std::vector<unsigned int> &held) const
  {
    Reduced reduced        = layout(k, held);
    const std::size_t size = reduced.size, n_cut = reduced.n_cut, n_all = n_cut + size;
    const std::vector<double> whole = tied(reduced);
    std::vector<double> cut(n_cut * n_cut), across(n_cut * size);
    for (std::size_t column = 0; column < n_cut; ++column)
      std::copy_n(whole.begin() + column * n_all, n_cut, cut.begin() + column * n_cut);
    reduced.matrix.resize(size * size);
    for (std::size_t column = 0; column < size; ++column)
    {
      const auto from = whole.begin() + (n_cut + column) * n_all;
      std::copy_n(from, n_cut, across.begin() + column * n_cut);
      std::copy_n(from + n_cut, size, reduced.matrix.begin() + column * size);
    }
    if (n_cut > 0)
    {
      std::vector<double> &solved = reduced.cut_response;
      solved                      = across;
      DenseLDLT factors;
      factors.factorise(n_cut, std::move(cut));
      factors.solve(solved);
      const int m = static_cast<int>(size), n = static_cast<int>(n_cut);
      const double minus = -1., plus = 1.;
      dgemm_("T", "N", &m, &m, &n, &minus, across.data(), &n, solved.data(), &n, &plus,
             reduced.matrix.data(), &m);
    }
    return reduced;
  }

  std::vector<unsigned int> Condensation::driven_places(const Reduced &reduced) const
  {
    std::vector<unsigned int> places;
    for (const SectorNodes::Dof dof : driven)
      for (const unsigned int part : {0u, 1u})
        for (const auto &entry : reduced.in_places(part, {{dof, 1.}}, fields[part]))
          places.push_back(entry.first);
    return places;
  }

  std::vector<double> Condensation::solutions(const Reduced &reduced,
                                              const std::vector<unsigned int> &held,
                                              const std::vector<CondensationLoad> &loads) const
  {
    const std::size_t size                 = reduced.size;
    const std::vector<unsigned int> places = driven_places(reduced);
    const auto forms                       = reduced.in_places(interface, fields);
    std::vector<double> solutions(loads.size() * size, 0.);
    for (std::size_t l = 0; l < loads.size(); ++l)
    {
      double *solution = solutions.data() + l * size;
      for (std::size_t i = 0; i < loads[l].forces.size(); ++i)
        for (const auto &[place, coefficient] : forms[i])
          solution[place] += coefficient * loads[l].forces[i];
      // The prescribed motion of each driven unknown becomes loads on the others.
      std::vector<double> given(size, 0.);
      for (const unsigned int part : {0u, 1u})
        for (std::size_t i = 0; i < loads[l].driven.size() / 2; ++i)
          for (const auto &entry : reduced.in_places(part, {{driven[i], 1.}}, fields[part]))
            given[entry.first] = loads[l].driven[part * driven.size() + i];
      for (const unsigned int column : places)
        for (std::size_t row = 0; row < size; ++row)
          solution[row] -= reduced.matrix[column * size + row] * given[column];
      for (const unsigned int place : places)
        solution[place] = given[place];
      for (unsigned int i = 0; i < loads[l].supports.size(); ++i)
        solution[reduced.place[sector.n_unknowns() + held[i]]] = loads[l].supports[i];
    }
    DenseLDLT factors;
    factors.factorise(size, reduced.with_held(places));
    factors.solve(solutions);
    return solutions;
  }

  std::vector<double> Condensation::prescribed_response(const unsigned int k,
                                                        const std::vector<double> &motion) const
  {
    const Reduced reduced = reduce(k, {});
    return interface_motion(reduced, solutions(reduced, {}, {{{}, motion, {}}}));
  }

  std::vector<double> Condensation::interface_motion(const Reduced &reduced,
                                                     const std::vector<double> &unknowns) const
  {
    std::vector<double> motion;
    for (const Reduced::Sum &sum : reduced.in_places(interface, fields))
    {
      motion.push_back(0.);
      for (const auto &[place, coefficient] : sum)
        motion.back() += coefficient * unknowns[place];
    }
    return motion;
  }

  SupportMotion Condensation::support_motion(const unsigned int k,
                                             const std::vector<unsigned int> &held,
                                             const unsigned int support) const
  {
    const Reduced reduced = reduce(k, held);
    CondensationLoad load;
    for (const unsigned int other : held)
      load.supports.push_back(other == support ? 1. : 0.);
    const std::vector<double> solution = solutions(reduced, held, {load});
    // The multiplier of the condition on the displacement is minus the load.
    return {interface_motion(reduced, solution),
            -solution[reduced.place[sector.n_unknowns() + support]]};
  }
} // namespace ringmotor
