// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/dense_product.h>
#include <ringmotor/structure/sector_factors.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int none = numbers::invalid_unsigned_int;

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
    number_rows();
    choose_kept_rows(kept);
    sparse = std::make_unique<SparseLDLT>(n_rows, sector.communicator(), sparse_kept);
  }

  void SectorFactors::number_rows()
  {
    row_of_dof.assign(sector.n_dofs(), none);
    for (unsigned int dof = 0; dof < sector.n_dofs(); ++dof)
      if (!stiffness.is_inner(dof) &&
          (sector.field(0).number[dof] != none || sector.field(1).number[dof] != none))
        row_of_dof[dof] = n_rows++;
    for (const unsigned int part : {0u, 1u})
    {
      Field &field = fields[part];
      field.dof.resize(sector.field(part).size);
      field.row.resize(sector.field(part).size);
      for (unsigned int dof = 0; dof < sector.n_dofs(); ++dof)
        if (const unsigned int number = sector.field(part).number[dof]; number != none)
        {
          field.dof[number] = dof;
          field.row[number] = row_of_dof[dof];
        }
    }
    for (const CondensationSupport &support : supports)
      fields[support.part].row.push_back(n_rows++);
  }

  void SectorFactors::choose_kept_rows(const PerField<std::vector<unsigned int>> &kept)
  {
    std::vector<bool> stays(n_rows, false);
    for (const unsigned int part : {0u, 1u})
      for (const unsigned int number : kept[part])
        stays[fields[part].row[number]] = true;
    // Of these a field has only some: it has to see which.
    for (unsigned int dof = 0; dof < sector.n_dofs(); ++dof)
      if (row_of_dof[dof] != none &&
          (sector.field(0).number[dof] == none) != (sector.field(1).number[dof] == none))
        stays[row_of_dof[dof]] = true;
    std::vector<unsigned int> place(n_rows, none);
    for (unsigned int row = 0; row < n_rows; ++row)
      if (stays[row])
      {
        place[row] = sparse_kept.size();
        sparse_kept.push_back(row);
      }
    for (const unsigned int part : {0u, 1u})
    {
      Field &field = fields[part];
      std::vector<bool> is_kept(n_rows, false);
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

  SymmetricElements SectorFactors::elements() const
  {
    SymmetricElements elements;
    std::size_t n_values = 0;
    for (const SectorStiffness::Element &element : stiffness.elements())
      n_values += element.lower.size();
    elements.values.reserve(n_values);
    for (const SectorStiffness::Element &element : stiffness.elements())
    {
      std::vector<unsigned int> rows;
      for (const SectorNodes::Dof dof : element.dofs)
        rows.push_back(row_of_dof[dof]);
      elements.add(rows, element.lower);
    }
    if (Utilities::MPI::this_mpi_process(sector.communicator()) > 0)
      return elements;
    std::array<unsigned int, 2> number{{sector.field(0).size, sector.field(1).size}};
    for (const CondensationSupport &support : supports)
    {
      const Field &field     = fields[support.part];
      const unsigned int row = field.row[number[support.part]++];
      elements.add({row}, {0.});
      for (const auto &[dof, load] : support.load)
        if (sector.field(support.part).number[dof] != none)
          elements.add({row_of_dof[dof], row}, {0., load, 0.});
    }
    return elements;
  }

  void SectorFactors::factorise(const double shift)
  {
    stiffness.compute(shift);
    sparse->factorise(elements());
    stiffness.forget_elements();
    for (Field &field : fields)
      reduce(field);
  }

  void SectorFactors::reduce(Field &field)
  {
    const std::vector<double> &whole = sparse->schur_complement();
    const std::size_t n_kept = field.kept.size(), n_plane = field.plane.size();
    const auto block =
        [&](const std::vector<unsigned int> &rows, const std::vector<unsigned int> &columns)
    {
      std::vector<double> entries;
      entries.reserve(rows.size() * columns.size());
      for (const std::size_t column : columns)
        for (const std::size_t row : rows)
          entries.push_back(
              whole[std::min(row, column) * sparse_kept.size() + std::max(row, column)]);
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
    return 2 * (stiffness.n_negative() + sparse->n_negative()) +
           fields[0].plane_factors.n_negative() + fields[1].plane_factors.n_negative();
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

    std::vector<double> on_rows(2 * n_vectors * n_rows, 0.);
    for (std::size_t v = 0; v < 2 * n_vectors; ++v)
      for (std::size_t dof = 0; dof < n_dofs; ++dof)
        if (row_of_dof[dof] != none)
          on_rows[v * n_rows + row_of_dof[dof]] = loads_on_dofs[v * n_dofs + dof];
    for (const unsigned int part : {0u, 1u})
      for (std::size_t v = 0; v < n_vectors; ++v)
        for (std::size_t i = fields[part].dof.size(); i < fields[part].width(); ++i)
          on_rows[(part * n_vectors + v) * n_rows + fields[part].row[i]] =
              loads[part][v * fields[part].width() + i];
    const std::vector<double> reduced = sparse->condense(on_rows);

    PerField<std::vector<double>> left;
    for (const unsigned int part : {0u, 1u})
    {
      Field &field           = fields[part];
      const double *of_field = reduced.data() + part * n_vectors * sparse_kept.size();
      left[part]             = at(field.kept, of_field, n_vectors, sparse_kept.size());
      field.plane_loads      = at(field.plane, of_field, n_vectors, sparse_kept.size());
      add_product(-1., Transposed::yes, field.plane_response, field.plane.size(), field.plane_loads,
                  left[part]);
    }
    return left;
  }

  SectorFactors::PerField<std::vector<double>>
  SectorFactors::expand(const PerField<std::vector<double>> &kept_solutions)
  {
    const std::size_t n_dofs = sector.n_dofs(), n_vectors = loads_on_dofs.size() / (2 * n_dofs);
    std::vector<double> kept(2 * n_vectors * sparse_kept.size(), 0.);
    for (const unsigned int part : {0u, 1u})
    {
      Field &field              = fields[part];
      std::vector<double> plane = field.plane_loads;
      field.plane_factors.solve(plane);
      add_product(-1., Transposed::no, field.plane_response, field.kept.size(),
                  kept_solutions[part], plane);
      double *of_field = kept.data() + part * n_vectors * sparse_kept.size();
      set_at(field.kept, kept_solutions[part], of_field, n_vectors, sparse_kept.size());
      set_at(field.plane, plane, of_field, n_vectors, sparse_kept.size());
    }
    const std::vector<double> on_rows = sparse->expand(std::move(kept));

    std::vector<double> motions(2 * n_vectors * n_dofs, 0.);
    for (std::size_t v = 0; v < 2 * n_vectors; ++v)
      for (std::size_t dof = 0; dof < n_dofs; ++dof)
        if (row_of_dof[dof] != none)
          motions[v * n_dofs + dof] = on_rows[v * n_rows + row_of_dof[dof]];
    stiffness.expand(loads_on_dofs, motions);

    PerField<std::vector<double>> solutions;
    for (const unsigned int part : {0u, 1u})
    {
      const Field &field = fields[part];
      solutions[part].resize(n_vectors * field.width());
      for (std::size_t v = 0; v < n_vectors; ++v)
      {
        double *solution = solutions[part].data() + v * field.width();
        for (std::size_t i = 0; i < field.dof.size(); ++i)
          solution[i] = motions[(part * n_vectors + v) * n_dofs + field.dof[i]];
        for (std::size_t i = field.dof.size(); i < field.width(); ++i)
          solution[i] = on_rows[(part * n_vectors + v) * n_rows + field.row[i]];
      }
    }
    return solutions;
  }
} // namespace ringmotor
