// SPDX-License-Identifier: LGPL-2.1-or-later

// Electrodes and equivalent circuits. Expected values: Fourier coefficients of arcs by hand; the
// response to a voltage with all harmonics and all modes, which the circuit of one mode must follow
// near the resonance; the losses of a stator of one loss factor.

#include "support/materials.h"
#include "support/paper_motor.h"

#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/motor/body_parts.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/wave/body_modes.h>
#include <ringmotor/wave/phase_circuit.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::numbers::PI;

namespace
{
  ElectrodeLayout layout_with(const Electrodes &electrodes, const unsigned int n_waves = 7)
  {
    Motor motor;
    motor.n_waves = n_waves;
    return ElectrodeLayout(electrodes, motor, 33e-3);
  }
} // namespace

// Alternating arcs of half a wave are a square wave over a part of the ring.
TEST(Electrodes, FourierCoefficients)
{
  Electrodes electrodes;
  electrodes.arc_gap           = 0.;
  const ElectrodeLayout layout = layout_with(electrodes);
  for (const Phase phase : {Phase::a, Phase::b})
  {
    EXPECT_EQ(layout.arcs(phase).size(), 6);
    EXPECT_NEAR(layout.coverage(phase), 3. / 7., 1e-12);
    EXPECT_NEAR(layout.mean_square(phase), 3. / 7., 1e-12);
    EXPECT_NEAR(layout.excitation(phase, 7), 4. / PI * 3. / 7., 1e-12);
    EXPECT_NEAR(layout.excitation(phase, 14), 0., 1e-12);
    EXPECT_NEAR(layout.excitation(phase, 21), 4. / (3. * PI) * 3. / 7., 1e-12);
    EXPECT_NEAR(layout.excitation(phase, 0), 0., 1e-12);
  }
  // a quarter of a wavelength apart
  const std::complex<double> ratio = layout.harmonic(Phase::b, 7) / layout.harmonic(Phase::a, 7);
  EXPECT_NEAR(std::abs(ratio), 1., 1e-12);
  EXPECT_NEAR(ratio.real(), 0., 1e-12);
  // phase A of one arc of half the ring: (1 - exp(-i k pi)) / (2 pi i k)
  electrodes.n_arcs_a = electrodes.n_arcs_b = 1;
  const ElectrodeLayout half                = layout_with(electrodes, 2);
  EXPECT_NEAR(half.harmonic(Phase::a, 0).real(), 0.25, 1e-12);
}

// With gaps the potential is a broken line: Parseval's sum of its harmonics.
TEST(Electrodes, SquaresAddUp)
{
  const ElectrodeLayout layout = layout_with({});
  double sum                   = 0.;
  for (int k = -4000; k <= 4000; ++k)
    sum += std::norm(layout.harmonic(Phase::a, k));
  EXPECT_NEAR(sum, layout.mean_square(Phase::a), 1e-6);
  EXPECT_LT(layout.coverage(Phase::a), 3. / 7.);
}

TEST(Electrodes, MustFitOnTheRing)
{
  Electrodes electrodes;
  electrodes.n_arcs_a = 9;
  EXPECT_THROW(layout_with(electrodes), UserError);
  electrodes         = {};
  electrodes.arc_gap = 0.02;
  EXPECT_THROW(layout_with(electrodes), UserError);
  electrodes                = {};
  electrodes.phase_distance = 1.25; // 6 + 1.25 of 7 waves
  EXPECT_THROW(layout_with(electrodes), UserError);
}

namespace
{
  class StatorPhases : public ::testing::Test
  {
  protected:
    StatorPhases()
        : mesh(make_sector(stator_body(parameters.stator, parameters.motor.n_teeth),
                           SectorForm::half, SectorGrading::level(0), MPI_COMM_SELF)),
          materials(material_table(parameters.materials, Body::stator,
                                   parameters.piezoelectricity.law())),
          sector(mesh, materials, 2), response(mesh, materials, 2),
          harmonics(ElectrodeLayout(parameters.electrodes, parameters.motor,
                                    mean_radius_of_ceramic(parameters)),
                    90)
    {
      ModeSolver solver(sector);
      wave     = solver.below(7, solver.shift_above(7, 1, 0.)).front();
      branches = motional_branches(harmonics, sector, wave, std::sqrt(wave.eigenvalue), 1., 1e3);
      const auto parallel = parallel_capacitances(harmonics, response, wave, branches);
      for (const unsigned int i : {0u, 1u})
        circuits[i] = {wave.frequency(), branches[i], parallel[i], 0.};
    }

