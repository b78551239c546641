// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/elements/solid.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <vector>

namespace ringmotor::tests
{
  using dealii::FullMatrix;
  using dealii::Point;
  using dealii::Vector;

  /**
   * A box of cells between the origin and a corner as dense matrices. Each degree of freedom,
   * component 0 to 2 of displacement or 3 for the potential, is fixed or follows an unknown, chosen
   * by component and position.
   */
  class Box
  {
  public:
    Box(const std::vector<unsigned int> &n_cells, const Point<3> &corner, const unsigned int degree,
        const Material &material)
        : mapping(1), scalar(degree), fe(scalar, 3), solid(triangulation), potential(triangulation)
    {
      dealii::GridGenerator::subdivided_hyper_rectangle(triangulation, n_cells, Point<3>(), corner,
                                                        true);
      solid.distribute_dofs(fe);
      potential.distribute_dofs(scalar);
      const unsigned int n = solid.n_dofs(), n_total = n + potential.n_dofs();
      matrix.reinit(n_total, n_total);
      mass.reinit(n_total, n_total);
      component.resize(n_total, 3);
      position.resize(n_total);
      SolidElement element(mapping, fe);
      const unsigned int n_u = fe.n_dofs_per_cell(), n_phi = scalar.n_dofs_per_cell();
      FullMatrix<double> k(n_u, n_u), b(n_u, n_phi), d(n_phi, n_phi), m(n_u, n_u);
      std::vector<dealii::types::global_dof_index> u_dofs(n_u), phi_dofs(n_phi);
      auto other = potential.begin_active();
      for (const auto &cell : solid.active_cell_iterators())
      {
        element.reinit(cell, material);
        element.piezoelectric_matrices(k, b, d);
        element.mass_matrix(m);
        cell->get_dof_indices(u_dofs);
        (other++)->get_dof_indices(phi_dofs);
        for (unsigned int i = 0; i < n_u; ++i)
        {
          const auto [c, node] = fe.system_to_component_index(i);
          component[u_dofs[i]] = c;
          position[u_dofs[i]]  = position[n + phi_dofs[node]] =
              mapping.transform_unit_to_real_cell(cell, scalar.unit_support_point(node));
          for (unsigned int j = 0; j < n_u; ++j)
          {
            matrix(u_dofs[i], u_dofs[j]) += k(i, j);
            mass(u_dofs[i], u_dofs[j]) += m(i, j);
          }
          for (unsigned int j = 0; j < n_phi; ++j)
          {
            matrix(u_dofs[i], n + phi_dofs[j]) += b(i, j);
            matrix(n + phi_dofs[j], u_dofs[i]) += b(i, j);
          }
        }
        for (unsigned int i = 0; i < n_phi; ++i)
          for (unsigned int j = 0; j < n_phi; ++j)
            matrix(n + phi_dofs[i], n + phi_dofs[j]) -= d(i, j);
      }
    }

    /** Fixes some degrees of freedom; those with equal keys share an unknown. */
    void constrain(const std::function<bool(unsigned int, const Point<3> &)> &is_fixed,
                   const std::function<std::vector<long>(unsigned int, const Point<3> &)> &key = {})
    {
      std::map<std::vector<long>, int> known;
      unknown.assign(component.size(), -1);
      is_potential.clear();
      for (unsigned int i = 0; i < component.size(); ++i)
        if (!is_fixed(component[i], position[i]))
        {
          std::vector<long> name = key ? key(component[i], position[i]) : std::vector<long>();
          if (name.empty())
            name = {-1, i};
          const auto [found, is_new] = known.emplace(name, is_potential.size());
          if (is_new)
            is_potential.push_back(component[i] == 3);
          unknown[i] = found->second;
        }
    }

    /** The lowest frequencies in Hz, with the potential eliminated. */
    std::vector<double> frequencies(const unsigned int n_wanted) const
    {
      const FullMatrix<double> k = reduced(matrix), m = reduced(mass);
      const std::vector<unsigned int> mechanical = places(false), electrical = places(true);
      FullMatrix<double> stiffness(mechanical.size(), mechanical.size()),
          inertia(mechanical.size(), mechanical.size()),
          across(electrical.size(), mechanical.size()), response(across),
          dielectric(electrical.size(), electrical.size()), inverse(dielectric);
      stiffness.extract_submatrix_from(k, mechanical, mechanical);
      inertia.extract_submatrix_from(m, mechanical, mechanical);
      if (!electrical.empty())
      {
        across.extract_submatrix_from(k, electrical, mechanical);
        dielectric.extract_submatrix_from(k, electrical, electrical);
        inverse.invert(dielectric);
        inverse.mmult(response, across);
        FullMatrix<double> stiffening(stiffness);
        across.Tmmult(stiffening, response);
        stiffness.add(-1., stiffening);
      }
      dealii::LAPACKFullMatrix<double> a(mechanical.size()), b(mechanical.size());
      a = stiffness;
      b = inertia;
      std::vector<Vector<double>> modes(n_wanted, Vector<double>(mechanical.size()));
      a.compute_generalized_eigenvalues_symmetric(b, modes);
      std::vector<double> found;
      for (unsigned int i = 0; i < n_wanted; ++i)
        found.push_back(std::sqrt(std::max(0., a.eigenvalue(i).real())) /
                        (2. * dealii::numbers::PI));
      return found;
    }

