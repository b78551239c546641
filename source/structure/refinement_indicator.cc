// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/refinement_indicator.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /**
     * On the nodes of a line element of degree p: the matrix that takes nodal values to the nodal
     * values of the part of degree p alone, in the hierarchy of integrated Legendre polynomials
     * (orthogonal in the energy of a bar).
     */
    FullMatrix<double> top_degree_part(const unsigned int degree)
    {
      const QGaussLobatto<1> nodes(degree + 1);
      const QGauss<1> points(degree + 1);
      const auto shapes = Polynomials::generate_complete_Lagrange_basis(nodes.get_points());
      const Polynomials::Legendre slope(degree - 1); // orthonormal on [0, 1]
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

    /** Applies a matrix for nodal values on a line along one direction of a cell, to each
     * component. */
    void apply_along(const unsigned int direction, const FullMatrix<double> &line_matrix,
                     const FiniteElement<3> &fe, const std::vector<unsigned int> &lexicographic,
                     const Vector<double> &values, Vector<double> &result)
    {
      const unsigned int n_line = line_matrix.m();
      const unsigned int stride = direction == 0 ? 1 : direction == 1 ? n_line : n_line * n_line;
      result                    = 0.;
      for (unsigned int node = 0; node < lexicographic.size(); ++node)
      {
        const unsigned int along = node / stride % n_line;
        for (unsigned int other = 0; other < n_line; ++other)
        {
          const unsigned int source = node - along * stride + other * stride;
          for (unsigned int component = 0; component < 3; ++component)
            result[fe.component_to_system_index(component, lexicographic[node])] +=
                line_matrix(along, other) *
                values[fe.component_to_system_index(component, lexicographic[source])];
        }
      }
    }
  } // namespace

  std::vector<double> sheet_indicators(const CyclicSector &sector, const Sheets &sheets,
                                       const ComplexField &mode)
  {
    const FiniteElement<3> &fe    = sector.dofs().get_fe();
    const FullMatrix<double> part = top_degree_part(fe.degree);
    const std::vector<unsigned int> lexicographic =
        FETools::lexicographic_to_hierarchic_numbering<3>(fe.degree);

    Vector<double> values(fe.n_dofs_per_cell()), top(fe.n_dofs_per_cell());
    std::vector<double> indicators(sheets.n_sheets(), 0.);
    double energy = 0.;
    sector.for_each_owned_cell(
        [&](const auto &cell, const auto &stiffness, const auto &)
        {
          for (const Vector<double> *field : {&mode.real, &mode.imaginary})
          {
            cell->get_dof_values(*field, values);
            energy += stiffness.matrix_norm_square(values);
            for (unsigned int direction = 0; direction < 3; ++direction)
            {
              apply_along(direction, part, fe, lexicographic, values, top);
              indicators[sheets.sheet(cell, direction)] += stiffness.matrix_norm_square(top);
            }
          }
        });
    const MPI_Comm communicator = sector.dofs().get_communicator();
    energy                      = Utilities::MPI::sum(energy, communicator);
    Utilities::MPI::sum(indicators, communicator, indicators);
    for (double &indicator : indicators)
      indicator /= energy;
    return indicators;
  }
} // namespace ringmotor
