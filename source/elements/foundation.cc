// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/elements/foundation.h>

#include <deal.II/base/quadrature_lib.h>

namespace ringmotor
{
  using namespace dealii;

  FoundationElement::FoundationElement(const Mapping<3> &mapping, const FiniteElement<3> &fe)
      : fe(fe), scalar_values(mapping, fe.base_element(0), QGauss<2>(fe.degree + 1),
                              update_values | update_normal_vectors | update_JxW_values)
  {
  }

  void FoundationElement::reinit(const Triangulation<3>::active_cell_iterator &cell,
                                 const unsigned int face, const double stiffness)
  {
    scalar_values.reinit(cell, face);
    const unsigned int n_points = scalar_values.n_quadrature_points;
    springs.rows.reinit(n_points, fe.n_dofs_per_cell());
    springs.weights.resize(n_points);
    for (unsigned int q = 0; q < n_points; ++q)
    {
      const Tensor<1, 3> normal = scalar_values.normal_vector(q);
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
      {
        const auto [component, node] = fe.system_to_component_index(i);
        springs.rows(q, i)           = normal[component] * scalar_values.shape_value(node, q);
      }
      springs.weights[q] = stiffness * scalar_values.JxW(q);
    }
  }
} // namespace ringmotor
