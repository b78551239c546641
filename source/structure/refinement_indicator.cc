// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/refinement_indicator.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /**
     * On the nodes of a line element of degree p: the matrix that takes nodal values to the nodal
     * values of one member, of degree @p member, of the hierarchy of integrated Legendre
     * polynomials (orthogonal in the energy of a bar).
     */
    FullMatrix<double> hierarchic_part(const unsigned int degree, const unsigned int member)
    {
      const QGaussLobatto<1> nodes(degree + 1);
      const QGauss<1> points(degree + 1);
      const auto shapes = Polynomials::generate_complete_Lagrange_basis(nodes.get_points());
      const Polynomials::Legendre slope(member - 1); // orthonormal on [0, 1]
      const Polynomials::Polynomial<double> bubble = slope.primitive();

      FullMatrix<double> part(degree + 1, degree + 1);
      for (unsigned int j = 0; j <= degree; ++j)
      {
        const Polynomials::Polynomial<double> derivative = shapes[j].derivative();
        double coefficient                               = 0.;
        for (unsigned int q = 0; q < points.size(); ++q)
          coefficient += points.weight(q) * derivative.value(points.point(q)[0]) *
                         slope.value(points.point(q)[0]);
        for (unsigned int i = 0; i <= degree; ++i)
          part(i, j) = (bubble.value(nodes.point(i)[0]) - bubble.value(0.)) * coefficient;
      }
      return part;
    }

    /**
     * The lines of nodes of a cell along one direction: for each line, the local degrees of freedom
     * of one component on it, in order.
     */
    std::vector<std::vector<unsigned int>> node_lines(const FiniteElement<3> &fe,
                                                      const unsigned int direction)
    {
      const unsigned int n_line = fe.degree + 1;
      const std::array<unsigned int, 3> stride{{1, n_line, n_line * n_line}};
      const std::vector<unsigned int> lexicographic =
          FETools::lexicographic_to_hierarchic_numbering<3>(fe.degree);
      std::vector<std::vector<unsigned int>> lines;
      for (unsigned int node = 0; node < lexicographic.size(); ++node)
        if (node / stride[direction] % n_line == 0)
          for (unsigned int component = 0; component < 3; ++component)
          {
            std::vector<unsigned int> line;
            for (unsigned int i = 0; i < n_line; ++i)
              line.push_back(fe.component_to_system_index(
                  component, lexicographic[node + i * stride[direction]]));
            lines.push_back(line);
          }
      return lines;
    }

    /** Applies a matrix for nodal values on a line to all lines of a cell. */
    void apply_along(const std::vector<std::vector<unsigned int>> &lines,
                     const FullMatrix<double> &line_matrix, const Vector<double> &values,
                     Vector<double> &result)
    {
      for (const std::vector<unsigned int> &line : lines)
        for (unsigned int i = 0; i < line.size(); ++i)
        {
          double sum = 0.;
          for (unsigned int j = 0; j < line.size(); ++j)
            sum += line_matrix(i, j) * values[line[j]];
          result[line[i]] = sum;
        }
    }

    /**
     * The sum of the series that the energies of the parts of highest and second highest degree
     * begin, from the next degree on.
     */
    double rest_of_series(const unsigned int degree, const double highest, const double second)
    {
      // At a re-entrant right angle displacements go as r^0.54 and the energies fall with the
      // degree p as p^-3.2. Where they seem to fall more slowly, the motion is odd or even in the
      // cell, and one of the two parts small by symmetry. No series is trusted to fall faster than
      // this:
      constexpr double fastest = 0.05;
      const double slowest     = std::pow((degree - 1.) / degree, 3.2);
      const double decay       = std::clamp(highest / second, fastest, slowest);
      // Degree 1 contains rigid rotations: it says nothing of the size of degree 2.
      const double top = degree > 2 ? std::max(highest, fastest * second) : highest;
      return top * decay / (1. - decay);
    }
  } // namespace

  std::vector<std::vector<double>> sheet_indicators(const CyclicSector &sector,
                                                    const Sheets &sheets,
                                                    const std::vector<const ComplexField *> &modes)
  {
    const FiniteElement<3> &fe = sector.dofs().get_fe();
    const std::array<FullMatrix<double>, 2> parts{
        {hierarchic_part(fe.degree, fe.degree), hierarchic_part(fe.degree, fe.degree - 1)}};
    const std::array<std::vector<std::vector<unsigned int>>, 3> lines{
        {node_lines(fe, 0), node_lines(fe, 1), node_lines(fe, 2)}};

    std::vector<std::vector<double>> indicators(modes.size(),
                                                std::vector<double>(sheets.n_sheets(), 0.));
    std::vector<double> total(modes.size(), 0.);
    // By part: all, then those of highest and of second highest degree in each direction
    constexpr unsigned int n_parts = 7;
    std::vector<Vector<double>> fields(2 * n_parts, Vector<double>(fe.n_dofs_per_cell()));
    sector.for_each_owned_cell(
        [&](const auto &cell, SolidElement &element)
        {
          for (unsigned int mode = 0; mode < modes.size(); ++mode)
          {
            for (unsigned int i = 0; i < 2; ++i)
            {
              Vector<double> &all = fields[i * n_parts];
              cell->get_dof_values(i == 0 ? modes[mode]->real : modes[mode]->imaginary, all);
              for (unsigned int direction = 0; direction < 3; ++direction)
                for (unsigned int part = 0; part < 2; ++part)
                  apply_along(lines[direction], parts[part], all,
                              fields[i * n_parts + 1 + 2 * direction + part]);
            }
            const std::vector<double> products = element.stiffness_products(fields);
            const auto energy                  = [&](const unsigned int part)
            { return products[part] + products[n_parts + part]; };
            total[mode] += energy(0);
            for (unsigned int direction = 0; direction < 3; ++direction)
              indicators[mode][sheets.sheet(cell, direction)] +=
                  rest_of_series(fe.degree, energy(1 + 2 * direction), energy(2 + 2 * direction));
          }
        });

    const MPI_Comm communicator = sector.dofs().get_communicator();
    Utilities::MPI::sum(total, communicator, total);
    for (unsigned int mode = 0; mode < modes.size(); ++mode)
    {
      Utilities::MPI::sum(indicators[mode], communicator, indicators[mode]);
      for (double &indicator : indicators[mode])
        indicator /= total[mode];
    }
    return indicators;
  }
} // namespace ringmotor
