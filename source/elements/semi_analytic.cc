// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/elements/semi_analytic.h>
#include <ringmotor/elements/shell.h>
#include <ringmotor/elements/solid.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The gradient by a unit of an unknown: a constant, and what is added for each wave. In the
     * rows of r and z the latter has the other sign than in that of theta, whose i it cancels. */
    std::array<Tensor<2, 3>, 2> slope_of(const WaveStrains::UnitMotion &motion, const double radius)
    {
      Tensor<2, 3> constant, per_wave;
      for (unsigned int c = 0; c < 3; ++c)
      {
        constant[c][0] = motion.by_r[c];
        constant[c][2] = motion.by_z[c];
        per_wave[c][1] = (c == 1 ? 1. : -1.) * motion.value[c] / radius;
      }
      // The unit vectors of r and theta turn with theta.
      constant[0][1] = -motion.value[1] / radius;
      constant[1][1] = motion.value[0] / radius;
      return {{constant, per_wave}};
    }
  } // namespace

  void WaveStrains::clear(const unsigned int n)
  {
    n_unknowns = n;
    strains    = {};
    motions    = {};
  }

  void WaveStrains::at(const double radius, const std::vector<UnitMotion> &new_motions)
  {
    unit_motions = &new_motions;
    slopes.clear();
    for (const UnitMotion &motion : new_motions)
      slopes.push_back(slope_of(motion, radius));
  }

  void WaveStrains::add(const double weight,
                        const std::function<double(const Tensor<2, 3> &)> &strain,
                        const std::vector<double> &beside)
  {
    strains.weights.push_back(weight);
    for (unsigned int i = 0; i < n_unknowns; ++i)
    {
      strains.constant.push_back(strain(slopes[i][0]) + (beside.empty() ? 0. : beside[i]));
      strains.linear.push_back(strain(slopes[i][1]));
    }
  }

  void WaveStrains::add_mass(const double mass)
  {
    for (unsigned int c = 0; c < 3; ++c)
    {
      motions.weights.push_back(mass);
      for (const UnitMotion &motion : *unit_motions)
        motions.constant.push_back(motion.value[c]);
    }
  }

  FullMatrix<double> WaveStrains::product(const Rows &rows, const std::vector<double> &left,
                                          const std::vector<double> &right) const
  {
    const unsigned int n_rows = rows.weights.size();
    FullMatrix<double> weighted(n_rows, n_unknowns, left.data()),
        plain(n_rows, n_unknowns, right.data()), result(n_unknowns, n_unknowns);
    for (unsigned int row = 0; row < n_rows; ++row)
      for (unsigned int i = 0; i < n_unknowns; ++i)
        weighted(row, i) *= rows.weights[row];
    weighted.Tmmult(result, plain);
    return result;
  }

  WaveMatrices WaveStrains::matrices() const
  {
    WaveMatrices matrices{product(strains, strains.constant, strains.constant),
                          product(strains, strains.constant, strains.linear),
                          product(strains, strains.linear, strains.linear),
                          product(motions, motions.constant, motions.constant)};
    matrices.linear.symmetrize();
    matrices.linear *= 2.;
    return matrices;
  }

  SemiAnalyticSolid::SemiAnalyticSolid(const Mapping<3> &mapping, const FiniteElement<3> &fe)
      : fe(fe),
        values(mapping, fe.base_element(0), QGauss<2>(fe.degree + 1),
               update_values | update_gradients | update_quadrature_points | update_JxW_values)
  {
  }

  std::vector<unsigned int> SemiAnalyticSolid::local_dofs(const unsigned int face) const
  {
    std::vector<unsigned int> dofs;
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
      if (fe.has_support_on_face(i, face))
        dofs.push_back(i);
    return dofs;
  }

  WaveMatrices SemiAnalyticSolid::matrices(const Triangulation<3>::active_cell_iterator &cell,
                                           const unsigned int face, const Material &material)
  {
    const std::vector<unsigned int> dofs = local_dofs(face);
    const Elasticity elasticity(material);
    values.reinit(cell, face);
    strains.clear(dofs.size());
    std::vector<WaveStrains::UnitMotion> motions(dofs.size());
    for (const unsigned int q : values.quadrature_point_indices())
    {
      for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        const auto [component, node] = fe.system_to_component_index(dofs[i]);
        motions[i].value[component]  = values.shape_value(node, q);
        motions[i].by_r[component]   = values.shape_grad(node, q)[0];
        motions[i].by_z[component]   = values.shape_grad(node, q)[2];
      }
      const double radius = values.quadrature_point(q)[0], volume = values.JxW(q) * radius;
      strains.at(radius, motions);
      strains.add(volume * elasticity.lambda,
                  [](const Tensor<2, 3> &slope) { return trace(slope); });
      for (unsigned int c = 0; c < 3; ++c)
      {
        const unsigned int d = (c + 1) % 3;
        strains.add(2. * volume * elasticity.mu,
                    [c](const Tensor<2, 3> &slope) { return slope[c][c]; });
        strains.add(volume * elasticity.mu,
                    [c, d](const Tensor<2, 3> &slope) { return slope[c][d] + slope[d][c]; });
      }
      strains.add_mass(volume * material.density);
    }
    return strains.matrices();
  }

  SemiAnalyticShell::Edge::Edge(const Mapping<2, 3> &mapping, const FiniteElement<2, 3> &fe,
                                const unsigned int edge)
  {
    const FiniteElement<2, 3> &scalar = fe.base_element(0);
    const auto vertex                 = [edge](const unsigned int end) {
      return GeometryInfo<2>::unit_cell_vertex(GeometryInfo<2>::line_to_cell_vertices(edge, end));
    };
    const Point<2> start           = vertex(0);
    const Tensor<1, 2> direction   = vertex(1) - start;
    std::vector<Point<2>> supports = scalar.get_unit_support_points();
    std::vector<Point<2>> of_nodes;
    for (unsigned int node = 0; node < scalar.n_dofs_per_cell(); ++node)
      if (scalar.has_support_on_face(node, edge))
      {
        nodes.push_back(node);
        of_nodes.push_back(supports[node]);
        for (unsigned int component = 0; component < fe.n_components(); ++component)
          dofs.push_back(fe.component_to_system_index(component, node));
      }
    const QGauss<1> gauss(fe.degree + 1);
    weights = gauss.get_weights();
    for (const Point<1> &point : gauss.get_points())
    {
      const Point<2> place = start + point[0] * direction;
      values.emplace_back();
      slopes.emplace_back();
      for (const unsigned int node : nodes)
      {
        values.back().push_back(scalar.shape_value(node, place));
        slopes.back().push_back(scalar.shape_grad(node, place) * direction);
      }
    }
    at_nodes = std::make_unique<FEValues<2, 3>>(mapping, scalar, Quadrature<2>(of_nodes),
                                                update_quadrature_points | update_normal_vectors);
  }

  SemiAnalyticShell::SemiAnalyticShell(const Mapping<2, 3> &mapping, const FiniteElement<2, 3> &fe)
      : fe(fe)
  {
    Assert(fe.degree > 1, ExcMessage("Degree 1 has shear strains of its own."));
    for (unsigned int edge = 0; edge < GeometryInfo<2>::faces_per_cell; ++edge)
      edges.emplace_back(mapping, fe, edge);
  }

  SemiAnalyticShell::Place SemiAnalyticShell::place_at(const Edge &edge, const unsigned int q,
                                                       const double height) const
  {
    Tensor<1, 3> x, by_line, by_height;
    for (unsigned int node = 0; node < edge.nodes.size(); ++node)
    {
      const Tensor<1, 3> of_node = position[node] + height * director[node];
      x += edge.values[q][node] * of_node;
      by_line += edge.slopes[q][node] * of_node;
      by_height += edge.values[q][node] * director[node];
    }
    Place place;
    place.radius       = x[0];
    place.jacobian     = by_line[0] * by_height[2] - by_line[2] * by_height[0];
    place.along        = by_line / by_line.norm();
    place.normal[0]    = -place.along[2];
    place.normal[2]    = place.along[0];
    place.of_line[0]   = by_height[2] / place.jacobian;
    place.of_line[2]   = -by_height[0] / place.jacobian;
    place.of_height[0] = -by_line[2] / place.jacobian;
    place.of_height[2] = by_line[0] / place.jacobian;
    return place;
  }

  std::vector<WaveStrains::UnitMotion> SemiAnalyticShell::motions_at(const Edge &edge,
                                                                     const unsigned int q,
                                                                     const double height,
                                                                     const Place &place) const
  {
    std::vector<WaveStrains::UnitMotion> motions;
    for (unsigned int i = 0; i < edge.dofs.size(); ++i)
    {
      const unsigned int component = i % fe.n_components(), node = i / fe.n_components();
      const double value = edge.values[q][node];
      Tensor<1, 3> unit;
      unit[component % 3]      = 1.;
      const bool turns         = component >= 3;
      const Tensor<1, 3> moves = turns ? height * cross_product_3d(unit, director[node]) : unit,
                         by_height =
                             turns ? cross_product_3d(unit, director[node]) : Tensor<1, 3>();
      const Tensor<1, 3> gradient = edge.slopes[q][node] * place.of_line;
      motions.push_back({value * moves,
                         gradient[0] * moves + value * place.of_height[0] * by_height,
                         gradient[2] * moves + value * place.of_height[2] * by_height});
    }
    return motions;
  }

  void SemiAnalyticShell::add_layers(const Edge &edge, const unsigned int q,
                                     const Material &material, const ShellSection &section)
  {
    const double nu    = material.poisson_ratio;
    const double shear = material.young_modulus / (2. * (1. + nu));
    const double plane = material.young_modulus / (1. - nu * nu);
    const QGauss<1> layers(ShellElement::n_layers);
    for (unsigned int layer = 0; layer < layers.size(); ++layer)
    {
      const double height = section.offset + section.thickness * (layers.point(layer)[0] - 0.5);
      const Place place   = place_at(edge, q, height);
      const double volume = std::abs(place.jacobian) * place.radius * edge.weights[q] *
                            section.thickness * layers.weight(layer);
      motions = motions_at(edge, q, height, place);
      strains.at(place.radius, motions);

      Tensor<1, 3> around;
      around[1]           = 1.;
      const auto strained = [](const Tensor<1, 3> &a, const Tensor<1, 3> &b)
      { return [a, b](const Tensor<2, 3> &slope) { return a * (slope * b) + b * (slope * a); }; };
      const auto stretched = [](const Tensor<1, 3> &a)
      { return [a](const Tensor<2, 3> &slope) { return a * (slope * a); }; };
      // Plane stress as a sum of squares, see ShellElement.
      strains.add(volume * plane * (1. - nu), stretched(place.along));
      strains.add(volume * plane * (1. - nu), stretched(around));
      strains.add(volume * plane * nu, [&](const Tensor<2, 3> &slope)
                  { return stretched(place.along)(slope) + stretched(around)(slope); });
      strains.add(volume * shear, strained(place.along, around));
      strains.add(volume * ShellElement::shear_correction * shear,
                  strained(place.along, place.normal));
      strains.add(volume * ShellElement::shear_correction * shear, strained(around, place.normal));
      strains.add_mass(volume * material.density);
    }
  }

  void SemiAnalyticShell::tie_drill(const Edge &edge, const unsigned int q, const double stiffness)
  {
    // The normal is along x around, so that the surface turns about it by half of what follows.
    const Place place   = place_at(edge, q, 0.);
    motions             = motions_at(edge, q, 0., place);
    const double weight = stiffness * std::abs(place.jacobian) * place.radius * edge.weights[q];
    std::vector<double> turns;
    for (unsigned int i = 0; i < edge.dofs.size(); ++i)
    {
      const unsigned int component = i % fe.n_components(), node = i / fe.n_components();
      turns.push_back(component < 3 ? 0. : edge.values[q][node] * place.normal[component - 3]);
      if (component >= 3)
        motions[i] = {};
    }
    strains.at(place.radius, motions);
    Tensor<1, 3> around;
    around[1] = 1.;
    strains.add(
        weight,
        [&](const Tensor<2, 3> &slope)
        { return -0.5 * (around * (slope * place.along) - place.along * (slope * around)); },
        turns);
  }

  WaveMatrices SemiAnalyticShell::matrices(const Triangulation<2, 3>::active_cell_iterator &cell,
                                           const unsigned int edge_number, const Material &material,
                                           const ShellSection &section, const double angle)
  {
    const Edge &edge = edges[edge_number];
    edge.at_nodes->reinit(cell);
    position.clear();
    director.clear();
    for (unsigned int node = 0; node < edge.nodes.size(); ++node)
    {
      position.push_back(edge.at_nodes->quadrature_point(node));
      director.push_back(edge.at_nodes->normal_vector(node));
    }
    double area = 0.;
    for (unsigned int q = 0; q < edge.weights.size(); ++q)
    {
      const Place place = place_at(edge, q, 0.);
      area += angle * place.radius * std::abs(place.jacobian) * edge.weights[q];
    }
    strains.clear(edge.dofs.size());
    for (unsigned int q = 0; q < edge.weights.size(); ++q)
    {
      add_layers(edge, q, material, section);
      tie_drill(edge, q, ShellElement::drill_stiffness(material, section, area));
    }
    return strains.matrices();
  }
} // namespace ringmotor
