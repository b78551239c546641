// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/contact_rows.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Unknowns up to which a dense matrix is faster than GMRES without a preconditioner. */
    constexpr unsigned int most_dense = 3000;
    /** Unknowns up to which its memory is spent where GMRES does not converge. */
    constexpr unsigned int largest_dense = 7000;

    /** The rows of a linear system, as an operator and as matrices of its parts. */
    class ContactRows
    {
    public:
      ContactRows(const ContactProblem &problem, const std::vector<unsigned int> &touching,
                  const std::vector<ContactRow> &rows)
          : problem(problem), touching(touching), rows(rows), row_scale(problem.n_rigid(), 1.),
            column_scale(problem.n_rigid(), 1.), change{
                                                     std::vector<PointVector>(problem.n_points()),
                                                     std::vector<double>(problem.n_rigid())}
      {
        if (problem.n_rigid() > 0)
          problem.balance_derivatives(touching, balance);
      }

      unsigned int size() const { return 3 * touching.size() + problem.n_rigid(); }

      /** Unknowns. Forces that are zero and stay zero are none. */
      std::vector<unsigned int> unknowns() const
      {
        std::vector<unsigned int> all;
        for (unsigned int a = 0; a < touching.size(); ++a)
          for (unsigned int c = 0; c < (rows[a].has_friction ? 3 : 1); ++c)
            all.push_back(3 * a + c);
        for (unsigned int r = 0; r < problem.n_rigid(); ++r)
          all.push_back(3 * touching.size() + r);
        return all;
      }

      /** The same by part, but for those of no part. */
      std::vector<std::vector<unsigned int>> parts() const
      {
        std::map<unsigned int, std::vector<unsigned int>> parts;
        for (unsigned int a = 0; a < touching.size(); ++a)
          for (unsigned int c = 0; c < (rows[a].has_friction ? 3 : 1); ++c)
            parts[problem.part_of_point(touching[a])].push_back(3 * a + c);
        for (unsigned int r = 0; r < problem.n_rigid(); ++r)
          if (problem.part_of_rigid(r) != ContactProblem::no_part)
            parts[problem.part_of_rigid(r)].push_back(3 * touching.size() + r);
        std::vector<std::vector<unsigned int>> lists;
        for (auto &part : parts)
          lists.push_back(std::move(part.second));
        return lists;
      }

      /** Makes the columns and the balances of rigid motions as long as those of a force. */
      void scale_rigid_motions()
      {
        const unsigned int n = 3 * touching.size();
        for (unsigned int r = 0; r < problem.n_rigid(); ++r)
        {
          Vector<double> unit(size()), column(size());
          unit[n + r] = 1.;
          vmult(column, unit);
          double of_column = 0., of_row = 0.;
          for (unsigned int i = 0; i < n; ++i)
          {
            of_column += column[i] * column[i];
            of_row += balance(r, i) * balance(r, i);
          }
          column_scale[r] = of_column > 0. ? 1. / std::sqrt(of_column) : 1.;
          row_scale[r]    = of_row > 0. ? 1. / std::sqrt(of_row) : 1.;
        }
      }
      void scale_right_hand_side(Vector<double> &vector) const
      {
        for (unsigned int r = 0; r < problem.n_rigid(); ++r)
          vector[3 * touching.size() + r] *= row_scale[r];
      }
      void unscale_solution(Vector<double> &vector) const
      {
        for (unsigned int r = 0; r < problem.n_rigid(); ++r)
          vector[3 * touching.size() + r] *= column_scale[r];
      }

      /** The rows of some unknowns, and the columns of some. */
      LAPACKFullMatrix<double> matrix_of(const std::vector<unsigned int> &row_unknowns,
                                         const std::vector<unsigned int> &column_unknowns) const;

      void vmult(Vector<double> &product, const Vector<double> &vector) const;

    private:
      /** Adds the blocks of the forces themselves, which belong to single nodes. */
      void add_forces(const std::vector<unsigned int> &row_unknowns,
                      const std::vector<unsigned int> &column_unknowns,
                      LAPACKFullMatrix<double> &matrix) const;

      const ContactProblem &problem;
      const std::vector<unsigned int> &touching;
      const std::vector<ContactRow> &rows;
      FullMatrix<double> balance;
      std::vector<double> row_scale, column_scale;
      mutable ContactState change; ///< zero where nothing touches
    };

    /** Points of the unknowns of a list, and the place of each unknown among their components,
     * rigid motions last. */
    struct Places
    {
      Places(const std::vector<unsigned int> &unknowns, const std::vector<unsigned int> &touching)
      {
        const unsigned int n = 3 * touching.size();
        for (unsigned int i = 0; i < unknowns.size() && unknowns[i] < n; ++i)
        {
          if (i == 0 || unknowns[i] / 3 != unknowns[i - 1] / 3)
            points.push_back(touching[unknowns[i] / 3]);
          of_unknown.push_back(3 * (points.size() - 1) + unknowns[i] % 3);
        }
        for (unsigned int i = of_unknown.size(); i < unknowns.size(); ++i)
          of_unknown.push_back(3 * points.size() + unknowns[i] - n);
      }
      std::vector<unsigned int> points, of_unknown;
    };

    LAPACKFullMatrix<double>
    ContactRows::matrix_of(const std::vector<unsigned int> &row_unknowns,
                           const std::vector<unsigned int> &column_unknowns) const
    {
      const unsigned int n = 3 * touching.size(), n_columns = column_unknowns.size();
      const Places row_places(row_unknowns, touching), column_places(column_unknowns, touching);
      FullMatrix<double> derivatives;
      problem.derivatives(row_places.points, column_places.points, derivatives);
      LAPACKFullMatrix<double> matrix(row_unknowns.size(), n_columns);
      for (unsigned int i = 0; i < row_unknowns.size(); ++i)
      {
        if (row_unknowns[i] >= n)
        {
          const unsigned int r = row_unknowns[i] - n;
          for (unsigned int j = 0; j < n_columns; ++j)
            matrix(i, j) = row_scale[r] * balance(r, column_unknowns[j]);
          continue;
        }
        const ContactRow &row = rows[row_unknowns[i] / 3];
        const unsigned int c = row_unknowns[i] % 3, first = row_places.of_unknown[i] - c;
        for (unsigned int d = 0; d < 3; ++d)
          if (row.by_motion[c][d] != 0.)
          {
            const double *derivative = &derivatives(first + d, 0);
            for (unsigned int j = 0; j < n_columns; ++j)
              matrix(i, j) += row.by_motion[c][d] * derivative[column_places.of_unknown[j]];
          }
      }
      add_forces(row_unknowns, column_unknowns, matrix);
      for (unsigned int j = 0; j < n_columns; ++j)
        if (column_unknowns[j] >= n)
          for (unsigned int i = 0; i < row_unknowns.size(); ++i)
            matrix(i, j) *= column_scale[column_unknowns[j] - n];
      return matrix;
    }

    void ContactRows::add_forces(const std::vector<unsigned int> &row_unknowns,
                                 const std::vector<unsigned int> &column_unknowns,
                                 LAPACKFullMatrix<double> &matrix) const
    {
      for (unsigned int i = 0; i < row_unknowns.size(); ++i)
        if (row_unknowns[i] < 3 * touching.size())
        {
          const unsigned int node = row_unknowns[i] / 3;
          for (auto column =
                   std::lower_bound(column_unknowns.begin(), column_unknowns.end(), 3 * node);
               column != column_unknowns.end() && *column < 3 * node + 3; ++column)
            matrix(i, column - column_unknowns.begin()) +=
                rows[node].by_force[row_unknowns[i] % 3][*column % 3];
        }
    }

    void ContactRows::vmult(Vector<double> &product, const Vector<double> &vector) const
    {
      const unsigned int n = touching.size(), n_rigid = problem.n_rigid();
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int c = 0; c < 3; ++c)
          change.force[touching[a]][c] = vector[3 * a + c];
      for (unsigned int r = 0; r < n_rigid; ++r)
        change.rigid[r] = column_scale[r] * vector[3 * n + r];
      const std::vector<PointVector> motion = problem.motion_by(change);
      for (unsigned int a = 0; a < n; ++a)
      {
        const PointVector result =
            rows[a].by_motion * motion[touching[a]] + rows[a].by_force * change.force[touching[a]];
        for (unsigned int c = 0; c < 3; ++c)
          product[3 * a + c] = result[c];
      }
      for (unsigned int r = 0; r < n_rigid; ++r)
      {
        double sum = 0.;
        for (unsigned int i = 0; i < 3 * n; ++i)
          sum += balance(r, i) * vector[i];
        for (unsigned int s = 0; s < n_rigid; ++s)
          sum += balance(r, 3 * n + s) * change.rigid[s];
        product[3 * n + r] = row_scale[r] * sum;
      }
    }

    bool factorise(LAPACKFullMatrix<double> &matrix)
    {
      try
      {
        matrix.compute_lu_factorization();
        return true;
      }
      catch (const LACExceptions::ExcSingular &)
      {
        return false;
      }
    }

    /**
     * Parts in a ring, D_p x_p + L_p x_(p-1) = b_p, by elimination: with y_p what the part before
     * adds to the rows of part p, x_p = D_p^-1 (b_p + y_p) and y_(p+1) = - L_(p+1) x_p. Once around
     * the ring, y_0 is a linear function of itself. Rows in which the part before has no share are
     * not in y. Unknowns of no part are the border of that matrix.
     */
    class RingOfParts
    {
    public:
      /** @param border unknowns of no part */
      RingOfParts(const ContactRows &rows, const std::vector<std::vector<unsigned int>> &parts,
                  const std::vector<unsigned int> &border)
          : rows(rows), parts(parts), border(border), steps(parts.size())
      {
      }

      bool solve(Vector<double> &solution)
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

    private:
      struct Step
      {
        LAPACKFullMatrix<double> own;   ///< factors of D_p, which copies would lose
        FullMatrix<double> by_before;   ///< - L_p, only rows that are not zero
        std::vector<unsigned int> rows; ///< these rows
      };

      bool make_step(const unsigned int p, Step &step) const
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

      FullMatrix<double> columns_of(const unsigned int p, const Vector<double> &given) const
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

      /** x_p by y_p and, if they are given, right-hand sides. */
      FullMatrix<double> solved(const unsigned int p, const FullMatrix<double> &shared,
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

      /** y_(p+1) */
      FullMatrix<double> next_shared(const unsigned int p, const FullMatrix<double> &unknowns) const
      {
        const Step &next = steps[(p + 1) % steps.size()];
        FullMatrix<double> shared(next.rows.size(), unknowns.n());
        if (!next.rows.empty())
          next.by_before.mmult(shared, unknowns);
        return shared;
      }

      /** Replaces y_0 as it comes back without an own share by what fits to itself. */
      bool close(FullMatrix<double> &shared) const
      {
        const unsigned int n = shared.m();
        if (n == 0)
          return true;
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

      bool solve_border(const std::vector<FullMatrix<double>> &unknowns,
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

      const ContactRows &rows;
      const std::vector<std::vector<unsigned int>> &parts;
      const std::vector<unsigned int> &border;
      std::vector<Step> steps;
    };

    bool solve_dense(const ContactRows &rows, const std::vector<unsigned int> &unknowns,
                     Vector<double> &solution)
    {
      LAPACKFullMatrix<double> matrix = rows.matrix_of(unknowns, unknowns);
      if (!factorise(matrix))
        return false;
      Vector<double> values(unknowns.size());
      for (unsigned int i = 0; i < unknowns.size(); ++i)
        values[i] = solution[unknowns[i]];
      matrix.solve(values);
      for (unsigned int i = 0; i < unknowns.size(); ++i)
        solution[unknowns[i]] = values[i];
      return true;
    }

    bool solve_by_gmres(ContactRows &rows, Vector<double> &solution)
    {
      // Restarts would make it stagnate.
      constexpr unsigned int most_steps = 250; // beyond, its orthogonalisation costs seconds
      constexpr double reduction        = 1e-9;
      rows.scale_rigid_motions();
      Vector<double> right_hand_side = solution;
      rows.scale_right_hand_side(right_hand_side);
      solution = 0.;
      if (right_hand_side.l2_norm() == 0.)
        return true;
      SolverControl control(most_steps, reduction * right_hand_side.l2_norm(), false, false);
      SolverGMRES<Vector<double>> gmres(
          control, SolverGMRES<Vector<double>>::AdditionalData(most_steps + 2, /*right =*/true));
      try
      {
        gmres.solve(rows, solution, right_hand_side, PreconditionIdentity());
      }
      catch (const SolverControl::NoConvergence &)
      {
        return false;
      }
      rows.unscale_solution(solution);
      return true;
    }

    double cubed(const double n)
    {
      return n * n * n;
    }
  } // namespace

  bool solve_contact_rows(const ContactProblem &problem, const std::vector<unsigned int> &touching,
                          const std::vector<ContactRow> &rows, Vector<double> &solution)
  {
    ContactRows system(problem, touching, rows);
    const std::vector<unsigned int> all                = system.unknowns();
    const std::vector<std::vector<unsigned int>> parts = system.parts();
    for (unsigned int a = 0; a < touching.size(); ++a)
      if (!rows[a].has_friction)
        solution[3 * a + 1] = solution[3 * a + 2] = 0.;
    if (all.empty()) // LAPACK does not take empty matrices
      return true;
    // Operations: an LU factorisation takes two thirds of the cube; a part of a ring of parts takes
    // some eight times its cube for its own factors and for what it hands on.
    double of_parts     = 0.;
    std::size_t largest = 0;
    std::vector<unsigned int> in_parts;
    for (const std::vector<unsigned int> &part : parts)
    {
      of_parts += 8. * cubed(part.size());
      largest = std::max(largest, part.size());
      in_parts.insert(in_parts.end(), part.begin(), part.end());
    }
    const bool is_ring = parts.size() > 1 && of_parts < 2. / 3. * cubed(all.size());
    if ((is_ring ? largest : all.size()) > most_dense)
    {
      const Vector<double> right_hand_side = solution;
      if (solve_by_gmres(system, solution))
        return true;
      if (all.size() > largest_dense)
        return false;
      solution = right_hand_side;
      return solve_dense(ContactRows(problem, touching, rows), all, solution);
    }
    if (!is_ring)
      return solve_dense(system, all, solution);
    std::sort(in_parts.begin(), in_parts.end());
    std::vector<unsigned int> border;
    std::set_difference(all.begin(), all.end(), in_parts.begin(), in_parts.end(),
                        std::back_inserter(border));
    return RingOfParts(system, parts, border).solve(solution);
  }
} // namespace ringmotor
