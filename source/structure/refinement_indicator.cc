// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/refinement_indicator.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>

#include <algorithm>
#include <array>

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

    /** Strain energies of one mode: in all, and of its parts of highest and second highest degree
     * by sheet. */
    struct PartEnergies
    {
      double total = 0.;
      std::array<std::vector<double>, 2> parts;
    };

    /** The series that the energies of successive degrees begin, from the next degree on, by sheet.
     */
    std::vector<double> sum_of_series(const PartEnergies &energies)
    {
      std::vector<double> indicators;
      for (unsigned int sheet = 0; sheet < energies.parts[0].size(); ++sheet)
      {
        const double highest = energies.parts[0][sheet], second = energies.parts[1][sheet];
        const double decay = highest < 0.9 * second ? highest / second : 0.9;
        indicators.push_back(highest / energies.total * decay / (1. - decay));
      }
      return indicators;
    }
  } // namespace

  std::vector<std::vector<double>> sheet_indicators(const CyclicSector &sector,
                                                    const Sheets &sheets,
                                                    const std::vector<const ComplexField *> &modes)
  {
    const FiniteElement<3> &fe = sector.dofs().get_fe();
    const std::array<FullMatrix<double>, 2> parts{
        {hierarchic_part(fe.degree, fe.degree),
         hierarchic_part(fe.degree, std::max(1u, fe.degree - 1))}};
    const std::array<std::vector<std::vector<unsigned int>>, 3> lines{
        {node_lines(fe, 0), node_lines(fe, 1), node_lines(fe, 2)}};

    std::vector<PartEnergies> energies(modes.size());
    for (PartEnergies &of_mode : energies)
      of_mode.parts.fill(std::vector<double>(sheets.n_sheets(), 0.));
    Vector<double> values(fe.n_dofs_per_cell()), part_values(fe.n_dofs_per_cell());
    sector.for_each_owned_cell(
        [&](const auto &cell, const auto &stiffness, const auto &)
        {
          for (unsigned int mode = 0; mode < modes.size(); ++mode)
            for (const Vector<double> *field : {&modes[mode]->real, &modes[mode]->imaginary})
            {
              cell->get_dof_values(*field, values);
              energies[mode].total += stiffness.matrix_norm_square(values);
              for (unsigned int direction = 0; direction < 3; ++direction)
                for (unsigned int part = 0; part < 2; ++part)
                {
                  apply_along(lines[direction], parts[part], values, part_values);
                  energies[mode].parts[part][sheets.sheet(cell, direction)] +=
                      stiffness.matrix_norm_square(part_values);
                }
            }
        });

    const MPI_Comm communicator = sector.dofs().get_communicator();
    std::vector<std::vector<double>> indicators;
    for (PartEnergies &of_mode : energies)
    {
      of_mode.total = Utilities::MPI::sum(of_mode.total, communicator);
      for (std::vector<double> &part : of_mode.parts)
        Utilities::MPI::sum(part, communicator, part);
      indicators.push_back(sum_of_series(of_mode));
    }
    return indicators;
  }
} // namespace ringmotor
