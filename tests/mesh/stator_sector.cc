// SPDX-License-Identifier: LGPL-2.1-or-later

// The generated sector of the stator against its geometry: closed forms of the volumes (the area
// between a slot wall and theta = 0 is the integral of r (alpha/2 - asin(c/r)), c half the slot's
// width), plane slot walls, heights, and faces of exactly one kind each.

#include "support/geometry.h"

#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/mesh/ids.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;

namespace
{
  constexpr unsigned int n_teeth = 90;
  const double half_pitch        = M_PI / n_teeth;

  /** A stator that differs from the reference one in every dimension. */
  StatorGeometry other_stator()
  {
    StatorGeometry stator;
    stator.base_inner_radius      = 20e-3;
    stator.base_outer_radius      = 27e-3;
    stator.tip_inner_radius       = 21.5e-3;
    stator.tip_outer_radius       = 26e-3;
    stator.base_thickness         = 3e-3;
    stator.tooth_height           = 1.5e-3;
    stator.slot_width             = 0.4e-3;
    stator.piezoceramic_thickness = 0.3e-3;
    return stator;
  }

  /** Half a sector's volumes by material. */
  std::map<dealii::types::material_id, double> exact_volumes(const StatorGeometry &stator)
  {
    const double height = stator.base_thickness + stator.tooth_height;
    const auto radius   = [&](const double at_base, const double at_tip, const double z)
    { return at_base + z / height * (at_tip - at_base); };
    const auto inner = [&](const double z)
    { return radius(stator.base_inner_radius, stator.tip_inner_radius, z); };
    const auto outer = [&](const double z)
    { return radius(stator.base_outer_radius, stator.tip_outer_radius, z); };
    const double c       = 0.5 * stator.slot_width;
    const auto primitive = [&](const double r) {
      return 0.5 * (half_pitch * r * r - r * r * std::asin(c / r) - c * std::sqrt(r * r - c * c));
    };
    const auto ring_area = [&](const double z)
    { return 0.5 * half_pitch * (outer(z) * outer(z) - inner(z) * inner(z)); };
    const auto tooth_area = [&](const double z)
    { return primitive(outer(z)) - primitive(inner(z)); };
    return {{ids::piezoceramic, stator.piezoceramic_thickness * ring_area(0.)},
            {ids::base, integral(ring_area, 0., stator.base_thickness)},
            {ids::tooth, integral(tooth_area, stator.base_thickness, height)}};
  }

  void expect_volumes(const StatorGeometry &stator, const SectorForm form, const unsigned int level)
  {
    const SectorMesh mesh =
        make_sector(stator_body(stator, n_teeth), form, SectorGrading::level(level), MPI_COMM_SELF);
    const auto found = volumes(*mesh.triangulation, 6);
    for (const auto &[material, half_volume] : exact_volumes(stator))
    {
      if (half_volume == 0.)
      {
        EXPECT_EQ(found.count(material), 0u);
        continue;
      }
      const double exact = half_volume * (form == SectorForm::half ? 1. : 2.);
      EXPECT_NEAR(found.at(material) / exact, 1., 1e-11) << "material " << int(material);
    }
  }

  double angle(const Point<3> &x)
  {
    return std::atan2(x[1], x[0]);
  }
  double radius(const Point<3> &x)
  {
    return std::hypot(x[0], x[1]);
  }

  /** The theta component of a face's unit normal. */
  template <typename Face>
  double tangential_part_of_normal(const Face &face)
  {
    const dealii::Tensor<1, 3> normal =
        dealii::cross_product_3d(face.vertex(3) - face.vertex(0), face.vertex(2) - face.vertex(1));
    const Point<3> center = face.center();
    const dealii::Tensor<1, 3> e_theta({-center[1], center[0], 0.});
    return std::abs(normal * e_theta) / (normal.norm() * e_theta.norm());
  }
} // namespace

