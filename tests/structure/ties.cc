// SPDX-License-Identifier: LGPL-2.1-or-later

// Shells tied to solids. A straight strip whose first half is solid and whose second half is a
// shell has the exact energies of uniform stretch and uniform bending (nu = 0, beam theory is
// exact), as has a block with a skin, whether their meshes match or not; as a cantilever it bends
// and stretches as in beam theory. A solid that is finer than the edge of the shell is refused.

#include <ringmotor/mesh/ids.h>
#include <ringmotor/structure/cyclic_factors.h>
#include <ringmotor/structure/motion_products.h>

#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace ringmotor;
using dealii::Point;

namespace
{
  constexpr double length = 1., width = 0.3, thickness = 0.1;
  const Material material{2e5, 0., 8., 0.}, skin_material{7e4, 0., 3., 0.};
  const MaterialTable materials{{ids::base, material}, {ids::piezoceramic, skin_material}};

  /** A part of the plane z = @p height in equal rectangles, as the mesh's shell. */
  void add_rectangles(SectorMesh &mesh, const double from, const double to, const double height,
                      const unsigned int n_along, const unsigned int n_across,
                      const dealii::types::material_id material_id)
  {
    std::vector<Point<3>> vertices;
    std::vector<dealii::CellData<2>> cells;
    for (unsigned int i = 0; i <= n_along; ++i)
      for (unsigned int j = 0; j <= n_across; ++j)
      {
        vertices.emplace_back(from + i * (to - from) / n_along, j * width / n_across, height);
        if (i < n_along && j < n_across)
        {
          const unsigned int corner = i * (n_across + 1) + j;
          dealii::CellData<2> cell;
          cell.vertices    = {corner, corner + n_across + 1, corner + 1, corner + n_across + 2};
          cell.material_id = material_id;
          cells.push_back(cell);
        }
      }
    add_shell(mesh, vertices, cells);
  }

  /** A solid block from x = 0 to 1, marked where @p mark says so. */
  template <typename Mark>
  SectorMesh block(const unsigned int n_along, const unsigned int n_across, const Mark &mark)
  {
    SectorMesh mesh;
    mesh.triangulation = empty_triangulation<3>(MPI_COMM_WORLD);
    mesh.form          = SectorForm::whole;
    mesh.has_cuts      = false;
    dealii::GridGenerator::subdivided_hyper_rectangle(*mesh.triangulation, {n_along, n_across, 2},
                                                      Point<3>(0., 0., -0.5 * thickness),
                                                      Point<3>(length, width, 0.5 * thickness));
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
    {
      cell->set_material_id(ids::base);
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          face->set_boundary_id(mark(face->center()));
    }
    return mesh;
  }

  /** The strip, solid up to x = 1 and a shell from there to x = 2. */
  SectorMesh strip(const unsigned int n_solid, const unsigned int n_shell)
  {
    SectorMesh mesh = block(
        2, n_solid,
        [](const Point<3> &x) {
          return x[0] > length - 1e-9 ? ids::shell_root : x[0] < 1e-9 ? ids::clamped : ids::free;
        });
    add_rectangles(mesh, length, 2. * length, 0., 2, n_shell, ids::base);
    for (const auto &cell : mesh.shell->active_cell_iterators())
      for (const auto &edge : cell->face_iterators())
        if (edge->at_boundary() && edge->center()[0] < length + 1e-9)
          edge->set_boundary_id(ids::shell_root);
    mesh.sections[ids::base] = {thickness, 0.};
    return mesh;
  }

  void release(SectorMesh &mesh)
  {
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == ids::clamped)
          face->set_boundary_id(ids::free);
  }

  using Motion = std::function<NodeMotion(const Point<3> &)>;

  const Motion stretch = [](const Point<3> &x) { return NodeMotion{{{x[0], 0., 0.}}, {}}; };
  /** Unit curvature about the y axis: w = x^2/2, u = -x z. */
  const Motion bend = [](const Point<3> &x) {
    return NodeMotion{{{-x[0] * x[2], 0., 0.5 * x[0] * x[0]}}, {{0., -x[0], 0.}}};
  };
  /** A rigid rotation about an axis through the origin. */
  const Motion turn = [](const Point<3> &x)
  {
    const dealii::Tensor<1, 3> axis({0.3, -0.5, 0.7});
    const dealii::Tensor<1, 3> u = dealii::cross_product_3d(axis, x);
    return NodeMotion{{{u[0], u[1], u[2]}}, {{axis[0], axis[1], axis[2]}}};
  };

  /** u.K u of the motion that takes these values at the unconstrained nodes. */
  double energy_product(const SectorMesh &mesh, const Motion &motion, const unsigned int degree)
  {
    const SectorElements elements(mesh, materials, degree);
    std::array<dealii::Vector<double>, 2> fields{
        {dealii::Vector<double>(elements.n_dofs()), dealii::Vector<double>(elements.n_dofs())}};
    elements.nodes().interpolate(motion, fields[0], fields[1]);
    const SectorMotion moved = elements.to_motion(fields);
    return motion_products(elements, {&moved}).front().total_stiffness();
  }

  constexpr double inertia = width * thickness * thickness * thickness / 12.;

  /** The displacement of the cantilever's end x = 2 in the direction of a unit force there. */
  double compliance(const SectorMesh &mesh, const unsigned int direction)
  {
    const CyclicSector sector(mesh, materials, 3);
    CyclicFactors factors(sector);
    factors.factorise(0, 0.);
    SectorMotion forces = sector.at_rest();
    const auto &fe      = sector.shell_dofs().get_fe();
    const dealii::QGauss<1> points(4);
    dealii::FEFaceValues<2, 3> values(sector.shell_geometry(), fe, points,
                                      dealii::update_values | dealii::update_JxW_values);
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : sector.shell_dofs().active_cell_iterators())
      for (const unsigned int edge : cell->face_indices())
        if (cell->face(edge)->at_boundary() && cell->face(edge)->center()[0] > 2. * length - 1e-9)
        {
          values.reinit(cell, edge);
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (fe.system_to_component_index(i).first == direction)
              for (const unsigned int q : values.quadrature_point_indices())
                forces.shell.real[dofs[i]] += values.shape_value(i, q) * values.JxW(q) / width;
        }
    std::vector<double> unknowns = sector.loads_of(0, forces);
    factors.solve(unknowns);
    return sector.expand(0, unknowns).shell.real * forces.shell.real;
  }
} // namespace

