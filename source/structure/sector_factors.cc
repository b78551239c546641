// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/dense_product.h>
#include <ringmotor/algebra/no_index.h>
#include <ringmotor/structure/sector_factors.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** If more than this fraction of the degrees of freedom is on the mirror plane, eliminating it
     * by dense matrices takes longer than another sparse factorisation. */
    constexpr double largest_mirror = 0.1;

    /** By degree of freedom, those that must not be eliminated in their cells. */
    std::vector<bool>
    outside_of_cells(const CyclicSector &sector,
                     const SectorFactors::PerField<std::vector<unsigned int>> &kept,
                     const std::vector<CondensationSupport> &supports)
    {
      std::vector<bool> stays(sector.n_dofs(), false);
      for (const unsigned int part : {0u, 1u})
      {
        const std::vector<unsigned int> &number = sector.field(part).number;
        std::vector<bool> is_kept(sector.field(part).size + supports.size(), false);
        for (const unsigned int i : kept[part])
          is_kept[i] = true;
        for (SectorNodes::Dof dof = 0; dof < number.size(); ++dof)
          if (number[dof] != none && is_kept[number[dof]])
            stays[dof] = true;
      }
      for (const CondensationSupport &support : supports)
        for (const auto &entry : support.load)
          stays[entry.first] = true;
      return stays;
    }

    /** Some entries of each of several vectors of @p width. */
    std::vector<double> at(const std::vector<unsigned int> &places, const double *begin,
                           const std::size_t n_vectors, const std::size_t width)
    {
      std::vector<double> entries;
      entries.reserve(n_vectors * places.size());
      for (std::size_t v = 0; v < n_vectors; ++v)
        for (const unsigned int place : places)
          entries.push_back(begin[v * width + place]);
      return entries;
    }

    void set_at(const std::vector<unsigned int> &places, const std::vector<double> &entries,
                double *begin, const std::size_t n_vectors, const std::size_t width)
    {
      std::size_t entry = 0;
      for (std::size_t v = 0; v < n_vectors; ++v)
        for (const unsigned int place : places)
          begin[v * width + place] = entries[entry++];
    }
  } // namespace

  SectorFactors::SectorFactors(const CyclicSector &sector,
                               const PerField<std::vector<unsigned int>> &kept,
                               const std::vector<CondensationSupport> &supports)
      : sector(sector), supports(supports),
        stiffness(sector, outside_of_cells(sector, kept, supports))
  {
    unsigned int n_on_mirror = 0;
    for (unsigned int dof = 0; dof < sector.n_dofs(); ++dof)
      n_on_mirror += is_on_mirror(dof);
    if (n_on_mirror <= largest_mirror * sector.n_dofs())
      sparse.push_back({{0, 1}, {}, {}, 0, nullptr});
    else
      for (const unsigned int part : {0u, 1u})
        sparse.push_back({{part}, {}, {}, 0, nullptr});
    for (Sparse &one : sparse)
    {
      number_rows(one);
      choose_kept_rows(one, kept);
      one.factors = std::make_unique<SparseLDLT>(one.n_rows, sector.communicator(), one.kept);
    }
  }

  bool SectorFactors::is_on_mirror(const unsigned int dof) const
  {
    return (sector.field(0).number[dof] == none) != (sector.field(1).number[dof] == none);
  }

  void SectorFactors::number_rows(Sparse &sparse)
  {
    sparse.row_of_dof.assign(sector.n_dofs(), none);
    for (unsigned int dof = 0; dof < sector.n_dofs(); ++dof)
      if (!stiffness.is_inner(dof) && std::any_of(sparse.parts.begin(), sparse.parts.end(),
                                                  [&](const unsigned int part) {
                                                    return sector.field(part).number[dof] != none;
                                                  }))
        sparse.row_of_dof[dof] = sparse.n_rows++;
    for (const unsigned int part : sparse.parts)
    {
      Field &field = fields[part];
      field.dof.resize(sector.field(part).size);
      field.row.resize(sector.field(part).size);
      for (unsigned int dof = 0; dof < sector.n_dofs(); ++dof)
        if (const unsigned int number = sector.field(part).number[dof]; number != none)
        {
          field.dof[number] = dof;
          field.row[number] = sparse.row_of_dof[dof];
        }
      for (const CondensationSupport &support : supports)
        if (support.part == part)
          field.row.push_back(sparse.n_rows++);
    }
  }

  void SectorFactors::choose_kept_rows(Sparse &sparse,
                                       const PerField<std::vector<unsigned int>> &kept)
  {
    std::vector<bool> stays(sparse.n_rows, false);
    for (const unsigned int part : sparse.parts)
      for (const unsigned int number : kept[part])
        stays[fields[part].row[number]] = true;
    if (sparse.parts.size() > 1) // each field eliminates its own part of the mirror plane
      for (unsigned int dof = 0; dof < sector.n_dofs(); ++dof)
        if (is_on_mirror(dof))
          stays[sparse.row_of_dof[dof]] = true;
    std::vector<unsigned int> place(sparse.n_rows, none);
    for (unsigned int row = 0; row < sparse.n_rows; ++row)
      if (stays[row])
      {
        place[row] = sparse.kept.size();
        sparse.kept.push_back(row);
      }
    for (const unsigned int part : sparse.parts)
    {
      Field &field = fields[part];
      std::vector<bool> is_kept(sparse.n_rows, false);
      for (const unsigned int number : kept[part])
      {
        is_kept[field.row[number]] = true;
        field.kept.push_back(place[field.row[number]]);
      }
      for (const unsigned int row : field.row)
        if (row != none && stays[row] && !is_kept[row])
          field.plane.push_back(place[row]);
    }
  }

  SymmetricElements SectorFactors::elements(const Sparse &sparse) const
  {
    SymmetricElements elements;
    std::size_t n_values = 0;
    for (const SectorStiffness::Element &element : stiffness.elements())
      n_values += element.lower.size();
    elements.values.reserve(n_values);
    for (const SectorStiffness::Element &element : stiffness.elements())
    {
      std::vector<unsigned int> rows, free;
      for (unsigned int i = 0; i < element.dofs.size(); ++i)
        if (const unsigned int row = sparse.row_of_dof[element.dofs[i]]; row != none)
        {
          rows.push_back(row);
          free.push_back(i);
        }
      if (free.size() == element.dofs.size())
        elements.add(rows, element.lower);
      else if (!free.empty())
      {
        std::vector<double> lower;
        for (auto column = free.begin(); column != free.end(); ++column)
          for (auto row = column; row != free.end(); ++row)
            lower.push_back(element(*row, *column));
        elements.add(rows, lower);
      }
    }
    if (Utilities::MPI::this_mpi_process(sector.communicator()) == 0)
      add_supports(sparse, elements);
    return elements;
  }

  void SectorFactors::add_supports(const Sparse &sparse, SymmetricElements &elements) const
  {
    for (const unsigned int part : sparse.parts)
    {
      unsigned int number = sector.field(part).size;
      for (const CondensationSupport &support : supports)
        if (support.part == part)
        {
          const unsigned int row = fields[part].row[number++];
          elements.add({row}, {0.});
          for (const auto &[dof, load] : support.load)
            if (sector.field(part).number[dof] != none)
              elements.add({sparse.row_of_dof[dof], row}, {0., load, 0.});
        }
    }
  }

  void SectorFactors::factorise(const double shift)
  {
    stiffness.compute(shift);
    for (Sparse &one : sparse)
      one.factors->factorise(elements(one));
    stiffness.forget_elements();
    for (const Sparse &one : sparse)
      for (const unsigned int part : one.parts)
        reduce(one, fields[part]);
  }

  void SectorFactors::reduce(const Sparse &sparse, Field &field)
  {
    const std::vector<double> &whole = sparse.factors->schur_complement();
    const std::size_t n_kept = field.kept.size(), n_plane = field.plane.size();
    const auto block =
        [&](const std::vector<unsigned int> &rows, const std::vector<unsigned int> &columns)
    {
      std::vector<double> entries;
      entries.reserve(rows.size() * columns.size());
      for (const std::size_t column : columns)
        for (const std::size_t row : rows)
          entries.push_back(
              whole[std::min(row, column) * sparse.kept.size() + std::max(row, column)]);
      return entries;
    };
    field.matrix = block(field.kept, field.kept);
    field.plane_factors.factorise(n_plane, block(field.plane, field.plane));
    const std::vector<double> across = block(field.plane, field.kept);
    field.plane_response             = across;
    field.plane_factors.solve(field.plane_response);
    add_product(-1., Transposed::yes, across, n_plane, field.plane_response, field.matrix);
    for (std::size_t column = 0; column < n_kept; ++column) // symmetric up to rounding
      for (std::size_t row = 0; row < column; ++row)
        field.matrix[column * n_kept + row] = field.matrix[row * n_kept + column];
  }

  unsigned int SectorFactors::n_negative() const
  {
    unsigned int count = 2 * stiffness.n_negative();
    for (const Sparse &one : sparse)
      count += one.parts.size() * one.factors->n_negative();
    for (const Field &field : fields)
      count += field.plane_factors.n_negative();
    return count;
  }

  std::vector<double> SectorFactors::loads_on_rows(const Sparse &sparse,
                                                   const PerField<std::vector<double>> &loads) const
  {
    const std::size_t n_vectors = loads[0].size() / fields[0].width(), n_dofs = sector.n_dofs();
    std::vector<double> on_rows(sparse.parts.size() * n_vectors * sparse.n_rows, 0.);
    double *next = on_rows.data();
    for (const unsigned int part : sparse.parts)
      for (std::size_t v = 0; v < n_vectors; ++v, next += sparse.n_rows)
      {
        const Field &field    = fields[part];
        const double *on_dofs = loads_on_dofs.data() + (part * n_vectors + v) * n_dofs;
        for (std::size_t dof = 0; dof < n_dofs; ++dof)
          if (sparse.row_of_dof[dof] != none)
            next[sparse.row_of_dof[dof]] = on_dofs[dof];
        for (std::size_t i = field.dof.size(); i < field.width(); ++i)
          next[field.row[i]] = loads[part][v * field.width() + i];
      }
    return on_rows;
  }

  SectorFactors::PerField<std::vector<double>>
  SectorFactors::condense(const PerField<std::vector<double>> &loads)
  {
    const std::size_t n_vectors = loads[0].size() / fields[0].width(), n_dofs = sector.n_dofs();
    loads_on_dofs.assign(2 * n_vectors * n_dofs, 0.);
    for (const unsigned int part : {0u, 1u})
      for (std::size_t v = 0; v < n_vectors; ++v)
        for (std::size_t i = 0; i < fields[part].dof.size(); ++i)
          loads_on_dofs[(part * n_vectors + v) * n_dofs + fields[part].dof[i]] =
              loads[part][v * fields[part].width() + i];
    stiffness.condense(loads_on_dofs);

    PerField<std::vector<double>> left;
    for (Sparse &one : sparse)
    {
      const std::vector<double> reduced = one.factors->condense(loads_on_rows(one, loads));
      const double *of_field            = reduced.data();
      for (const unsigned int part : one.parts)
      {
        Field &field      = fields[part];
        left[part]        = at(field.kept, of_field, n_vectors, one.kept.size());
        field.plane_loads = at(field.plane, of_field, n_vectors, one.kept.size());
        add_product(-1., Transposed::yes, field.plane_response, field.plane.size(),
                    field.plane_loads, left[part]);
        of_field += n_vectors * one.kept.size();
      }
    }
    return left;
  }

  SectorFactors::PerField<std::vector<double>>
  SectorFactors::expand(const PerField<std::vector<double>> &kept_solutions)
  {
    const std::size_t n_dofs = sector.n_dofs(), n_vectors = loads_on_dofs.size() / (2 * n_dofs);
    std::vector<double> motions(loads_on_dofs.size(), 0.);
    PerField<std::vector<double>> solutions;
    for (Sparse &one : sparse)
    {
      std::vector<double> kept(one.parts.size() * n_vectors * one.kept.size(), 0.);
      double *of_field = kept.data();
      for (const unsigned int part : one.parts)
      {
        Field &field              = fields[part];
        std::vector<double> plane = field.plane_loads;
        field.plane_factors.solve(plane);
        add_product(-1., Transposed::no, field.plane_response, field.kept.size(),
                    kept_solutions[part], plane);
        set_at(field.kept, kept_solutions[part], of_field, n_vectors, one.kept.size());
        set_at(field.plane, plane, of_field, n_vectors, one.kept.size());
        of_field += n_vectors * one.kept.size();
      }
      const std::vector<double> on_rows = one.factors->expand(std::move(kept));
      const double *next                = on_rows.data();
      for (const unsigned int part : one.parts)
      {
        const Field &field = fields[part];
        solutions[part].resize(n_vectors * field.width());
        for (std::size_t v = 0; v < n_vectors; ++v, next += one.n_rows)
        {
          double *on_dofs = motions.data() + (part * n_vectors + v) * n_dofs;
          for (std::size_t dof = 0; dof < n_dofs; ++dof)
            if (one.row_of_dof[dof] != none)
              on_dofs[dof] = next[one.row_of_dof[dof]];
          for (std::size_t i = field.dof.size(); i < field.width(); ++i)
            solutions[part][v * field.width() + i] = next[field.row[i]];
        }
      }
    }
    stiffness.expand(loads_on_dofs, motions);
    for (const unsigned int part : {0u, 1u})
      for (std::size_t v = 0; v < n_vectors; ++v)
        for (std::size_t i = 0; i < fields[part].dof.size(); ++i)
          solutions[part][v * fields[part].width() + i] =
              motions[(part * n_vectors + v) * n_dofs + fields[part].dof[i]];
    return solutions;
  }
} // namespace ringmotor
