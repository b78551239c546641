// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/solve/proximal_problem.h>

#include <map>

namespace ringmotor
{
  using namespace dealii;

  ProximalProblem::ProximalProblem(const ContactProblem &problem, const ContactState &centre,
                                   const Springs &springs)
      : problem(problem), centre(centre), springs(springs)
  {
  }

  std::vector<PointVector> ProximalProblem::relative_motion(const ContactState &state) const
  {
    std::vector<PointVector> motion = problem.relative_motion(state);
    for (unsigned int i = 0; i < motion.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        motion[i][c] += spring(c) * (state.force[i][c] - centre.force[i][c]);
    return motion;
  }

  std::vector<PointVector> ProximalProblem::motion_by(const ContactState &change) const
  {
    std::vector<PointVector> motion = problem.motion_by(change);
    for (unsigned int i = 0; i < motion.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        motion[i][c] += spring(c) * change.force[i][c];
    return motion;
  }

  void ProximalProblem::derivatives(const std::vector<unsigned int> &rows,
                                    const std::vector<unsigned int> &columns,
                                    FullMatrix<double> &matrix) const
  {
    problem.derivatives(rows, columns, matrix);
    std::map<unsigned int, unsigned int> place; // among the columns
    for (unsigned int j = 0; j < columns.size(); ++j)
      place[columns[j]] = j;
    for (unsigned int i = 0; i < rows.size(); ++i)
      if (const auto found = place.find(rows[i]); found != place.end())
        for (unsigned int c = 0; c < 3; ++c)
          matrix(3 * i + c, 3 * found->second + c) += spring(c);
  }

  std::vector<double> ProximalProblem::balances(const ContactState &state) const
  {
    std::vector<double> balances = problem.balances(state);
    for (unsigned int r = 0; r < balances.size(); ++r)
      balances[r] -= springs.rigid_stiffness[r] * (state.rigid[r] - centre.rigid[r]);
    return balances;
  }

  void ProximalProblem::balance_derivatives(const std::vector<unsigned int> &points,
                                            FullMatrix<double> &matrix) const
  {
    problem.balance_derivatives(points, matrix);
    for (unsigned int r = 0; r < n_rigid(); ++r)
      matrix(r, 3 * points.size() + r) -= springs.rigid_stiffness[r];
  }
} // namespace ringmotor
