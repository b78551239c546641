// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/elements/solid.h>

#include <deal.II/base/quadrature_lib.h>

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
  } // namespace

  SolidElement::SolidElement(const Mapping<3> &mapping, const FiniteElement<3> &fe)
      : fe(fe), scalar_values(mapping, fe.base_element(0), QGauss<3>(fe.degree + 1),
                              update_values | update_gradients | update_JxW_values),
        n_nodes(fe.base_element(0).n_dofs_per_cell())
  {
    const unsigned int n_points = scalar_values.n_quadrature_points;
    gradients.reinit(n_points, 3 * n_nodes);
    weighted_gradients.reinit(n_points, 3 * n_nodes);
    gram.reinit(3 * n_nodes, 3 * n_nodes);
    values.reinit(n_points, n_nodes);
    weighted_values.reinit(n_points, n_nodes);
    overlap.reinit(n_nodes, n_nodes);
  }

  void SolidElement::compute(const Triangulation<3>::active_cell_iterator &cell,
                             const Material &material, FullMatrix<double> &stiffness,
                             FullMatrix<double> &mass)
  {
    scalar_values.reinit(cell);
    for (unsigned int q = 0; q < scalar_values.n_quadrature_points; ++q)
    {
      const double weight = scalar_values.JxW(q);
      for (unsigned int i = 0; i < n_nodes; ++i)
      {
        values(q, i)                 = scalar_values.shape_value(i, q);
        weighted_values(q, i)        = weight * values(q, i);
        const Tensor<1, 3> &gradient = scalar_values.shape_grad(i, q);
        for (unsigned int d = 0; d < 3; ++d)
        {
          gradients(q, d * n_nodes + i)          = gradient[d];
          weighted_gradients(q, d * n_nodes + i) = weight * gradient[d];
        }
      }
    }
    // Two dense products (BLAS) hold every integral of a pair of shape functions; Hooke's law only
    // combines them. At high degree this is several times faster than a loop over strains.
    gradients.Tmmult(gram, weighted_gradients);
    values.Tmmult(overlap, weighted_values);

    const double lambda = first_lame_constant(material);
    const double mu     = shear_modulus(material);
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
        mass(i, j) = 0.;
        if (component_i == component_j)
        {
          stiffness(i, j) += mu * (integral(0, 0) + integral(1, 1) + integral(2, 2));
          mass(i, j) = material.density * overlap(node_i, node_j);
        }
      }
    }
  }
} // namespace ringmotor
