// SPDX-License-Identifier: LGPL-2.1-or-later

// The generated sector of the rotor against the closed forms of its volume and of the areas of its
// faces, and an inner face of cells that shrink as they should.

#include "support/geometry.h"

#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/rotor_sector.h>

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

  RotorGeometry other_rotor()
  {
    RotorGeometry rotor;
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
  for (const RotorGeometry &rotor : {RotorGeometry(), other_rotor()})
    for (const SectorForm form : {SectorForm::half, SectorForm::whole})
      for (const unsigned int level : {0u, 2u})
      {
        const SectorMesh mesh = make_rotor_sector(rotor, n_teeth, form, level, MPI_COMM_SELF);
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
        EXPECT_NEAR(area[ids::ring_bore] /
                        (angle * rotor.ring_inner_radius * (height - rotor.flange_thickness)),
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

TEST(RotorSector, ShrinksItsCellsTowardsTheFlangesEdges)
{
  const RotorGeometry rotor;
  for (const unsigned int level : {0u, 1u, 2u})
  {
    const SectorMesh mesh = make_rotor_sector(rotor, 90, SectorForm::half, level, MPI_COMM_SELF);
    double nearest        = 1.; // below the flange
    for (const auto &x : mesh.triangulation->get_vertices())
      if (x[2] < rotor.flange_lower_face - 1e-9)
        nearest = std::min(nearest, rotor.flange_lower_face - x[2]);
    EXPECT_NEAR(nearest, 0.5 * rotor.flange_thickness * std::pow(0.3, level), 1e-12);
  }
}