TEST(StatorSector, HasTheExactVolume)
{
  StatorGeometry bare         = StatorGeometry();
  bare.piezoceramic_thickness = 0.;
  for (const StatorGeometry &stator : {StatorGeometry(), other_stator(), bare})
    for (const SectorForm form : {SectorForm::half, SectorForm::whole})
      expect_volumes(stator, form, 0);
  expect_volumes(StatorGeometry(), SectorForm::half, 3);
}

TEST(StatorSector, HasParallelSlotWallsAndFlatTops)
{
  // Also at the midpoints that define quadratic cells: the faces are refined once.
  for (const StatorGeometry &stator : {StatorGeometry(), other_stator()})
    for (const SectorForm form : {SectorForm::half, SectorForm::whole})
    {
      SectorMesh mesh =
          make_sector(stator_body(stator, n_teeth), form, SectorGrading::level(1), MPI_COMM_SELF);
      mesh.triangulation->refine_global(1);
      const double top       = stator.base_thickness + stator.tooth_height;
      unsigned int n_on_wall = 0, n_on_top = 0;
      for (const auto &cell : mesh.triangulation->active_cell_iterators())
        if (cell->material_id() == ids::tooth)
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary())
              for (const unsigned int v : face->vertex_indices())
              {
                const Point<3> x = face->vertex(v);
                if (face->boundary_id() == ids::free && tangential_part_of_normal(*face) > 0.9)
                {
                  const double turn = half_pitch - std::abs(angle(x));
                  EXPECT_NEAR(radius(x) * std::sin(turn), 0.5 * stator.slot_width, 1e-14);
                  ++n_on_wall;
                }
                if (face->boundary_id() == ids::tooth_top)
                {
                  EXPECT_NEAR(x[2], top, 1e-15);
                  EXPECT_GT(radius(x), stator.tip_inner_radius * (1. - 1e-12));
                  EXPECT_LT(radius(x), stator.tip_outer_radius * (1. + 1e-12));
                  ++n_on_top;
                }
              }
      EXPECT_GT(n_on_wall, 20u);
      EXPECT_GT(n_on_top, 20u);
    }
}

namespace
{
  /** The faces of cuts and mirror plane are where their marks indicate. */
  void expect_marks_in_place(const SectorMesh &mesh)
  {
    const std::map<dealii::types::boundary_id, double> places{{ids::cut, half_pitch},
                                                              {ids::cut_high, half_pitch},
                                                              {ids::cut_low, -half_pitch},
                                                              {ids::mirror, 0.}};
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
      {
        const auto place = places.find(face->at_boundary() ? face->boundary_id()
                                                           : dealii::numbers::invalid_boundary_id);
        for (unsigned int v = 0; place != places.end() && v < face->n_vertices(); ++v)
          EXPECT_NEAR(angle(face->vertex(v)), place->second, 1e-14);
      }
  }
} // namespace