    /** All degrees of freedom under loads, with values given where they are fixed. */
    Vector<double> solve(const Vector<double> &loads,
                         const std::function<double(unsigned int, const Point<3> &)> &given) const
    {
      Vector<double> fixed(component.size()), rest(component.size());
      for (unsigned int i = 0; i < component.size(); ++i)
        if (unknown[i] < 0)
          fixed[i] = given(component[i], position[i]);
      matrix.vmult(rest, fixed);
      Vector<double> sides(is_potential.size());
      for (unsigned int i = 0; i < component.size(); ++i)
        if (unknown[i] >= 0)
          sides[unknown[i]] += loads[i] - rest[i];
      dealii::LAPACKFullMatrix<double> factors(is_potential.size());
      factors = reduced(matrix);
      factors.compute_lu_factorization();
      factors.solve(sides);
      for (unsigned int i = 0; i < component.size(); ++i)
        if (unknown[i] >= 0)
          fixed[i] = sides[unknown[i]];
      return fixed;
    }

    /** Loads of a traction or a charge per area on the faces with a boundary id. */
    Vector<double> face_loads(const dealii::types::boundary_id face_id, const unsigned int of,
                              const std::function<double(const Point<3> &)> &density) const
    {
      Vector<double> loads(component.size());
      dealii::FEFaceValues<3> values(mapping, scalar, dealii::QGauss<2>(scalar.degree + 2),
                                     dealii::update_values | dealii::update_JxW_values |
                                         dealii::update_quadrature_points);
      std::vector<dealii::types::global_dof_index> dofs(scalar.n_dofs_per_cell()),
          u_dofs(fe.n_dofs_per_cell());
      auto other = solid.begin_active();
      for (const auto &cell : potential.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        (other++)->get_dof_indices(u_dofs);
        for (const unsigned int face : cell->face_indices())
          if (cell->at_boundary(face) && cell->face(face)->boundary_id() == face_id)
          {
            values.reinit(cell, face);
            for (const unsigned int q : values.quadrature_point_indices())
              for (unsigned int i = 0; i < dofs.size(); ++i)
                loads[of == 3 ? solid.n_dofs() + dofs[i]
                              : u_dofs[fe.component_to_system_index(of, i)]] +=
                    values.JxW(q) * values.shape_value(i, q) * density(values.quadrature_point(q));
          }
      }
      return loads;
    }

    /** The value of a component at a node. */
    double at(const Vector<double> &solution, const unsigned int of, const Point<3> &where) const
    {
      for (unsigned int i = 0; i < component.size(); ++i)
        if (component[i] == of && position[i].distance(where) < 1e-6 * where.norm() + 1e-12)
          return solution[i];
      ADD_FAILURE() << "no node at " << where;
      return 0.;
    }

    /** Forces and minus charges that keep a solution. */
    Vector<double> reactions(const Vector<double> &solution) const
    {
      Vector<double> result(solution.size());
      matrix.vmult(result, solution);
      return result;
    }

    std::vector<unsigned int> component; ///< by degree of freedom; 3 for the potential
    std::vector<Point<3>> position;

  private:
    FullMatrix<double> reduced(const FullMatrix<double> &whole) const
    {
      FullMatrix<double> result(is_potential.size(), is_potential.size());
      for (unsigned int i = 0; i < component.size(); ++i)
        for (unsigned int j = 0; j < component.size(); ++j)
          if (unknown[i] >= 0 && unknown[j] >= 0)
            result(unknown[i], unknown[j]) += whole(i, j);
      return result;
    }

    std::vector<unsigned int> places(const bool of_potential) const
    {
      std::vector<unsigned int> places;
      for (unsigned int i = 0; i < is_potential.size(); ++i)
        if (is_potential[i] == of_potential)
          places.push_back(i);
      return places;
    }

    dealii::Triangulation<3> triangulation;
    dealii::MappingQ<3> mapping;
    dealii::FE_Q<3> scalar;
    dealii::FESystem<3> fe;
    dealii::DoFHandler<3> solid, potential;
    FullMatrix<double> matrix, mass;
    std::vector<int> unknown;
    std::vector<bool> is_potential;
  };
} // namespace ringmotor::tests
