// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/lu_factors.h>
#include <ringmotor/contact/solve/ring_of_parts.h>

#include <algorithm>
#include <map>

namespace ringmotor
{
  using namespace dealii;

  RingOfParts::RingOfParts(const ContactRows &rows) : rows(rows)
  {
    std::map<unsigned int, std::vector<unsigned int>> by_part;
    for (const unsigned int unknown : rows.unknowns())
      (rows.part_of(unknown) == BlockStructure::no_part ? border : by_part[rows.part_of(unknown)])
          .push_back(unknown);
    for (auto &part : by_part)
      parts.push_back(std::move(part.second));
    steps.resize(parts.size());
  }

  unsigned int RingOfParts::largest_part() const
  {
    std::size_t largest = 0;
    for (const std::vector<unsigned int> &part : parts)
      largest = std::max(largest, part.size());
    return largest;
  }

  double RingOfParts::n_operations() const
  {
    double sum = 0.;
    for (const std::vector<unsigned int> &part : parts)
      sum += 8. * part.size() * part.size() * part.size();
    return sum;
  }

  bool RingOfParts::solve(Vector<double> &solution)
  {
    // Columns of right-hand sides: the given one, then minus those of the border.
    const unsigned int n_columns = 1 + border.size();
    std::vector<FullMatrix<double>> unknowns; // of each part, a column for each of them
    for (unsigned int p = 0; p < parts.size(); ++p)
    {
      if (!make_step(p, steps[p]))
        return false;
      unknowns.push_back(columns_of(p, solution));
    }
    FullMatrix<double> shared(steps[0].rows.size(), n_columns); // y_p, first with y_0 = 0
    for (unsigned int p = 0; p < parts.size(); ++p)
      shared = next_shared(p, solved(p, shared, &unknowns[p]));
    if (!close(shared))
      return false;
    for (unsigned int p = 0; p < parts.size(); ++p)
    {
      unknowns[p] = solved(p, shared, &unknowns[p]);
      shared      = next_shared(p, unknowns[p]);
    }
    return solve_border(unknowns, solution);
  }

  bool RingOfParts::make_step(const unsigned int p, Step &step) const
  {
    const unsigned int before = (p + parts.size() - 1) % parts.size();
    step.own                  = rows.matrix_of(parts[p], parts[p]);
    if (!factorise(step.own))
      return false;
    const LAPACKFullMatrix<double> coupling = rows.matrix_of(parts[p], parts[before]);
    for (unsigned int i = 0; i < coupling.m(); ++i)
      for (unsigned int j = 0; j < coupling.n(); ++j)
        if (coupling(i, j) != 0.)
        {
          step.rows.push_back(i);
          break;
        }
    step.by_before.reinit(step.rows.size(), coupling.n());
    for (unsigned int i = 0; i < step.rows.size(); ++i)
      for (unsigned int j = 0; j < coupling.n(); ++j)
        step.by_before(i, j) = -coupling(step.rows[i], j);
    return true;
  }

  FullMatrix<double> RingOfParts::columns_of(const unsigned int p,
                                             const Vector<double> &given) const
  {
    FullMatrix<double> columns(parts[p].size(), 1 + border.size());
    for (unsigned int i = 0; i < parts[p].size(); ++i)
      columns(i, 0) = given[parts[p][i]];
    if (!border.empty())
    {
      const LAPACKFullMatrix<double> by_border = rows.matrix_of(parts[p], border);
      for (unsigned int i = 0; i < by_border.m(); ++i)
        for (unsigned int j = 0; j < by_border.n(); ++j)
          columns(i, 1 + j) = -by_border(i, j);
    }
    return columns;
  }

  FullMatrix<double> RingOfParts::solved(const unsigned int p, const FullMatrix<double> &shared,
                                         const FullMatrix<double> *given) const
  {
    const unsigned int n = parts[p].size(), n_columns = given ? given->n() : shared.n();
    LAPACKFullMatrix<double> columns(n, n_columns);
    if (given)
      columns = *given;
    for (unsigned int i = 0; i < steps[p].rows.size(); ++i)
      for (unsigned int j = 0; j < n_columns; ++j)
        columns(steps[p].rows[i], j) += shared(i, j);
    steps[p].own.solve(columns);
    FullMatrix<double> result(n, n_columns);
    result = columns;
    return result;
  }

  FullMatrix<double> RingOfParts::next_shared(const unsigned int p,
                                              const FullMatrix<double> &unknowns) const
  {
    const Step &next = steps[(p + 1) % steps.size()];
    FullMatrix<double> shared(next.rows.size(), unknowns.n());
    if (!next.rows.empty())
      next.by_before.mmult(shared, unknowns);
    return shared;
  }

  bool RingOfParts::close(FullMatrix<double> &shared) const
  {
    // Where one part has no rows with contributions of the previous one, nothing goes around.
    if (std::any_of(steps.begin(), steps.end(), [](const Step &step) { return step.rows.empty(); }))
      return true;
    const unsigned int n = shared.m();
    FullMatrix<double> around(IdentityMatrix{n});
    for (unsigned int p = 0; p < parts.size(); ++p)
      around = next_shared(p, solved(p, around, nullptr));
    LAPACKFullMatrix<double> matrix(n), columns(n, shared.n());
    for (unsigned int i = 0; i < n; ++i)
    {
      for (unsigned int j = 0; j < n; ++j)
        matrix(i, j) = (i == j) - around(i, j);
      for (unsigned int j = 0; j < shared.n(); ++j)
        columns(i, j) = shared(i, j);
    }
    if (!factorise(matrix))
      return false;
    matrix.solve(columns);
    shared = columns;
    return true;
  }

  bool RingOfParts::solve_border(const std::vector<FullMatrix<double>> &unknowns,
                                 Vector<double> &solution) const
  {
    const unsigned int n = border.size();
    LAPACKFullMatrix<double> matrix(n);
    Vector<double> values(n);
    if (n > 0)
    {
      matrix = rows.matrix_of(border, border);
      for (unsigned int i = 0; i < n; ++i)
        values[i] = solution[border[i]];
      for (unsigned int p = 0; p < parts.size(); ++p)
      {
        const LAPACKFullMatrix<double> by_part = rows.matrix_of(border, parts[p]);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int k = 0; k < parts[p].size(); ++k)
          {
            values[i] -= by_part(i, k) * unknowns[p](k, 0);
            for (unsigned int j = 0; j < n; ++j)
              matrix(i, j) += by_part(i, k) * unknowns[p](k, 1 + j);
          }
      }
      if (!factorise(matrix))
        return false;
      matrix.solve(values);
    }
    for (unsigned int i = 0; i < n; ++i)
      solution[border[i]] = values[i];
    for (unsigned int p = 0; p < parts.size(); ++p)
      for (unsigned int k = 0; k < parts[p].size(); ++k)
      {
        double &entry = solution[parts[p][k]];
        entry         = unknowns[p](k, 0);
        for (unsigned int j = 0; j < n; ++j)
          entry += values[j] * unknowns[p](k, 1 + j);
      }
    return true;
  }
} // namespace ringmotor