TEST(StatorSector, MarksAllFaces)
{
  // Areas of planes known by their closed forms: cut and mirror plane carry the trapezoids of the
  // cross-section (below the slots only, on the cut), the tooth top the area of a tooth.
  const StatorGeometry stator = other_stator();
  const double height         = stator.base_thickness + stator.tooth_height;
  const auto width            = [&](const double z)
  {
    return stator.base_outer_radius - stator.base_inner_radius -
           z / height *
               (stator.base_outer_radius - stator.base_inner_radius - stator.tip_outer_radius +
                stator.tip_inner_radius);
  };
  const double ceramic = width(0.) * stator.piezoceramic_thickness;
  const double below   = ceramic + integral(width, 0., stator.base_thickness);
  const double all     = ceramic + integral(width, 0., height);
  const double c       = 0.5 * stator.slot_width;
  const double top = integral([&](const double r) { return r * (half_pitch - std::asin(c / r)); },
                              stator.tip_inner_radius, stator.tip_outer_radius);
  const double bottom =
      0.5 * half_pitch *
      (std::pow(stator.base_outer_radius, 2) - std::pow(stator.base_inner_radius, 2));

  for (const SectorForm form : {SectorForm::half, SectorForm::whole})
  {
    const SectorMesh mesh =
        make_sector(stator_body(stator, n_teeth), form, SectorGrading::level(1), MPI_COMM_SELF);
    std::map<dealii::types::boundary_id, double> area = boundary_areas(*mesh.triangulation, 6);
    if (form == SectorForm::half)
    {
      EXPECT_EQ(area.size(), 5u);
      EXPECT_NEAR(area[ids::bottom] / bottom, 1., 1e-11);
      EXPECT_NEAR(area[ids::mirror] / all, 1., 1e-11);
      EXPECT_NEAR(area[ids::cut] / below, 1., 1e-11);
      EXPECT_NEAR(area[ids::tooth_top] / top, 1., 1e-11);
    }
    else
    {
      EXPECT_EQ(area.size(), 5u);
      EXPECT_NEAR(area[ids::bottom] / (2. * bottom), 1., 1e-11);
      EXPECT_NEAR(area[ids::cut_low] / below, 1., 1e-11);
      EXPECT_NEAR(area[ids::cut_high] / below, 1., 1e-11);
      EXPECT_NEAR(area[ids::tooth_top] / (2. * top), 1., 1e-11);
    }
    expect_marks_in_place(mesh);
  }
}

TEST(StatorSector, IsGradedTowardsTheSlotRoot)
{
  // n layers with ratio q: the cell at the root measures q^n half slots, in height and across.
  const StatorGeometry stator;
  for (const unsigned int n_layers : {0u, 1u, 3u})
  {
    const SectorMesh mesh = make_sector(stator_body(stator, n_teeth), SectorForm::half,
                                        {n_layers, 2, 0.25}, MPI_COMM_SELF);
    double lowest         = 1.; // height above the slot root of the next vertex
    for (const Point<3> &x : mesh.triangulation->get_vertices())
      if (x[2] > stator.base_thickness + 1e-12)
        lowest = std::min(lowest, x[2] - stator.base_thickness);
    EXPECT_NEAR(lowest, 0.5 * stator.slot_width * std::pow(0.25, n_layers), 1e-12);
  }
}

TEST(StatorSector, HasCellsThatCanBeSlender)
{
  // Many teeth, narrow and wide slots: Jacobians remain positive everywhere. A trapezoid at the
  // root is five times narrower on its inner side.
  StatorGeometry stator;
  for (const double slot_width : {0.05e-3, 1.9e-3})
    for (const unsigned int teeth : {3u, 12u, 90u})
    {
      stator.slot_width = slot_width;
      for (const unsigned int level : {0u, 2u})
      {
        const SectorMesh mesh = make_sector(stator_body(stator, teeth), SectorForm::whole,
                                            SectorGrading::level(level), MPI_COMM_SELF);
        EXPECT_GT(smallest_jacobian_ratio(*mesh.triangulation), 0.1)
            << teeth << " teeth, slots of " << slot_width << " m";
      }
    }
}

TEST(RevolvedManifold, GoesThereAndBack)
{
  const RevolvedManifold<3> manifold(stator_body(other_stator(), n_teeth).slots);
  for (const double r : {15e-3, 22e-3, 40e-3}) // also where there are no teeth
    for (const double s : {-2., -1.3, -0.4, 0., 0.7, 1.6, 2.})
      for (const double z : {-0.3e-3, 0., 2e-3, 4.5e-3})
      {
        const Point<3> chart(r, s, z), back = manifold.pull_back(manifold.push_forward(chart));
        EXPECT_NEAR(back[0], r, 1e-15);
        EXPECT_NEAR(back[1], s, 1e-12);
        EXPECT_NEAR(back[2], z, 1e-15);
      }
}