    const Parameters parameters = paper_motor();
    const SectorMesh mesh;
    const MaterialTable materials;
    const CyclicSector sector;
    ElectricResponse response;
    const PhaseHarmonics harmonics;
    Mode wave;
    PerPhase<MotionalBranch> branches;
    PerPhase<PhaseCircuit> circuits;
  };
} // namespace

TEST_F(StatorPhases, CircuitFollowsTheResponse)
{
  for (PhaseCircuit &circuit : circuits)
    circuit.branch.resistance = 0.; // the response has no damping
  for (const double ratio : {0.985, 0.995, 0.999, 1.0005, 1.002, 1.006, 1.015})
  {
    const double f = ratio * wave.frequency(), omega = 2. * PI * f;
    const PerPhase<double> full = phase_capacitances(harmonics, response, omega * omega);
    for (const unsigned int i : {0u, 1u})
      EXPECT_NEAR(circuits[i].admittance(f).imag() / (omega * full[i]), 1., 1e-2) << ratio;
  }
}

// Where the charge per volt is zero
TEST_F(StatorPhases, OpenCircuitFrequency)
{
  const double expected = circuits[0].open_circuit_frequency();
  const auto charge     = [&](const double f)
  { return phase_capacitances(harmonics, response, std::pow(2. * PI * f, 2))[0]; };
  EXPECT_LT(charge(expected * (1. - 1e-5)), 0.);
  EXPECT_GT(charge(expected * (1. + 1e-5)), 0.);
  EXPECT_NEAR(circuits[0].coupling_squared(), 1. - std::pow(wave.frequency() / expected, 2), 1e-12);
}

// Both phases have the same arcs, at places that are no multiples of a pitch apart.
TEST_F(StatorPhases, PhasesAreAlike)
{
  EXPECT_NEAR(branches[1].force_factor / branches[0].force_factor, 1., 1e-3);
  EXPECT_NEAR(circuits[1].parallel.clamped / circuits[0].parallel.clamped, 1., 1e-3);
}

// A clamped phase is a plate capacitor, except for the fields at the gaps, which add some percent.
TEST_F(StatorPhases, ClampedCapacitance)
{
  const StatorGeometry &stator = parameters.stator;
  const ElectrodeLayout layout(parameters.electrodes, parameters.motor, 33e-3);
  const double area =
      layout.coverage(Phase::a) * PI *
      (std::pow(stator.base_outer_radius, 2) - std::pow(stator.base_inner_radius, 2));
  const double plate =
      parameters.piezoelectricity.permittivity33 * area / stator.piezoceramic_thickness;
  EXPECT_GT(circuits[0].parallel.clamped, plate);
  EXPECT_LT(circuits[0].parallel.clamped, 1.1 * plate);
}

// With the law e (1 - i tan_e), eps (1 - i tan_eps) the stiffness e^2/eps that a potential adds has
// the loss factor tan_eps - 2 tan_e.
TEST_F(StatorPhases, PiezoelectricLossOffsetsDielectricLoss)
{
  const auto quality = [&](const double dielectric, const double piezoelectric)
  {
    Piezoelectricity losses;
    losses.dielectric_loss_factor    = dielectric;
    losses.piezoelectric_loss_factor = piezoelectric;
    return stator_quality(sector, wave, materials, losses);
  };
  EXPECT_NEAR(quality(0.04, 0.02), quality(0., 0.), 1e-6 * quality(0., 0.));
  EXPECT_LT(quality(0.04, 0.), quality(0., 0.));
  EXPECT_GT(quality(0., 0.02), quality(0., 0.));
  MaterialTable lossless = materials;
  for (auto &[id, material] : lossless)
    material.loss_factor = 0.;
  Piezoelectricity losses;
  losses.dielectric_loss_factor    = 0.01;
  losses.piezoelectric_loss_factor = 0.01;
  EXPECT_THROW(stator_quality(sector, wave, lossless, losses), ComputationError);
}

TEST_F(StatorPhases, QualityOfOneLossFactor)
{
  MaterialTable lossy = materials;
  for (auto &[id, material] : lossy)
    material.loss_factor = 1e-3;
  Piezoelectricity losses;
  losses.dielectric_loss_factor    = 1e-3;
  losses.piezoelectric_loss_factor = 0.;
  EXPECT_NEAR(stator_quality(sector, wave, lossy, losses), 1000., 1e-6 * 1000.);
}