TEST(Ties, PassUniformStates)
{
  for (const auto &[n_solid, n_shell] : {std::pair(2u, 2u), std::pair(2u, 3u), std::pair(1u, 3u)})
  {
    SectorMesh mesh = strip(n_solid, n_shell);
    release(mesh);
    for (const unsigned int degree : {2u, 3u})
    {
      const double e = material.young_modulus;
      EXPECT_NEAR(energy_product(mesh, stretch, degree) / (e * width * thickness * 2. * length), 1.,
                  1e-9);
      EXPECT_NEAR(energy_product(mesh, bend, degree) / (e * inertia * 2. * length), 1., 1e-9);
      EXPECT_LT(energy_product(mesh, turn, degree), 1e-20 * e);
    }
  }
}

TEST(Ties, CarryACantilever)
{
  // Timoshenko's shear correction is 6e-4 of the total here.
  const SectorMesh mesh = strip(2, 2);
  const double span = 2. * length, e = material.young_modulus, area = width * thickness;
  EXPECT_NEAR(compliance(mesh, 0) / (span / (e * area)), 1., 1e-9);
  EXPECT_NEAR(compliance(mesh, 2) /
                  (span * span * span / (3. * e * inertia) + 1.2 * span / (0.5 * e * area)),
              1., 2e-3);
  EXPECT_NEAR(compliance(strip(1, 3), 2) / compliance(mesh, 2), 1., 2e-3);
}

TEST(Ties, RefuseASolidThatIsFinerThanTheShell)
{
  for (const auto &[n_solid, n_shell] : {std::pair(2u, 1u), std::pair(3u, 2u), std::pair(4u, 2u)})
  {
    const SectorMesh mesh = strip(n_solid, n_shell);
    EXPECT_THROW(SectorElements(mesh, materials, 3), dealii::ExceptionBase)
        << n_solid << " " << n_shell;
  }
}

TEST(Skins, PassUniformStates)
{
  const double skin = 0.02, offset = -0.5 * skin;
  for (const auto &[n_along, n_across] : {std::pair(2u, 3u), std::pair(4u, 6u), std::pair(3u, 2u)})
  {
    SectorMesh mesh = block(2, 3,
                            [](const Point<3> &x)
                            { return x[2] < 1e-9 - 0.5 * thickness ? ids::skin : ids::free; });
    add_rectangles(mesh, 0., length, -0.5 * thickness, n_along, n_across, ids::piezoceramic);
    mesh.sections[ids::piezoceramic] = {skin, offset};
    const double e = material.young_modulus, e_skin = skin_material.young_modulus;
    EXPECT_NEAR(energy_product(mesh, stretch, 2) /
                    ((e * thickness + e_skin * skin) * width * length),
                1., 1e-9);
    const double z = offset - 0.5 * thickness;
    EXPECT_NEAR(
        energy_product(mesh, bend, 2) /
            ((e * inertia + e_skin * width * (std::pow(skin, 3) / 12. + skin * z * z)) * length),
        1., 1e-9);
    EXPECT_LT(energy_product(mesh, turn, 2), 1e-20 * e);
  }
}

TEST(Shells, HaveTheirNormalsUp)
{
  // Described clockwise and anticlockwise, in any order.
  SectorMesh mesh;
  mesh.triangulation = empty_triangulation<3>(MPI_COMM_SELF);
  const std::vector<Point<3>> vertices{{1., 0., 0.}, {2., 0., 0.}, {1., 1., 0.},
                                       {2., 1., 0.}, {3., 0., 0.}, {3., 1., 0.}};
  std::vector<dealii::CellData<2>> cells(2);
  cells[0].vertices = {0, 2, 1, 3};
  cells[1].vertices = {5, 4, 3, 1};
  add_shell(mesh, vertices, cells);
  for (const auto &cell : mesh.shell->active_cell_iterators())
    EXPECT_GT(dealii::cross_product_3d(cell->vertex(1) - cell->vertex(0),
                                       cell->vertex(2) - cell->vertex(0))[2],
              0.);
}
