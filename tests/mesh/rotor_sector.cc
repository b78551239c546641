// SPDX-License-Identifier: LGPL-2.1-or-later

// The generated sector of the rotor against the closed forms of its volume and of the areas of its
// faces, and an inner face of cells of properly decreasing size.

#include "support/geometry.h"

#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/rotor_sector.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  /** Area between two radii of a sector of an angle. */
  double annulus(const double inner, const double outer, const double angle)
  {
    return 0.5 * angle * (outer * outer - inner * inner);
  }

  RotorGeometry reference_rotor(const ElementKind flange)
  {
    RotorGeometry rotor;
    rotor.flange_element = flange;
    return rotor;
  }

  RotorGeometry other_rotor(const ElementKind flange)
  {
    RotorGeometry rotor     = reference_rotor(flange);
    rotor.ring_inner_radius = 28e-3;
    rotor.ring_outer_radius = 31e-3;
    rotor.ring_lower_face   = -1e-3;
    rotor.ring_upper_face   = 4e-3;
    rotor.flange_lower_face = 1e-3;
    rotor.flange_thickness  = 0.2e-3;
    rotor.lip_inner_radius  = 25e-3;
    rotor.lip_outer_radius  = 25.5e-3;
    return rotor;
  }
} // namespace

TEST(RotorSector, HasTheExactVolumeAndFaces)
{
  const unsigned int n_teeth = 45;
  for (const RotorGeometry &rotor :
       {reference_rotor(ElementKind::solid), other_rotor(ElementKind::solid)})
    for (const SectorForm form : {SectorForm::half, SectorForm::whole})
      for (const unsigned int level : {0u, 2u})
      {
        const SectorMesh mesh = make_rotor_sector(rotor_body(rotor, n_teeth), form,
                                                  RotorGrading::level(level), MPI_COMM_SELF);
        const double angle    = (form == SectorForm::half ? 1. : 2.) * M_PI / n_teeth;
        const double height   = rotor.ring_upper_face - rotor.ring_lower_face;
        const double ring     = rotor.ring_outer_radius - rotor.ring_inner_radius;
        const double flange   = rotor.ring_inner_radius - rotor.lip_inner_radius;
        EXPECT_NEAR(volumes(*mesh.triangulation, 6).at(ids::rotor) /
                        (height * annulus(rotor.ring_inner_radius, rotor.ring_outer_radius, angle) +
                         rotor.flange_thickness *
                             annulus(rotor.lip_inner_radius, rotor.ring_inner_radius, angle)),
                    1., 1e-10);
        std::map<dealii::types::boundary_id, double> area = boundary_areas(*mesh.triangulation, 6);
        EXPECT_NEAR(area[ids::lip] / annulus(rotor.lip_inner_radius, rotor.lip_outer_radius, angle),
                    1., 1e-10);
        EXPECT_NEAR(area[ids::ring_top] /
                        annulus(rotor.ring_inner_radius, rotor.ring_outer_radius, angle),
                    1., 1e-10);
        const double bore = angle * rotor.ring_inner_radius;
        EXPECT_NEAR(area[ids::radial_bars] / (bore * rotor.radial_bar_height), 1., 1e-10);
        EXPECT_NEAR(area[ids::ring_bore] /
                        (bore * (height - rotor.flange_thickness - rotor.radial_bar_height)),
                    1., 1e-10);
        const double section = ring * height + flange * rotor.flange_thickness;
        for (const auto id :
             form == SectorForm::half
                 ? std::array<dealii::types::boundary_id, 2>{{ids::mirror, ids::cut}}
                 : std::array<dealii::types::boundary_id, 2>{{ids::cut_low, ids::cut_high}})
          EXPECT_NEAR(area[id] / section, 1., 1e-10);
        EXPECT_GT(smallest_jacobian_ratio(*mesh.triangulation), 0.8);
      }
}

