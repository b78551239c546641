// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/elements/shell.h>

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <utility>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int n_layers = 2, n_strains = 5;
    /** The local axes of each strain; shear strains are twice the tensor's. */
    constexpr std::array<std::pair<unsigned int, unsigned int>, n_strains> axes_of{
        {{0, 0}, {1, 1}, {0, 1}, {0, 2}, {1, 2}}};
    constexpr double shear_correction = 5. / 6.;
    /** The tie of the rotation about the normal, against the bending stiffness of a cell. */
    constexpr double drill_fraction = 1e-3;
  } // namespace

  ShellElement::ShellElement(const Mapping<2, 3> &mapping, const FiniteElement<2, 3> &fe)
      : fe(fe), at_nodes(mapping, fe.base_element(0),
                         Quadrature<2>(fe.base_element(0).get_unit_support_points()),
                         update_quadrature_points | update_normal_vectors),
        n_nodes(fe.base_element(0).n_dofs_per_cell()), points(QGauss<2>(fe.degree + 1)),
        position(n_nodes), director(n_nodes)
  {
    for (const Point<2> &point : points.get_points())
    {
      shape.emplace_back();
      gradient.emplace_back();
      for (unsigned int node = 0; node < n_nodes; ++node)
      {
        shape.back().push_back(fe.base_element(0).shape_value(node, point));
        gradient.back().push_back(fe.base_element(0).shape_grad(node, point));
      }
    }
  }

  void ShellElement::reinit(const Triangulation<2, 3>::active_cell_iterator &cell,
                            const Material &new_material, const ShellSection &new_section)
  {
    at_nodes.reinit(cell);
    for (unsigned int node = 0; node < n_nodes; ++node)
    {
      position[node] = at_nodes.quadrature_point(node);
      director[node] = at_nodes.normal_vector(node);
    }
    material = new_material;
    section  = new_section;
    area     = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
      area += points.weight(q) * place_at(q, 0.).volume;
  }

  ShellElement::Place ShellElement::place_at(const unsigned int q, const double z) const
  {
    Tensor<1, 3> along_xi, along_eta, along_z;
    for (unsigned int node = 0; node < n_nodes; ++node)
    {
      const Tensor<1, 3> x = position[node] + z * director[node];
      along_xi += gradient[q][node][0] * x;
      along_eta += gradient[q][node][1] * x;
      along_z += shape[q][node] * director[node];
    }
    const Tensor<1, 3> normal = cross_product_3d(along_xi, along_eta);
    Assert(normal * along_z > 0., ExcMessage("a shell thicker than its curvature allows"));
    Place place;
    place.volume  = normal * along_z;
    place.axes[2] = normal / normal.norm();
    place.axes[0] = along_xi / along_xi.norm();
    place.axes[1] = cross_product_3d(place.axes[2], place.axes[0]);
    place.dxi     = cross_product_3d(along_eta, along_z) / place.volume;
    place.deta    = cross_product_3d(along_z, along_xi) / place.volume;
    place.dz      = normal / place.volume;
    return place;
  }

  void ShellElement::fill_strains(const unsigned int q, const double z, const Place &place,
                                  const unsigned int first_row)
  {
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    {
      const auto [component, node] = fe.system_to_component_index(i);
      const Tensor<1, 3> in_surface =
          gradient[q][node][0] * place.dxi + gradient[q][node][1] * place.deta;
      Tensor<1, 3> direction, slope = in_surface;
      direction[component % 3] = 1.;
      if (component >= 3)
      {
        direction = cross_product_3d(direction, director[node]);
        slope     = z * in_surface + shape[q][node] * place.dz;
      }
      for (unsigned int strain = 0; strain < n_strains; ++strain)
      {
        const auto [m, n] = axes_of[strain];
        double sum        = (place.axes[m] * direction) * (place.axes[n] * slope);
        if (m != n)
          sum += (place.axes[n] * direction) * (place.axes[m] * slope);
        strains(first_row + strain, i) = sum;
      }
    }
  }

  void ShellElement::fill_drill(const unsigned int q, const Place &place, const unsigned int row)
  {
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    {
      const auto [component, node] = fe.system_to_component_index(i);
      const Tensor<1, 3> in_surface =
          gradient[q][node][0] * place.dxi + gradient[q][node][1] * place.deta;
      Tensor<1, 3> direction;
      direction[component % 3] = 1.;
      strains(row, i)          = component >= 3
                                     ? shape[q][node] * (direction * place.axes[2])
                                     : -0.5 * ((place.axes[0] * in_surface) * (place.axes[1] * direction) -
                                      (place.axes[1] * in_surface) * (place.axes[0] * direction));
    }
  }

  void ShellElement::fill_motion(const unsigned int q, const double z, const unsigned int first_row)
  {
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    {
      const auto [component, node] = fe.system_to_component_index(i);
      Tensor<1, 3> direction;
      direction[component % 3] = 1.;
      if (component >= 3)
        direction = z * cross_product_3d(direction, director[node]);
      for (unsigned int d = 0; d < 3; ++d)
        motions(first_row + d, i) = shape[q][node] * direction[d];
    }
  }

  void ShellElement::add_product(const FullMatrix<double> &rows, const std::vector<double> &weights,
                                 FullMatrix<double> &matrix)
  {
    weighted.reinit(rows.m(), rows.n());
    for (unsigned int row = 0; row < rows.m(); ++row)
      for (unsigned int i = 0; i < rows.n(); ++i)
        weighted(row, i) = weights[row] * rows(row, i);
    rows.Tmmult(matrix, weighted, true);
  }

  void ShellElement::matrices(FullMatrix<double> &stiffness, FullMatrix<double> &mass)
  {
    const double nu    = material.poisson_ratio;
    const double shear = material.young_modulus / (2. * (1. + nu));
    const double plane = material.young_modulus / (1. - nu * nu);
    const double t     = section.thickness;
    const double drill = drill_fraction * shear * t * t * t / (12. * area);
    const QGauss<1> layers(n_layers);
    const unsigned int n_rows = n_strains + 1; // with the sum of the strains 11 and 22

    strains.reinit(points.size() * (n_layers * n_rows + 1), fe.n_dofs_per_cell());
    motions.reinit(points.size() * n_layers * 3, fe.n_dofs_per_cell());
    std::vector<double> weights, masses;
    unsigned int row = 0;
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      for (unsigned int layer = 0; layer < n_layers; ++layer)
      {
        const double z      = section.offset + t * (layers.point(layer)[0] - 0.5);
        const Place place   = place_at(q, z);
        const double volume = place.volume * points.weight(q) * t * layers.weight(layer);
        fill_strains(q, z, place, row);
        // Hooke's law in plane stress as a sum of squares: (1 - nu) (e11^2 + e22^2) + nu (e11 +
        // e22)^2
        for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
          strains(row + n_strains, i) = strains(row, i) + strains(row + 1, i);
        for (const double modulus :
             {plane * (1. - nu), plane * (1. - nu), shear, shear_correction * shear,
              shear_correction * shear, plane * nu})
          weights.push_back(volume * modulus);
        row += n_rows;

        fill_motion(q, z, masses.size());
        masses.insert(masses.end(), 3, volume * material.density);
      }
      const Place on_surface = place_at(q, 0.); // where u alone is the motion
      fill_drill(q, on_surface, row++);
      weights.push_back(drill * on_surface.volume * points.weight(q));
    }
    stiffness = 0.;
    mass      = 0.;
    add_product(strains, weights, stiffness);
    add_product(motions, masses, mass);
  }
} // namespace ringmotor
