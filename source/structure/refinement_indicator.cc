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
     * On the nodes of a line element of degree p: the matrix that maps nodal values to the nodal
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
    template <int dim>
    std::vector<std::vector<unsigned int>> node_lines(const FiniteElement<dim, 3> &fe,
                                                      const unsigned int direction)
    {
      const unsigned int n_line = fe.degree + 1;
      const std::array<unsigned int, 3> stride{{1, n_line, n_line * n_line}};
      const std::vector<unsigned int> lexicographic =
          FETools::lexicographic_to_hierarchic_numbering<dim>(fe.degree);
      std::vector<std::vector<unsigned int>> lines;
      for (unsigned int node = 0; node < lexicographic.size(); ++node)
        if (node / stride[direction] % n_line == 0)
          for (unsigned int component = 0; component < fe.n_components(); ++component)
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
     * The sum, from the next degree on, of the series that starts with the energies of the parts of
     * second highest and highest degree.
     */
    double rest_of_series(const unsigned int degree, const double highest, const double second)
    {
      // At a re-entrant right angle displacements go as r^0.54 and the energies fall with the
      // degree p as p^-3.2. Where they seem to fall more slowly, the motion is odd or even in the
      // cell, and one of the two parts is small by symmetry. No series is assumed to fall faster
      // than this:
      constexpr double fastest = 0.05;
      const double slowest     = std::pow((degree - 1.) / degree, 3.2);
      const double decay       = std::clamp(highest / second, fastest, slowest);
      return std::max(highest, fastest * second) * decay / (1. - decay);
    }

    /**
     * Subtracts the rigid motion that best fits the displacements of a cell's nodes. It causes no
     * strain, but on a curved cell it is not a polynomial of first degree, and its parts would.
     */
    template <int dim>
    void remove_rigid_motion(const FiniteElement<dim, 3> &fe,
                             const std::vector<Point<3>> &positions, Vector<double> &values)
    {
      const unsigned int n_nodes = positions.size();
      const auto displacement    = [&](const unsigned int node)
      {
        Tensor<1, 3> u;
        for (unsigned int d = 0; d < 3; ++d)
          u[d] = values[fe.component_to_system_index(d, node)];
        return u;
      };
      Tensor<1, 3> center, shift;
      for (unsigned int node = 0; node < n_nodes; ++node)
      {
        center += positions[node] / n_nodes;
        shift += displacement(node) / n_nodes;
      }
      SymmetricTensor<2, 3> inertia;
      Tensor<1, 3> momentum;
      for (unsigned int node = 0; node < n_nodes; ++node)
      {
        const Tensor<1, 3> arm = positions[node] - center;
        inertia +=
            arm.norm_square() * unit_symmetric_tensor<3>() - symmetrize(outer_product(arm, arm));
        momentum += cross_product_3d(arm, displacement(node));
      }
      const Tensor<1, 3> turn = invert(inertia) * momentum;
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
      {
        const auto [component, node] = fe.system_to_component_index(i);
        values[i] -= component < 3 ? shift[component] +
                                         cross_product_3d(turn, positions[node] - center)[component]
                                   : turn[component - 3];
      }
    }

    using Sums = std::vector<std::vector<double>>; ///< by motion and sheet

    /** The contribution of solid or shell cells to the indicators. */
    template <int dim>
    class CellIndicator
    {
    public:
      CellIndicator(const FiniteElement<dim, 3> &fe, const Sheets &sheets,
                    ComplexField SectorMotion::*part)
          : fe(fe), sheets(sheets), part(part), positions(fe.base_element(0).n_dofs_per_cell()),
            members{
                {hierarchic_part(fe.degree, fe.degree), hierarchic_part(fe.degree, fe.degree - 1)}},
            all(fe.n_dofs_per_cell()), fields(2 * n_parts, all)
      {
        for (unsigned int direction = 0; direction < dim; ++direction)
          lines.push_back(node_lines(fe, direction));
      }

      template <typename Cell, typename Element>
      void add(const SectorElements &sector, const Cell &cell, Element &element,
               const std::vector<const SectorMotion *> &motions, Sums &sums)
      {
        const std::vector<SectorNodes::Dof> dofs = sector.dofs_of(cell);
        for (unsigned int node = 0; node < positions.size(); ++node)
          positions[node] = sector.nodes().position(
              sector.nodes().node(dofs[fe.component_to_system_index(0, node)]));
        for (unsigned int motion = 0; motion < motions.size(); ++motion)
        {
          for (unsigned int i = 0; i < 2; ++i)
          {
            const ComplexField &field = motions[motion]->*part;
            cell->get_dof_values(i == 0 ? field.real : field.imaginary, all);
            remove_rigid_motion(fe, positions, all);
            for (unsigned int direction = 0; direction < dim; ++direction)
              for (unsigned int member = 0; member < 2; ++member)
                apply_along(lines[direction], members[member], all,
                            fields[i * n_parts + 2 * direction + member]);
          }
          const std::vector<double> products = element.stiffness_products(fields);
          const auto energy                  = [&](const unsigned int i)
          { return products[i] + products[n_parts + i]; };
          for (unsigned int direction = 0; direction < dim; ++direction)
            sums[motion][sheets.sheet(*cell, direction)] +=
                rest_of_series(fe.degree, energy(2 * direction), energy(1 + 2 * direction));
        }
      }

    private:
      /** The parts of highest and of second highest degree in each direction. */
      static constexpr unsigned int n_parts = 2 * dim;

      const FiniteElement<dim, 3> &fe;
      const Sheets &sheets;
      ComplexField SectorMotion::*const part;
      std::vector<Point<3>> positions; ///< of the cell's nodes
      const std::array<FullMatrix<double>, 2> members;
      std::vector<std::vector<std::vector<unsigned int>>> lines; ///< by direction
      Vector<double> all;
      std::vector<Vector<double>> fields;
    };
  } // namespace

  std::vector<std::vector<double>>
  sheet_indicators(const SectorElements &sector, const Sheets &sheets,
                   const std::vector<const SectorMotion *> &motions)
  {
    Sums sums(motions.size(), std::vector<double>(sheets.n_sheets(), 0.));
    if (sector.dofs().has_active_dofs())
    {
      CellIndicator<3> solid(sector.dofs().get_fe(), sheets, &SectorMotion::solid);
      sector.for_each_owned_cell([&](const auto &cell, SolidElement &element)
                                 { solid.add(sector, cell, element, motions, sums); });
    }
    if (sector.shell_dofs().has_active_dofs())
    {
      CellIndicator<2> shell(sector.shell_dofs().get_fe(), sheets, &SectorMotion::shell);
      sector.for_each_owned_shell_cell([&](const auto &cell, ShellElement &element)
                                       { shell.add(sector, cell, element, motions, sums); });
    }

    for (std::vector<double> &of_motion : sums)
      Utilities::MPI::sum(of_motion, sector.communicator(), of_motion);
    return sums;
  }
} // namespace ringmotor