TEST(RotorSector, HasItsFlangeAsAShell)
{
  const unsigned int n_teeth = 45;
  for (const RotorGeometry &rotor :
       {reference_rotor(ElementKind::shell), other_rotor(ElementKind::shell)})
    for (const SectorForm form : {SectorForm::half, SectorForm::whole})
      for (const unsigned int level : {0u, 2u})
      {
        const SectorMesh mesh = make_rotor_sector(rotor_body(rotor, n_teeth), form,
                                                  RotorGrading::level(level), MPI_COMM_SELF);
        const double angle    = (form == SectorForm::half ? 1. : 2.) * M_PI / n_teeth;
        const double height   = rotor.ring_upper_face - rotor.ring_lower_face;
        const double root     = rotor.ring_inner_radius - 0.5 * rotor.flange_thickness;
        EXPECT_NEAR(volumes(*mesh.triangulation, 6).at(ids::rotor) /
                        (height * annulus(rotor.ring_inner_radius, rotor.ring_outer_radius, angle) +
                         rotor.flange_thickness * annulus(root, rotor.ring_inner_radius, angle)),
                    1., 1e-10);
        std::map<dealii::types::boundary_id, double> area = boundary_areas(*mesh.triangulation, 6);
        EXPECT_NEAR(area[ids::shell_root] / (angle * root * rotor.flange_thickness), 1., 1e-10);

        ASSERT_TRUE(mesh.shell);
        const dealii::MappingQ<2, 3> mapping(6);
        const dealii::QGauss<2> points(4);
        const dealii::FE_Nothing<2, 3> nothing;
        dealii::FEValues<2, 3> values(mapping, nothing, points,
                                      dealii::update_JxW_values | dealii::update_normal_vectors |
                                          dealii::update_quadrature_points);
        std::map<dealii::types::material_id, double> shell_area;
        for (const auto &cell : mesh.shell->active_cell_iterators())
        {
          values.reinit(cell);
          for (const unsigned int q : values.quadrature_point_indices())
          {
            shell_area[cell->material_id()] += values.JxW(q);
            EXPECT_NEAR(values.normal_vector(q)[2], 1., 1e-12);
            EXPECT_NEAR(values.quadrature_point(q)[2],
                        rotor.flange_lower_face + 0.5 * rotor.flange_thickness, 1e-12);
          }
          EXPECT_EQ(mesh.sections.at(cell->material_id()).thickness, rotor.flange_thickness);
        }
        EXPECT_NEAR(shell_area[ids::lip_shell] /
                        annulus(rotor.lip_inner_radius, rotor.lip_outer_radius, angle),
                    1., 1e-10);
        EXPECT_NEAR(shell_area[ids::rotor] / annulus(rotor.lip_outer_radius, root, angle), 1.,
                    1e-10);
        for (const auto &cell : mesh.shell->active_cell_iterators())
          for (const auto &edge : cell->face_iterators())
            if (edge->at_boundary() && edge->boundary_id() == ids::shell_root)
            {
              EXPECT_NEAR(std::hypot(edge->vertex(0)[0], edge->vertex(0)[1]), root, 1e-12);
            }
      }
}

TEST(RotorSector, ShrinksItsCellsTowardsTheFlangesEdges)
{
  const RotorGeometry rotor = reference_rotor(ElementKind::solid);
  for (const unsigned int level : {0u, 1u, 2u})
  {
    const SectorMesh mesh = make_rotor_sector(rotor_body(rotor, 90), SectorForm::half,
                                              RotorGrading::level(level), MPI_COMM_SELF);
    double nearest        = 1.; // below the flange
    for (const auto &x : mesh.triangulation->get_vertices())
      if (x[2] < rotor.flange_lower_face - 1e-9)
        nearest = std::min(nearest, rotor.flange_lower_face - x[2]);
    EXPECT_NEAR(nearest, 0.5 * rotor.flange_thickness * std::pow(0.3, level), 1e-12);
  }
}

TEST(LinesFromEdge, AreAGeometricSequenceOrEven)
{
  EXPECT_EQ(lines_from_edge(2., 3, 0.5), (std::vector<double>{0., 0.5, 1., 2.}));
  EXPECT_EQ(lines_from_edge(2., 4, 1.), (std::vector<double>{0., 0.5, 1., 1.5, 2.}));
  EXPECT_EQ(lines_from_edge(2., 1, 0.15), (std::vector<double>{0., 2.}));
}
