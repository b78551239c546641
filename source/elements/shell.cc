// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/elements/shell.h>

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <cmath>
#include <utility>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int n_strains = 5, first_shear = 3;
    /** The local axes of each strain; shear strains are twice the tensor's. */
    constexpr std::array<std::pair<unsigned int, unsigned int>, n_strains> axes_of{
        {{0, 0}, {1, 1}, {0, 1}, {0, 2}, {1, 2}}};
    /** Stiffness of the tie of the rotation about the normal, relative to the bending stiffness of
     * a cell. */
    constexpr double drill_fraction = 1e-3;
  } // namespace

  ShellElement::Shapes::Shapes(const FiniteElement<2, 3> &fe, const Point<2> &point)
  {
    for (unsigned int node = 0; node < fe.n_dofs_per_cell(); ++node)
    {
      value.push_back(fe.shape_value(node, point));
      gradient.push_back(fe.shape_grad(node, point));
    }
  }

  double ShellElement::drill_stiffness(const Material &material, const ShellSection &section,
                                       const double area)
  {
    return drill_fraction * material.young_modulus / (2. * (1. + material.poisson_ratio)) *
           std::pow(section.thickness, 3) / (12. * area);
  }

  ShellElement::ShellElement(const Mapping<2, 3> &mapping, const FiniteElement<2, 3> &fe)
      : fe(fe), at_nodes(mapping, fe.base_element(0),
                         Quadrature<2>(fe.base_element(0).get_unit_support_points()),
                         update_quadrature_points | update_normal_vectors),
        n_nodes(fe.base_element(0).n_dofs_per_cell()), points(QGauss<2>(fe.degree + 1)),
        position(n_nodes), director(n_nodes)
  {
    for (const Point<2> &point : points.get_points())
      shapes.emplace_back(fe.base_element(0), point);
    if (fe.degree == 1)
    {
      ties[0] = {{fe.base_element(0), {0.5, 0.}}, {fe.base_element(0), {0.5, 1.}}};
      ties[1] = {{fe.base_element(0), {0., 0.5}}, {fe.base_element(0), {1., 0.5}}};
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
      area += points.weight(q) * place_at(shapes[q], 0.).volume;
    build_rows();
  }

  ShellElement::Place ShellElement::place_at(const Shapes &at, const double z) const
  {
    Place place;
    auto &[along_xi, along_eta, along_z] = place.tangents;
    for (unsigned int node = 0; node < n_nodes; ++node)
    {
      const Tensor<1, 3> x = position[node] + z * director[node];
      along_xi += at.gradient[node][0] * x;
      along_eta += at.gradient[node][1] * x;
      along_z += at.value[node] * director[node];
    }
    const Tensor<1, 3> normal = cross_product_3d(along_xi, along_eta);
    Assert(normal * along_z > 0., ExcMessage("a shell thicker than its curvature allows"));
    place.volume    = normal * along_z;
    place.axes[2]   = normal / normal.norm();
    place.axes[0]   = along_xi / along_xi.norm();
    place.axes[1]   = cross_product_3d(place.axes[2], place.axes[0]);
    place.gradients = {{cross_product_3d(along_eta, along_z) / place.volume,
                        cross_product_3d(along_z, along_xi) / place.volume, normal / place.volume}};
    return place;
  }

  ShellElement::Motion ShellElement::unit_motion(const unsigned int i) const
  {
    const auto [component, node] = fe.system_to_component_index(i);
    Tensor<1, 3> unit;
    unit[component % 3] = 1.;
    return component < 3 ? Motion{unit, {}} : Motion{{}, cross_product_3d(unit, director[node])};
  }

  void ShellElement::fill_strains(const unsigned int q, const double z, const Place &place,
                                  const unsigned int first_row)
  {
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    {
      const auto [component, node]  = fe.system_to_component_index(i);
      const Tensor<1, 3> in_surface = shapes[q].gradient[node][0] * place.gradients[0] +
                                      shapes[q].gradient[node][1] * place.gradients[1];
      const Motion motion          = unit_motion(i);
      const Tensor<1, 3> direction = component < 3 ? motion.surface : motion.director;
      const Tensor<1, 3> slope =
          component < 3 ? in_surface : z * in_surface + shapes[q].value[node] * place.gradients[2];
      for (unsigned int strain = 0; strain < n_strains; ++strain)
      {
        const auto [m, n] = axes_of[strain];
        double sum        = (place.axes[m] * direction) * (place.axes[n] * slope);
        if (m != n)
          sum += (place.axes[n] * direction) * (place.axes[m] * slope);
        strains.rows(first_row + strain, i) = sum;
      }
    }
  }

  double ShellElement::covariant_shear(const Shapes &at, const Place &place,
                                       const unsigned int direction, const double z,
                                       const unsigned int i) const
  {
    const unsigned int node = fe.system_to_component_index(i).second;
    const Motion motion     = unit_motion(i);
    return at.gradient[node][direction] * (motion.surface + z * motion.director) *
               place.tangents[2] +
           at.value[node] * motion.director * place.tangents[direction];
  }

  void ShellElement::tie_shear_strains(const unsigned int q, const double z, const Place &place,
                                       const unsigned int first_row)
  {
    for (const unsigned int direction : {0u, 1u})
    {
      const double across = points.point(q)[1 - direction];
      const Place low = place_at(ties[direction][0], z), high = place_at(ties[direction][1], z);
      // The gradient of z is normal to the layer: only one product of the change to local axes
      // remains.
      const double upright = place.axes[2] * place.gradients[2];
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
      {
        const double change =
            (1. - across) * covariant_shear(ties[direction][0], low, direction, z, i) +
            across * covariant_shear(ties[direction][1], high, direction, z, i) -
            covariant_shear(shapes[q], place, direction, z, i);
        for (const unsigned int m : {0u, 1u})
          strains.rows(first_row + first_shear + m, i) +=
              change * upright * (place.axes[m] * place.gradients[direction]);
      }
    }
  }

  void ShellElement::fill_drill(const unsigned int q, const Place &place, const unsigned int row)
  {
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    {
      const auto [component, node]  = fe.system_to_component_index(i);
      const Tensor<1, 3> in_surface = shapes[q].gradient[node][0] * place.gradients[0] +
                                      shapes[q].gradient[node][1] * place.gradients[1];
      Tensor<1, 3> direction;
      direction[component % 3] = 1.;
      strains.rows(row, i) =
          component >= 3 ? shapes[q].value[node] * (direction * place.axes[2])
                         : -0.5 * ((place.axes[0] * in_surface) * (place.axes[1] * direction) -
                                   (place.axes[1] * in_surface) * (place.axes[0] * direction));
    }
  }

  void ShellElement::fill_motion(const unsigned int q, const double z, const unsigned int first_row)
  {
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    {
      const unsigned int node      = fe.system_to_component_index(i).second;
      const Motion motion          = unit_motion(i);
      const Tensor<1, 3> direction = motion.surface + z * motion.director;
      for (unsigned int d = 0; d < 3; ++d)
        motions.rows(first_row + d, i) = shapes[q].value[node] * direction[d];
    }
  }

  void ShellElement::build_rows()
  {
    const double nu    = material.poisson_ratio;
    const double shear = material.young_modulus / (2. * (1. + nu));
    const double plane = material.young_modulus / (1. - nu * nu);
    const double t     = section.thickness;
    const double drill = drill_stiffness(material, section, area);
    const QGauss<1> layers(n_layers);
    const unsigned int n_rows = n_strains + 1; // with the sum of the strains 11 and 22

    strains.rows.reinit(points.size() * (n_layers * n_rows + 1), fe.n_dofs_per_cell());
    motions.rows.reinit(points.size() * n_layers * 3, fe.n_dofs_per_cell());
    strains.weights.clear();
    motions.weights.clear();
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      for (unsigned int layer = 0; layer < n_layers; ++layer)
      {
        const double z         = section.offset + t * (layers.point(layer)[0] - 0.5);
        const Place place      = place_at(shapes[q], z);
        const double volume    = place.volume * points.weight(q) * t * layers.weight(layer);
        const unsigned int row = strains.weights.size();
        fill_strains(q, z, place, row);
        if (fe.degree == 1)
          tie_shear_strains(q, z, place, row);
        // Hooke's law in plane stress as a sum of squares: (1 - nu) (e11^2 + e22^2) + nu (e11 +
        // e22)^2
        for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
          strains.rows(row + n_strains, i) = strains.rows(row, i) + strains.rows(row + 1, i);
        for (const double modulus :
             {plane * (1. - nu), plane * (1. - nu), shear, shear_correction * shear,
              shear_correction * shear, plane * nu})
          strains.weights.push_back(volume * modulus);

        fill_motion(q, z, motions.weights.size());
        motions.weights.insert(motions.weights.end(), 3, volume * material.density);
      }
      const Place on_surface = place_at(shapes[q], 0.); // where u alone is the motion
      fill_drill(q, on_surface, strains.weights.size());
      strains.weights.push_back(drill * on_surface.volume * points.weight(q));
    }
  }

  void ShellElement::matrices(FullMatrix<double> &stiffness, FullMatrix<double> &mass)
  {
    strains.fill(stiffness);
    motions.fill(mass);
  }

  std::vector<double> ShellElement::stiffness_products(const std::vector<Vector<double>> &fields)
  {
    return strains.products(fields);
  }

  std::vector<double> ShellElement::mass_products(const std::vector<Vector<double>> &fields)
  {
    return motions.products(fields);
  }
} // namespace ringmotor
