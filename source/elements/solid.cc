// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/elements/solid.h>

#include <deal.II/base/quadrature_lib.h>

#include <array>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    double shear_modulus(const Material &material)
    {
      return material.young_modulus / (2. * (1. + material.poisson_ratio));
    }

    double first_lame_constant(const Material &material)
    {
      const double nu = material.poisson_ratio;
      return material.young_modulus * nu / ((1. + nu) * (1. - 2. * nu));
    }

    /** Where a PiezoelectricLaw has the component of a symmetric tensor. */
    constexpr std::array<std::array<unsigned int, 3>, 3> voigt{
        {{{0, 5, 4}}, {{5, 1, 3}}, {{4, 3, 2}}}};

    /** Strains in the order of a PiezoelectricLaw. */
    template <typename Slope>
    std::array<double, 6> strains(const Slope &slope)
    {
      return {{slope(0, 0), slope(1, 1), slope(2, 2), slope(1, 2) + slope(2, 1),
               slope(0, 2) + slope(2, 0), slope(0, 1) + slope(1, 0)}};
    }
  } // namespace

  Elasticity::Elasticity(const Material &material)
      : lambda(material.law ? 0. : first_lame_constant(material)),
        mu(material.law ? 0. : shear_modulus(material)), law(material.law)
  {
  }

  template <typename Slope>
  double Elasticity::twice_energy_density(const Slope &slope) const
  {
    if (law)
    {
      const std::array<double, 6> strain = strains(slope);
      double energy                      = 0.;
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 6; ++j)
          energy += strain[i] * law->stiffness[i][j] * strain[j];
      return energy;
    }
    double divergence = 0., squares = 0.;
    for (unsigned int c = 0; c < 3; ++c)
    {
      divergence += slope(c, c);
      squares += 2. * slope(c, c) * slope(c, c);
      const double shear = slope(c, (c + 1) % 3) + slope((c + 1) % 3, c);
      squares += shear * shear;
    }
    return lambda * divergence * divergence + mu * squares;
  }

  double strain_energy_density(const Material &material, const Tensor<2, 3> &displacement_gradient)
  {
    return 0.5 *
           Elasticity(material).twice_energy_density([&](const unsigned int c, const unsigned int d)
                                                     { return displacement_gradient[c][d]; });
  }

  SolidElement::SolidElement(const Mapping<3> &mapping, const FiniteElement<3> &fe)
      : fe(fe), scalar_values(mapping, fe.base_element(0), QGauss<3>(fe.degree + 1),
                              update_values | update_gradients | update_JxW_values),
        n_nodes(fe.base_element(0).n_dofs_per_cell()), n_points(scalar_values.n_quadrature_points)
  {
  }

  void SolidElement::reinit(const Triangulation<3>::active_cell_iterator &cell,
                            const Material &material)
  {
    scalar_values.reinit(cell);
    elasticity = Elasticity(material);
    density    = material.density;
  }

  void SolidElement::compute_gram()
  {
    gradients.reinit(n_points, 3 * n_nodes);
    weighted_gradients.reinit(n_points, 3 * n_nodes);
    for (unsigned int q = 0; q < n_points; ++q)
      for (unsigned int i = 0; i < n_nodes; ++i)
      {
        const Tensor<1, 3> &gradient = scalar_values.shape_grad(i, q);
        for (unsigned int d = 0; d < 3; ++d)
        {
          gradients(q, d * n_nodes + i)          = gradient[d];
          weighted_gradients(q, d * n_nodes + i) = scalar_values.JxW(q) * gradient[d];
        }
      }
    // A dense product (BLAS) contains every integral of a pair of shape functions; constitutive
    // laws only combine them. At high degree this is several times faster than a loop over strains.
    gram.reinit(3 * n_nodes, 3 * n_nodes);
    gradients.Tmmult(gram, weighted_gradients);
  }

  void SolidElement::stiffness_matrix(FullMatrix<double> &stiffness)
  {
    compute_gram();
    if (elasticity.law)
      anisotropic_stiffness(stiffness);
    else
      isotropic_stiffness(stiffness);
  }

  void SolidElement::isotropic_stiffness(FullMatrix<double> &stiffness) const
  {
    const double lambda = elasticity.lambda, mu = elasticity.mu;
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    {
      const auto [component_i, node_i] = fe.system_to_component_index(i);
      for (unsigned int j = 0; j < fe.n_dofs_per_cell(); ++j)
      {
        const auto [component_j, node_j] = fe.system_to_component_index(j);
        const auto integral = [&](const unsigned int derivative_i, const unsigned int derivative_j)
        { return gram(derivative_i * n_nodes + node_i, derivative_j * n_nodes + node_j); };
        stiffness(i, j) =
            lambda * integral(component_i, component_j) + mu * integral(component_j, component_i);
        if (component_i == component_j)
          stiffness(i, j) += mu * (integral(0, 0) + integral(1, 1) + integral(2, 2));
      }
    }
  }

  void SolidElement::anisotropic_stiffness(FullMatrix<double> &stiffness) const
  {
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    {
      const auto [component_i, node_i] = fe.system_to_component_index(i);
      for (unsigned int j = 0; j < fe.n_dofs_per_cell(); ++j)
      {
        const auto [component_j, node_j] = fe.system_to_component_index(j);
        double sum                       = 0.;
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 3; ++b)
            sum += elasticity.law->stiffness[voigt[component_i][a]][voigt[component_j][b]] *
                   gram(a * n_nodes + node_i, b * n_nodes + node_j);
        stiffness(i, j) = sum;
      }
    }
  }

  void SolidElement::piezoelectric_matrices(FullMatrix<double> &stiffness,
                                            FullMatrix<double> &coupling,
                                            FullMatrix<double> &dielectric)
  {
    Assert(elasticity.law, ExcMessage("This cell has no potential."));
    stiffness_matrix(stiffness);
    for (unsigned int j = 0; j < n_nodes; ++j)
    {
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
      {
        const auto [component, node] = fe.system_to_component_index(i);
        coupling(i, j)               = 0.;
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 3; ++b)
            coupling(i, j) += elasticity.law->coupling[b][voigt[component][a]] *
                              gram(a * n_nodes + node, b * n_nodes + j);
      }
      for (unsigned int i = 0; i < n_nodes; ++i)
      {
        dielectric(i, j) = 0.;
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 3; ++b)
            dielectric(i, j) +=
                elasticity.law->permittivity[a][b] * gram(a * n_nodes + i, b * n_nodes + j);
      }
    }
  }

  void SolidElement::mass_matrix(FullMatrix<double> &mass)
  {
    values.reinit(n_points, n_nodes);
    weighted_values.reinit(n_points, n_nodes);
    for (unsigned int q = 0; q < n_points; ++q)
      for (unsigned int i = 0; i < n_nodes; ++i)
      {
        values(q, i)          = scalar_values.shape_value(i, q);
        weighted_values(q, i) = scalar_values.JxW(q) * values(q, i);
      }
    overlap.reinit(n_nodes, n_nodes);
    values.Tmmult(overlap, weighted_values);
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    {
      const auto [component_i, node_i] = fe.system_to_component_index(i);
      for (unsigned int j = 0; j < fe.n_dofs_per_cell(); ++j)
      {
        const auto [component_j, node_j] = fe.system_to_component_index(j);
        mass(i, j) = component_i == component_j ? density * overlap(node_i, node_j) : 0.;
      }
    }
  }

  const FullMatrix<double> &SolidElement::by_nodes(const std::vector<Vector<double>> &fields)
  {
    nodal.reinit(n_nodes, 3 * fields.size());
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    {
      const auto [component, node] = fe.system_to_component_index(i);
      for (unsigned int field = 0; field < fields.size(); ++field)
        nodal(node, 3 * field + component) = fields[field][i];
    }
    return nodal;
  }

  void SolidElement::slopes_of(const FullMatrix<double> &nodal_values, FullMatrix<double> &slopes)
  {
    gradients.reinit(3 * n_points, n_nodes);
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int q = 0; q < n_points; ++q)
        for (unsigned int d = 0; d < 3; ++d)
          gradients(3 * q + d, i) = scalar_values.shape_grad(i, q)[d];
    slopes.reinit(3 * n_points, nodal_values.n());
    gradients.mmult(slopes, nodal_values);
  }

  std::vector<double> SolidElement::stiffness_products(const std::vector<Vector<double>> &fields)
  {
    slopes_of(by_nodes(fields), at_points);

    std::vector<double> products(fields.size(), 0.);
    for (unsigned int q = 0; q < n_points; ++q)
      for (unsigned int field = 0; field < fields.size(); ++field)
      {
        const auto slope = [&](const unsigned int component, const unsigned int d)
        { return at_points(3 * q + d, 3 * field + component); };
        products[field] += scalar_values.JxW(q) * elasticity.twice_energy_density(slope);
      }
    return products;
  }

  std::vector<double> SolidElement::mass_products(const std::vector<Vector<double>> &fields)
  {
    values.reinit(n_points, n_nodes);
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int q = 0; q < n_points; ++q)
        values(q, i) = scalar_values.shape_value(i, q);
    at_points.reinit(n_points, 3 * fields.size());
    values.mmult(at_points, by_nodes(fields));

    std::vector<double> products(fields.size(), 0.);
    for (unsigned int q = 0; q < n_points; ++q)
      for (unsigned int column = 0; column < 3 * fields.size(); ++column)
        products[column / 3] +=
            density * scalar_values.JxW(q) * at_points(q, column) * at_points(q, column);
    return products;
  }

  std::vector<ElectricProducts>
  SolidElement::electric_products(const std::vector<Vector<double>> &fields,
                                  const std::vector<Vector<double>> &potentials)
  {
    Assert(elasticity.law, ExcMessage("This cell has no potential."));
    FullMatrix<double> nodal_potentials(n_nodes, potentials.size()), potential_slopes;
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int field = 0; field < potentials.size(); ++field)
        nodal_potentials(i, field) = potentials[field][i];
    slopes_of(nodal_potentials, potential_slopes);
    slopes_of(by_nodes(fields), at_points);

    std::vector<ElectricProducts> products(fields.size());
    for (unsigned int q = 0; q < n_points; ++q)
      for (unsigned int field = 0; field < fields.size(); ++field)
      {
        const std::array<double, 6> strain =
            strains([&](const unsigned int component, const unsigned int d)
                    { return at_points(3 * q + d, 3 * field + component); });
        for (unsigned int a = 0; a < 3; ++a)
        {
          const double weighted_slope = scalar_values.JxW(q) * potential_slopes(3 * q + a, field);
          for (unsigned int i = 0; i < 6; ++i)
            products[field].coupling += weighted_slope * elasticity.law->coupling[a][i] * strain[i];
          for (unsigned int b = 0; b < 3; ++b)
            products[field].dielectric += weighted_slope * elasticity.law->permittivity[a][b] *
                                          potential_slopes(3 * q + b, field);
        }
      }
    return products;
  }
} // namespace ringmotor
