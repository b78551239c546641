// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/elements/solid.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>

#include <support/triplets.h>

#include <functional>
#include <map>
#include <numeric>
#include <vector>

namespace ringmotor::tests
{
  /** A body at rest under tractions. */
  class StaticSolid
  {
  public:
    using Fixed    = std::function<bool(unsigned int component, const dealii::Point<3> &)>;
    using Traction = std::function<dealii::Tensor<1, 3>(const dealii::Point<3> &)>; ///< Pa

    StaticSolid(const dealii::Triangulation<3> &triangulation,
                const std::map<dealii::types::material_id, Material> &materials,
                const unsigned int degree, const Fixed &fixed, const Traction &traction)
        : mapping(degree), fe(dealii::FE_Q<3>(degree), 3), dof_handler(triangulation)
    {
      dof_handler.distribute_dofs(fe);
      positions.resize(dof_handler.n_dofs());
      dealii::DoFTools::map_dofs_to_support_points(mapping, dof_handler, positions);
      components.resize(dof_handler.n_dofs());
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          components[dofs[i]] = fe.system_to_component_index(i).first;
      }
      load(traction);
      solve(materials, fixed);
    }

    /** u of a component at a node. */
    double displacement(const unsigned int component, const dealii::Point<3> &place) const
    {
      for (unsigned int dof = 0; dof < displacements.size(); ++dof)
        if (components[dof] == component && positions[dof].distance(place) < 1e-9)
          return displacements[dof];
      throw std::runtime_error("no node there");
    }

    /** N m, of the tractions. */
    double work() const
    {
      return std::inner_product(loads.begin(), loads.end(), displacements.begin(), 0.);
    }

  private:
    void load(const Traction &traction)
    {
      using namespace dealii;
      FEFaceValues<3> values(mapping, fe.base_element(0), QGauss<2>(fe.degree + 1),
                             update_values | update_quadrature_points | update_JxW_values);
      loads.assign(dof_handler.n_dofs(), 0.);
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
        for (const unsigned int face : cell->face_indices())
          if (cell->at_boundary(face))
          {
            values.reinit(cell, face);
            cell->get_dof_indices(dofs);
            for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
            {
              const Tensor<1, 3> force = traction(values.quadrature_point(q)) * values.JxW(q);
              for (unsigned int i = 0; i < dofs.size(); ++i)
              {
                const auto [component, node] = fe.system_to_component_index(i);
                loads[dofs[i]] += values.shape_value(node, q) * force[component];
              }
            }
          }
    }

    void solve(const std::map<dealii::types::material_id, Material> &materials, const Fixed &fixed)
    {
      std::vector<bool> held(dof_handler.n_dofs());
      displacements = loads;
      SymmetricTriplets triplets;
      for (unsigned int dof = 0; dof < held.size(); ++dof)
        if (fixed(components[dof], positions[dof]))
        {
          held[dof]          = true;
          displacements[dof] = 0.;
          triplets.add(dof, dof, 1.);
        }
      SolidElement element(mapping, fe);
      const unsigned int size = fe.n_dofs_per_cell();
      dealii::FullMatrix<double> stiffness(size, size), mass(size, size);
      std::vector<dealii::types::global_dof_index> dofs(size);
      for (const auto &cell : dof_handler.active_cell_iterators())
      {
        element.reinit(cell, materials.at(cell->material_id()));
        element.matrices(stiffness, mass);
        cell->get_dof_indices(dofs);
        triplets.add(dofs, stiffness, held);
      }
      SparseLDLT factors(held.size(), MPI_COMM_SELF);
      factors.factorise(triplets);
      factors.solve(displacements);
    }

    const dealii::MappingQ<3> mapping;
    const dealii::FESystem<3> fe;
    dealii::DoFHandler<3> dof_handler;
    std::vector<dealii::Point<3>> positions;
    std::vector<unsigned int> components;
    std::vector<double> loads, displacements;
  };
} // namespace ringmotor::tests
