// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/elements/shell.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <support/triplets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

namespace ringmotor::tests
{
  using dealii::Point;
  using dealii::Tensor;

  using Vector6 = std::array<double, 6>;

  inline Tensor<1, 3> vector(const double x, const double y, const double z)
  {
    return Tensor<1, 3>({x, y, z});
  }

  /** A surface given by two parameters. */
  struct Surface
  {
    std::function<Point<3>(const Point<2> &)> place;
    std::function<Point<2>(const Point<3> &)> parameters;
  };

  class SurfaceManifold : public dealii::ChartManifold<2, 3, 2>
  {
  public:
    explicit SurfaceManifold(const Surface &surface) : surface(surface) {}
    Point<3> push_forward(const Point<2> &chart) const override { return surface.place(chart); }
    Point<2> pull_back(const Point<3> &x) const override { return surface.parameters(x); }
    std::unique_ptr<dealii::Manifold<2, 3>> clone() const override
    {
      return std::make_unique<SurfaceManifold>(surface);
    }

  private:
    const Surface surface;
  };

  /** Cells over a rectangle of parameters. */
  struct ParameterMesh
  {
    Point<2> low, high;
    std::array<unsigned int, 2> cells;
    double distortion =
        0.; ///< inner vertices are moved by varying fractions of the sides, up to this

    Point<2> parameters(const Point<2> &unit) const
    {
      const double inside = std::sin(M_PI * unit[0]) * std::sin(M_PI * unit[1]);
      Point<2> result;
      for (unsigned int d = 0; d < 2; ++d)
        result[d] = low[d] + (high[d] - low[d]) *
                                 (unit[d] + distortion * inside *
                                                std::sin(7. * unit[0] + 3. * unit[1] + 2. * d));
      return result;
    }
  };

  /** A shell in one piece, with everything needed to load and solve it. */
  class Shell
  {
  public:
    Shell(const Surface &surface, const ParameterMesh &mesh, const unsigned int degree,
          const Material &material, const ShellSection &section)
        : mapping(std::max(2u, degree)), fe(dealii::FE_Q<2, 3>(degree), 6),
          dof_handler(triangulation), material(material), section(section)
    {
      dealii::Triangulation<2> unit_square;
      dealii::GridGenerator::subdivided_hyper_rectangle(unit_square, {mesh.cells[0], mesh.cells[1]},
                                                        Point<2>(0., 0.), Point<2>(1., 1.));
      std::vector<Point<3>> vertices;
      for (const Point<2> &unit : unit_square.get_vertices())
        vertices.push_back(surface.place(mesh.parameters(unit)));
      std::vector<dealii::CellData<2>> cells;
      for (const auto &cell : unit_square.active_cell_iterators())
      {
        dealii::CellData<2> data;
        for (const unsigned int v : cell->vertex_indices())
          data.vertices[v] = cell->vertex_index(v);
        cells.push_back(data);
      }
      triangulation.create_triangulation(vertices, cells, dealii::SubCellData());
      triangulation.set_all_manifold_ids(0);
      triangulation.set_manifold(0, SurfaceManifold(surface));
      dof_handler.distribute_dofs(fe);
      find_nodes();
    }

    unsigned int n_dofs() const { return dof_handler.n_dofs(); }

    dealii::Vector<double> interpolate(const std::function<Vector6(const Point<3> &)> &motion) const
    {
      dealii::Vector<double> field(n_dofs());
      for (unsigned int dof = 0; dof < n_dofs(); ++dof)
        field[dof] = motion(positions[dof])[components[dof]];
      return field;
    }

    /** a.K b and a.M b */
    std::pair<double, double> products(const dealii::Vector<double> &a,
                                       const dealii::Vector<double> &b) const
    {
      std::pair<double, double> sum{0., 0.};
      for_each_cell(
          [&](const auto &dofs, const auto &stiffness, const auto &mass)
          {
            for (unsigned int i = 0; i < dofs.size(); ++i)
              for (unsigned int j = 0; j < dofs.size(); ++j)
              {
                sum.first += a[dofs[i]] * stiffness(i, j) * b[dofs[j]];
                sum.second += a[dofs[i]] * mass(i, j) * b[dofs[j]];
              }
          });
      return sum;
    }

    /** Forces and moments that keep the shell in this state. */
    dealii::Vector<double> forces(const dealii::Vector<double> &field) const
    {
      dealii::Vector<double> sum(n_dofs());
      for_each_cell(
          [&](const auto &dofs, const auto &stiffness, const auto &)
          {
            for (unsigned int i = 0; i < dofs.size(); ++i)
              for (unsigned int j = 0; j < dofs.size(); ++j)
                sum[dofs[i]] += stiffness(i, j) * field[dofs[j]];
          });
      return sum;
    }

