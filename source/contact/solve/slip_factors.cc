// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/lu_factors.h>
#include <ringmotor/contact/solve/slip_factors.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  SlipFactors::Node SlipFactors::node_of(const ContactRow &row)
  {
    // Shares of the motion so small that they are left to the Krylov method.
    constexpr double hardly     = 0.02;
    const Tensor<2, 3> identity = unit_symmetric_tensor<3>();
    Node node{row.has_friction ? 3u : 1u, identity, identity, {0., 0.}};
    if (!row.has_friction)
      return node;
    // The combination w of the tangential rows with the least motion
    SymmetricTensor<2, 2> square;
    for (unsigned int c = 0; c < 2; ++c)
      for (unsigned int d = 0; d <= c; ++d)
        square[c][d] = row.by_motion[1 + c] * row.by_motion[1 + d];
    // The default method does not converge for some nearly diagonal tensors.
    const auto [largest, smallest] = eigenvectors(square, SymmetricTensorEigenvectorMethod::jacobi);
    const Tensor<1, 2> w           = smallest.second;
    if (std::abs(smallest.first) > hardly * hardly * largest.first)
      return node;
    // determines the force along v by v . dF_t + by_pressure dF_n.
    Tensor<1, 2> v;
    for (unsigned int c = 0; c < 2; ++c)
      for (unsigned int d = 0; d < 2; ++d)
        v[d] += w[c] * row.by_force[1 + c][1 + d];
    const double size        = v.norm(),
                 by_pressure = w[0] * row.by_force[1][0] + w[1] * row.by_force[2][0];
    if (size <= 0.1 * row.by_force.norm())
      return node;
    v /= size;
    node.n_kept   = 2;
    node.row[1]   = Tensor<1, 3>({0., -w[1], w[0]});
    node.row[2]   = Tensor<1, 3>({0., w[0], w[1]});
    node.force[0] = Tensor<1, 3>({1., 0., 0.});
    node.force[1] = Tensor<1, 3>({-by_pressure / size * v[0], -v[1], v[0] / size});
    node.force[2] = Tensor<1, 3>({-by_pressure / size * v[1], v[0], v[1] / size});
    for (unsigned int k = 0; k < 2; ++k)
    {
      Tensor<1, 3> left_out;
      for (unsigned int d = 0; d < 3; ++d)
        left_out[d] = node.force[d][2];
      node.coupling[k] = node.row[k] * (row.by_force * left_out);
    }
    return node;
  }

  double SlipFactors::cost_of(const ContactRows &rows)
  {
    constexpr double of_assembly = 4600.; // of a pair of nodes, measured: 0.1 us
    double n_kept                = rows.n_rigid();
    const double n_nodes         = rows.touching_points().size();
    for (unsigned int a = 0; a < n_nodes; ++a)
    {
      const ContactRow &row = rows.row_of(a);
      n_kept += !row.has_friction ? 1. : row.by_force.norm_square() > 0. ? 2. : 3.;
    }
    return 1. / 3. * std::pow(n_kept, 3) + of_assembly * n_nodes * n_nodes;
  }

  SlipFactors::SlipFactors(const ContactRows &rows) : made_for(rows), n_rigid(rows.n_rigid())
  {
    unsigned int n = 0;
    for (unsigned int a = 0; a < rows.touching_points().size(); ++a)
    {
      nodes.push_back(node_of(rows.row_of(a)));
      first.push_back(n);
      n += nodes.back().n_kept;
    }
    first.push_back(n);
    factors.reinit(n + n_rigid);
    assemble(rows);
    regular = factorise(factors);
  }

  void SlipFactors::assemble(const ContactRows &rows)
  {
    const unsigned int n_nodes = nodes.size(), n_columns = 3 * n_nodes + n_rigid;
    const std::vector<unsigned int> &touching = rows.touching_points();
    constexpr unsigned int together           = 8; // the rows of so many nodes stay in the cache
    FullMatrix<double> derivatives, lines;
    for (unsigned int begin = 0; begin < n_nodes; begin += together)
    {
      const unsigned int end = std::min(begin + together, n_nodes);
      rows.contact_problem().derivatives({touching.begin() + begin, touching.begin() + end},
                                         touching, derivatives);
      lines.reinit(first[end] - first[begin], n_columns);
      for (unsigned int a = begin; a < end; ++a)
        for (unsigned int k = 0; k < nodes[a].n_kept; ++k)
        {
          const Tensor<1, 3> by_motion = nodes[a].row[k] * rows.row_of(a).by_motion,
                             by_force  = nodes[a].row[k] * rows.row_of(a).by_force;
          double *const line           = &lines(first[a] - first[begin] + k, 0);
          for (unsigned int d = 0; d < 3; ++d)
            if (const double factor = by_motion[d]; factor != 0.)
            {
              const double *const derivative = &derivatives(3 * (a - begin) + d, 0);
              for (unsigned int j = 0; j < n_columns; ++j)
                line[j] += factor * derivative[j];
            }
          for (unsigned int d = 0; d < 3; ++d)
            line[3 * a + d] += by_force[d];
        }
      set_lines(first[begin], lines);
    }
    if (n_rigid == 0)
      return;
    lines.reinit(n_rigid, n_columns);
    for (unsigned int r = 0; r < n_rigid; ++r)
      for (unsigned int j = 0; j < n_columns; ++j)
        lines(r, j) = rows.balance_of(r, j);
    set_lines(first.back(), lines);
  }

  void SlipFactors::set_lines(const unsigned int first_line, const FullMatrix<double> &lines)
  {
    // Not transposed, although that would be faster to write: rows are in N, but unknowns in any
    // unit, and pivots are compared within a column.
    for (unsigned int b = 0; b < nodes.size(); ++b)
      for (unsigned int l = 0; l < nodes[b].n_kept; ++l)
      {
        const Tensor<1, 3> force(
            {nodes[b].force[0][l], nodes[b].force[1][l], nodes[b].force[2][l]});
        float *const column = &factors(first_line, first[b] + l); // contiguous
        for (unsigned int i = 0; i < lines.m(); ++i)
        {
          const double *const by_node = &lines(i, 3 * b);
          column[i] = by_node[0] * force[0] + by_node[1] * force[1] + by_node[2] * force[2];
        }
      }
    for (unsigned int r = 0; r < n_rigid; ++r)
      for (unsigned int i = 0; i < lines.m(); ++i)
        factors(first_line + i, first.back() + r) = lines(i, 3 * nodes.size() + r);
  }

  bool SlipFactors::fit(const ContactRows &rows) const
  {
    return made_for.are_of(rows);
  }

  Vector<double> SlipFactors::start(const Vector<double> &right_hand_side) const
  {
    Vector<double> forces(right_hand_side.size());
    for (unsigned int a = 0; a < nodes.size(); ++a)
      if (nodes[a].n_kept == 2)
        for (unsigned int c = 1; c < 3; ++c)
          for (unsigned int d = 1; d < 3; ++d)
            forces[3 * a + d] +=
                nodes[a].force[d][2] * nodes[a].row[2][c] * right_hand_side[3 * a + c];
    return forces;
  }

  void SlipFactors::vmult(Vector<double> &result, const Vector<double> &vector) const
  {
    const unsigned int n = 3 * nodes.size();
    result               = start(vector);
    Vector<float> kept(first.back() + n_rigid);
    for (unsigned int a = 0; a < nodes.size(); ++a)
    {
      const Node &node = nodes[a];
      const Tensor<1, 3> combined =
          node.row * Tensor<1, 3>({vector[3 * a], vector[3 * a + 1], vector[3 * a + 2]});
      for (unsigned int k = 0; k < node.n_kept; ++k)
        kept[first[a] + k] = combined[k] - (node.n_kept == 2 ? node.coupling[k] * combined[2] : 0.);
    }
    for (unsigned int r = 0; r < n_rigid; ++r)
      kept[first.back() + r] = vector[n + r];
    factors.solve(kept);
    for (unsigned int a = 0; a < nodes.size(); ++a)
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int k = 0; k < nodes[a].n_kept; ++k)
          result[3 * a + d] += nodes[a].force[d][k] * kept[first[a] + k];
    for (unsigned int r = 0; r < n_rigid; ++r)
      result[n + r] = kept[first.back() + r];
  }
} // namespace ringmotor
