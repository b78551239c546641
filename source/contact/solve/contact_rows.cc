// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/solve/contact_rows.h>

#include <algorithm>
#include <numeric>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
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
  } // namespace

  ContactRows::ContactRows(const ContactProblem &problem, const std::vector<unsigned int> &touching,
                           const std::vector<ContactRow> &rows)
      : problem(problem), touching(touching),
        rows(rows), change{std::vector<PointVector>(problem.n_points()),
                           std::vector<double>(problem.n_rigid())}
  {
    if (problem.n_rigid() > 0)
      problem.balance_derivatives(touching, balance);
    for (unsigned int a = 0; a < touching.size(); ++a)
      for (unsigned int c = 0; c < (rows[a].has_friction ? 3 : 1); ++c)
        all_unknowns.push_back(3 * a + c);
    for (unsigned int r = 0; r < problem.n_rigid(); ++r)
      all_unknowns.push_back(3 * touching.size() + r);
  }

  std::vector<unsigned int> ContactRows::rigid_unknowns() const
  {
    std::vector<unsigned int> rigid(n_rigid());
    std::iota(rigid.begin(), rigid.end(), n_of_nodes());
    return rigid;
  }

  unsigned int ContactRows::part_of(const unsigned int unknown) const
  {
    return unknown < n_of_nodes() ? problem.structure().part_of_point(touching[unknown / 3])
                                  : problem.structure().part_of_rigid(unknown - n_of_nodes());
  }

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
          matrix(i, j) = balance(r, column_unknowns[j]);
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
      change.rigid[r] = vector[3 * n + r];
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
      product[3 * n + r] = sum;
    }
  }
} // namespace ringmotor
