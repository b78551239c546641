// SPDX-License-Identifier: LGPL-2.1-or-later

// The compliance of a rotor's lip over a whole sector: half and whole sector have different
// matrices for the same body and must give the same result, and a compliance is Hermitian.

#include "support/materials.h"

#include <ringmotor/condensation/cut_responses.h>
#include <ringmotor/contact/ring_compliance.h>
#include <ringmotor/mesh/rotor_sector.h>
#include <ringmotor/structure/surface_load.h>

#include <deal.II/base/table.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;
using Complex       = std::complex<double>;
using ComplexMatrix = dealii::Table<2, Complex>;

namespace
{
  /** The condensed lip of a rotor; loads on the ring constrain rigid motions. */
  struct Lip
  {
    SectorMesh mesh;
    CyclicSector sector;
    ContactSurface meshed;
    SectorSurface surface;
    std::unique_ptr<Condensation> condensation;

    Lip(const RotorGeometry &rotor, const SectorForm form)
        : mesh(make_rotor_sector(rotor_body(rotor, 90), form, {}, MPI_COMM_WORLD, {2, 1})),
          sector(mesh, {{ids::rotor, steel}, {ids::lip_shell, steel}}, 2),
          meshed(rotor.flange_element == ElementKind::solid
                     ? solid_surface(sector, ids::lip)
                     : shell_surface(sector, ids::lip_shell)),
          surface(whole_surface(meshed, form))
    {
      std::vector<CondensationSupport> supports;
      for (const bool turns : {false, true})
        for (const unsigned int part : {0u, 1u})
        {
          // The half sector's real field rises, its imaginary field turns; both fields of the whole
          // sector do both.
          if (form == SectorForm::half && part != (turns ? 1 : 0))
            continue;
          const Complex phase     = part == 0 ? Complex(1.) : Complex(0., 1.);
          const Traction traction = [&](const Point<3> &x)
          {
            const double r = std::hypot(x[0], x[1]);
            return turns ? std::array<Complex, 3>{{-phase * x[1] / r, phase * x[0] / r, 0.}}
                         : std::array<Complex, 3>{{0., 0., phase}};
          };
          const auto load = sector.from_forces(
              face_load(sector, turns ? ids::ring_bore : ids::ring_top, traction))[part];
          supports.push_back({part, {}});
          for (unsigned int dof = 0; dof < load.size(); ++dof)
            if (load[dof] != 0.)
              supports.back().load.emplace_back(dof, load[dof] / load.l1_norm());
        }
      condensation = std::make_unique<Condensation>(sector, displacement_forms(meshed),
                                                    std::vector<SectorNodes::Dof>(), supports, 0.);
    }

    /** The supports that must be constrained for k waves. */
    std::vector<unsigned int> held(const unsigned int k) const
    {
      std::vector<unsigned int> held(k > 1 ? 0 : mesh.form == SectorForm::half ? 2 : 4);
      std::iota(held.begin(), held.end(), 0);
      return held;
    }

    /** For one wave, by rows, three per node. */
    ComplexMatrix compliance(const unsigned int k) const
    {
      const InterfaceCompliance interface(*condensation);
      const SurfaceCompliance body               = sector_compliance(interface, surface.origin);
      const dealii::FullMatrix<double> by_shapes = interface.through_cut(k, held(k));
      const unsigned int n = body.at_rest.m(), n_shapes = body.shapes.n();
      const auto phase = [&](const unsigned int shape)
      { return shape < body.n_real_shapes ? Complex(1.) : Complex(0., 1.); };
      ComplexMatrix shapes(n, n_shapes), half(n, n_shapes), compliance(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n_shapes; ++j)
          shapes(i, j) = phase(j) * body.shapes(i, j);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n_shapes; ++j)
          for (unsigned int l = 0; l < n_shapes; ++l)
            half(i, j) += shapes(i, l) * by_shapes(l, j);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
        {
          compliance(i, j) = body.at_rest(i, j);
          for (unsigned int l = 0; l < n_shapes; ++l)
            compliance(i, j) += half(i, l) * std::conj(shapes(j, l));
        }
      return compliance;
    }
  };

  unsigned int node_at(const ContactSurface &surface, const Point<2> &place)
  {
    for (unsigned int i = 0; i < surface.nodes.size(); ++i)
      if (surface.nodes[i].place.distance(place) < 1e-9)
        return i;
    throw std::runtime_error("no node there");
  }
} // namespace

class SectorCompliance : public testing::TestWithParam<ElementKind>
{
};

TEST_P(SectorCompliance, IsTheSameOfHalfAndWholeSector)
{
  RotorGeometry rotor;
  rotor.flange_element       = GetParam();
  rotor.radial_bar_stiffness = 0.;
  const Lip half(rotor, SectorForm::half), whole(rotor, SectorForm::whole);
  const unsigned int n = whole.surface.surface.nodes.size();
  ASSERT_EQ(half.surface.surface.nodes.size(), n);
  std::vector<unsigned int> partner;
  for (const SurfaceNode &node : half.surface.surface.nodes)
    partner.push_back(node_at(whole.surface.surface, node.place));
  for (const unsigned int k : {0u, 1u, 2u, 7u, 45u})
  {
    const ComplexMatrix of_half = half.compliance(k), of_whole = whole.compliance(k);
    double difference = 0., skew = 0.;
    for (unsigned int i = 0; i < 3 * n; ++i)
      for (unsigned int j = 0; j < 3 * n; ++j)
      {
        const unsigned int a = 3 * partner[i / 3] + i % 3, b = 3 * partner[j / 3] + j % 3;
        const double scale = std::sqrt((of_whole(a, a) * of_whole(b, b)).real());
        difference         = std::max(difference, std::abs(of_half(i, j) - of_whole(a, b)) / scale);
        skew = std::max(skew, std::abs(of_half(i, j) - std::conj(of_half(j, i))) / scale);
      }
    EXPECT_LT(difference, 1e-9) << k;
    EXPECT_LT(skew, 1e-12) << k;
  }
}

TEST_P(SectorCompliance, FollowsForAllWavesFromSolutionsForFew)
{
  RotorGeometry rotor;
  rotor.flange_element       = GetParam();
  rotor.radial_bar_stiffness = 0.;
  for (const SectorForm form : {SectorForm::half, SectorForm::whole})
  {
    const Lip lip(rotor, form);
    const InterfaceCompliance interface(*lip.condensation);
    const CutResponses responses(interface, [&](const unsigned int k) { return lip.held(k); });
    EXPECT_LT(responses.solved().size(), 10u);
    for (const unsigned int k : {0u, 1u, 2u, 5u, 7u, 12u, 20u, 33u, 44u, 45u})
    {
      const dealii::FullMatrix<double> exact = interface.through_cut(k, lip.held(k));
      dealii::FullMatrix<double> difference  = responses.at(k);
      difference.add(-1., exact);
      EXPECT_LT(difference.frobenius_norm(), 1e-8 * exact.frobenius_norm()) << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Flange, SectorCompliance,
                         testing::Values(ElementKind::solid, ElementKind::shell),
                         [](const auto &info)
                         { return info.param == ElementKind::solid ? "Solid" : "Shell"; });
