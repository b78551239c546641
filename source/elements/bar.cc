// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/elements/bar.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  BarElement::Edge::Edge(const Mapping<3> &mapping, const FiniteElement<3> &fe,
                         const unsigned int line)
  {
    const auto vertex = [line](const unsigned int end) {
      return GeometryInfo<3>::unit_cell_vertex(GeometryInfo<3>::line_to_cell_vertices(line, end));
    };
    const Point<3> start = vertex(0);
    direction            = vertex(1) - start;

    const FiniteElement<3> &scalar = fe.base_element(0);
    std::vector<unsigned int> nodes;
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    {
      const auto [component, node]    = fe.system_to_component_index(i);
      const Tensor<1, 3> from_start   = scalar.unit_support_point(node) - start;
      const Tensor<1, 3> off_the_line = from_start - (from_start * direction) * direction;
      if (off_the_line.norm() < 1e-10)
      {
        dofs.push_back(i);
        components.push_back(component);
        nodes.push_back(node);
      }
    }

    const QGauss<1> gauss(fe.degree + 1);
    std::vector<Point<3>> points;
    for (const Point<1> &point : gauss.get_points())
    {
      points.push_back(start + point[0] * direction);
      values.emplace_back();
      slopes.emplace_back();
      for (const unsigned int node : nodes)
      {
        values.back().push_back(scalar.shape_value(node, points.back()));
        slopes.back().push_back(scalar.shape_grad(node, points.back()) * direction);
      }
    }
    geometry = std::make_unique<FEValues<3>>(
        mapping, scalar, Quadrature<3>(points, gauss.get_weights()), update_jacobians);
  }

  BarElement::BarElement(const Mapping<3> &mapping, const FiniteElement<3> &fe)
  {
    for (unsigned int line = 0; line < GeometryInfo<3>::lines_per_cell; ++line)
      edges.emplace_back(mapping, fe, line);
  }

  void BarElement::reinit(const Triangulation<3>::active_cell_iterator &cell,
                          const unsigned int new_line, const BarSection &section)
  {
    AssertIndexRange(new_line, edges.size());
    line = new_line;
    edges[line].geometry->reinit(cell);
    build_rows(section);
  }

  void BarElement::build_rows(const BarSection &section)
  {
    const Edge &edge            = edges[line];
    const unsigned int n_points = edge.values.size();
    strains.rows.reinit(n_points, edge.dofs.size());
    motions.rows.reinit(3 * n_points, edge.dofs.size());
    strains.weights.clear();
    motions.weights.clear();
    edge_length = 0.;
    for (unsigned int q = 0; q < n_points; ++q)
    {
      const Tensor<1, 3> along   = apply_transformation(edge.geometry->jacobian(q), edge.direction);
      const double by_parameter  = along.norm();
      const Tensor<1, 3> tangent = along / by_parameter;
      for (unsigned int i = 0; i < edge.dofs.size(); ++i)
      {
        const unsigned int component       = edge.components[i];
        strains.rows(q, i)                 = edge.slopes[q][i] / by_parameter * tangent[component];
        motions.rows(3 * q + component, i) = edge.values[q][i];
      }
      const double length = by_parameter * edge.geometry->get_quadrature().weight(q);
      edge_length += length;
      strains.weights.push_back(section.axial_stiffness * length);
      motions.weights.insert(motions.weights.end(), 3, section.mass_per_length * length);
    }
  }

  void BarElement::matrices(FullMatrix<double> &stiffness, FullMatrix<double> &mass)
  {
    strains.fill(stiffness);
    motions.fill(mass);
  }

  std::vector<double> BarElement::stiffness_products(const std::vector<Vector<double>> &fields)
  {
    return strains.products(fields);
  }

  std::vector<double> BarElement::mass_products(const std::vector<Vector<double>> &fields)
  {
    return motions.products(fields);
  }
} // namespace ringmotor