    /** u.K u and u.M u without matrices. */
    std::pair<double, double> squares(const dealii::Vector<double> &field) const
    {
      ShellElement element(mapping, fe);
      std::vector<dealii::Vector<double>> local(1, dealii::Vector<double>(fe.n_dofs_per_cell()));
      std::pair<double, double> sum{0., 0.};
      for (const auto &cell : dof_handler.active_cell_iterators())
      {
        element.reinit(cell, material, section);
        cell->get_dof_values(field, local[0]);
        sum.first += element.stiffness_products(local)[0];
        sum.second += element.mass_products(local)[0];
      }
      return sum;
    }

    template <typename Use>
    void for_each_cell(const Use &use) const
    {
      ShellElement element(mapping, fe);
      const unsigned int size = fe.n_dofs_per_cell();
      dealii::FullMatrix<double> stiffness(size, size), mass(size, size);
      std::vector<dealii::types::global_dof_index> dofs(size);
      for (const auto &cell : dof_handler.active_cell_iterators())
      {
        element.reinit(cell, material, section);
        element.matrices(stiffness, mass);
        cell->get_dof_indices(dofs);
        use(dofs, stiffness, mass);
      }
    }

    /** Loads of a force per area. */
    std::vector<double>
    surface_load(const std::function<Tensor<1, 3>(const Point<3> &)> &force) const
    {
      dealii::FEValues<2, 3> values(mapping, fe.base_element(0), dealii::QGauss<2>(fe.degree + 1),
                                    dealii::update_values | dealii::update_quadrature_points |
                                        dealii::update_JxW_values);
      std::vector<double> loads(n_dofs(), 0.);
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
      {
        values.reinit(cell);
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (const auto [component, node] = fe.system_to_component_index(i); component < 3)
            for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
              loads[dofs[i]] += values.shape_value(node, q) *
                                force(values.quadrature_point(q))[component] * values.JxW(q);
      }
      return loads;
    }

    /** The degree of freedom of a component at a node. */
    unsigned int dof_at(const Point<3> &place, const unsigned int component) const
    {
      for (unsigned int dof = 0; dof < n_dofs(); ++dof)
        if (components[dof] == component && positions[dof].distance(place) < 1e-8 * place.norm())
          return dof;
      throw std::runtime_error("no node there");
    }

    /** The displacement under loads, where fixed(place)[component] shows what is constrained. */
    std::vector<double>
    solve(std::vector<double> loads,
          const std::function<std::array<bool, 6>(const Point<3> &)> &fixed) const
    {
      std::vector<bool> held(n_dofs());
      for (unsigned int dof = 0; dof < n_dofs(); ++dof)
        held[dof] = fixed(positions[dof])[components[dof]];
      SymmetricTriplets triplets;
      for_each_cell([&](const auto &dofs, const auto &stiffness, const auto &)
                    { triplets.add(dofs, stiffness, held); });
      for (unsigned int dof = 0; dof < n_dofs(); ++dof)
        if (held[dof])
        {
          triplets.add(dof, dof, 1.);
          loads[dof] = 0.;
        }
      SparseLDLT factors(n_dofs(), MPI_COMM_SELF);
      factors.factorise(triplets);
      EXPECT_EQ(factors.n_negative(), 0u);
      factors.solve(loads);
      return loads;
    }

    /** Position and component of a degree of freedom. */
    const Point<3> &position(const unsigned int dof) const { return positions[dof]; }
    unsigned int component(const unsigned int dof) const { return components[dof]; }

  private:
    void find_nodes()
    {
      positions.resize(n_dofs());
      dealii::DoFTools::map_dofs_to_support_points(mapping, dof_handler, positions);
      components.resize(n_dofs());
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          components[dofs[i]] = fe.system_to_component_index(i).first;
      }
    }

    dealii::Triangulation<2, 3> triangulation;
    const dealii::MappingQ<2, 3> mapping;
    const dealii::FESystem<2, 3> fe;
    dealii::DoFHandler<2, 3> dof_handler;
    const Material material;
    const ShellSection section;
    std::vector<Point<3>> positions;
    std::vector<unsigned int> components;
  };

  inline const Surface plane{[](const Point<2> &s) { return Point<3>(s[0], s[1], 0.); },
                             [](const Point<3> &x) { return Point<2>(x[0], x[1]); }};

  /** Around the x axis: parameters x and the angle from the top. */
  inline Surface cylinder(const double radius)
  {
    return {[radius](const Point<2> &s)
            { return Point<3>(s[0], radius * std::sin(s[1]), radius * std::cos(s[1])); },
            [](const Point<3> &x) { return Point<2>(x[0], std::atan2(x[1], x[2])); }};
  }

  /** Parameters: the angle about the z axis and the latitude. */
  inline Surface sphere(const double radius)
  {
    return {[radius](const Point<2> &s)
            {
              return Point<3>(radius * std::cos(s[1]) * std::cos(s[0]),
                              radius * std::cos(s[1]) * std::sin(s[0]), radius * std::sin(s[1]));
            },
            [](const Point<3> &x)
            { return Point<2>(std::atan2(x[1], x[0]), std::atan2(x[2], std::hypot(x[0], x[1]))); }};
  }

  inline bool zero(const double x)
  {
    return std::abs(x) < 1e-9;
  }
} // namespace ringmotor::tests
