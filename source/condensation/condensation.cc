// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/dense_ldlt.h>
#include <ringmotor/algebra/no_index.h>
#include <ringmotor/condensation/condensation_tied.h>
#include <ringmotor/mesh/ids.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Each degree of freedom alone. */
    std::vector<LinearForm> single_forms(const std::vector<SectorNodes::Dof> &dofs)
    {
      std::vector<LinearForm> forms;
      for (const SectorNodes::Dof dof : dofs)
        forms.push_back({{dof, 1.}});
      return forms;
    }
  } // namespace

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

  Condensation::Tied Condensation::tie(const unsigned int k,
                                       const std::vector<unsigned int> &held) const
  {
    Tied tied;
    std::vector<unsigned int> places(sector.n_unknowns() + supports.size(), none);
    std::vector<bool> is_held(supports.size(), false);
    for (const unsigned int support : held)
      is_held[support] = true;
    const auto add =
        [&](std::vector<Tied::Part> &row, const unsigned int unknown, const double factor)
    {
      if (places[unknown] == none)
        places[unknown] = tied.size++;
      row.push_back({places[unknown], factor});
    };
    for (const unsigned int part : {0u, 1u})
    {
      const Field &field = fields[part];
      auto &rows         = tied.rows[part];
      rows.resize(field.kept.size());
      for (const CyclicSector::Tie &tie : sector.ties(part, k))
        add(rows[tie.position], tie.unknown, tie.factor);
      for (unsigned int row = 0; row < rows.size(); ++row)
        if (const unsigned int unknown = field.unknown[row];
            unknown != none &&
            (unknown < sector.n_unknowns() || is_held[unknown - sector.n_unknowns()]))
          add(rows[row], unknown, 1.);
    }
    tied.supports.assign(places.begin() + sector.n_unknowns(), places.end());
    return tied;
  }

  std::vector<double> Condensation::matrix(const Tied &tied) const
  {
    std::vector<double> matrix(static_cast<std::size_t>(tied.size) * tied.size, 0.);
    struct Entry
    {
      std::size_t row;
      Tied::Part part;
    };
    for (const unsigned int part : {0u, 1u})
    {
      const std::size_t n_rows = tied.rows[part].size();
      std::vector<Entry> entries;
      for (std::size_t row = 0; row < n_rows; ++row)
        for (const Tied::Part &entry : tied.rows[part][row])
          entries.push_back({row, entry});
      for (const Entry &column : entries)
      {
        const double *from = fields[part].matrix.data() + column.row * n_rows;
        double *to = matrix.data() + static_cast<std::size_t>(column.part.place) * tied.size;
        for (const Entry &row : entries)
          to[row.part.place] += row.part.factor * column.part.factor * from[row.row];
      }
    }
    return matrix;
  }

  std::vector<double> Condensation::solutions(const Tied &tied,
                                              const std::vector<unsigned int> &held,
                                              const std::vector<CondensationLoad> &loads) const
  {
    const std::size_t size        = tied.size;
    std::vector<double> stiffness = matrix(tied), solutions(loads.size() * size, 0.);
    const auto forms              = tied.in_places(interface, fields),
               driven_places      = tied.in_places(single_forms(driven), fields);
    for (std::size_t l = 0; l < loads.size(); ++l)
    {
      double *solution = solutions.data() + l * size;
      for (std::size_t i = 0; i < loads[l].forces.size(); ++i)
        for (const auto &[place, coefficient] : forms[i])
          solution[place] += coefficient * loads[l].forces[i];
      for (unsigned int i = 0; i < loads[l].supports.size(); ++i)
        solution[tied.supports[held[i]]] = loads[l].supports[i];
      // The prescribed motion of each driven unknown becomes loads on the others.
      for (std::size_t i = 0; i < loads[l].driven.size(); ++i)
        for (const auto &entry : driven_places[i])
          for (std::size_t row = 0; row < size; ++row)
            solution[row] -= stiffness[entry.first * size + row] * loads[l].driven[i];
    }
    for (std::size_t i = 0; i < driven_places.size(); ++i)
      for (const auto &entry : driven_places[i])
      {
        for (std::size_t j = 0; j < size; ++j)
          stiffness[entry.first * size + j] = stiffness[j * size + entry.first] = 0.;
        stiffness[entry.first * size + entry.first] = 1.;
        for (std::size_t l = 0; l < loads.size(); ++l)
          solutions[l * size + entry.first] = loads[l].driven.empty() ? 0. : loads[l].driven[i];
      }
    DenseLDLT factors;
    factors.factorise(size, std::move(stiffness));
    factors.solve(solutions);
    return solutions;
  }

  std::vector<double> Condensation::prescribed_response(const unsigned int k,
                                                        const std::vector<double> &motion) const
  {
    const Tied tied = tie(k, {});
    return interface_motion(tied, solutions(tied, {}, {{{}, motion, {}}}));
  }

  std::vector<double> Condensation::interface_motion(const Tied &tied,
                                                     const std::vector<double> &unknowns) const
  {
    std::vector<double> motion;
    for (const Tied::Sum &sum : tied.in_places(interface, fields))
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
    const Tied tied = tie(k, held);
    CondensationLoad load;
    for (const unsigned int other : held)
      load.supports.push_back(other == support ? 1. : 0.);
    const std::vector<double> solution = solutions(tied, held, {load});
    // The multiplier of the condition on the displacement is minus the load.
    return {interface_motion(tied, solution), -solution[tied.supports[support]]};
  }
} // namespace ringmotor
