// SPDX-License-Identifier: LGPL-2.1-or-later

// The tooth alone, the ceramic ring as a shell, the target plates. A long slender tooth is a
// cantilever: f = 1.8751^2 / (2 pi L^2) sqrt(E I / (rho A)), which shear and rotary inertia lower
// by about (1 + E/(kG)) / 2 times (1.8751 r / L)^2 ..., r the radius of gyration. The shell of
// ceramic against solid cells. Plates shift the frequency as Rayleigh's quotient predicts with the
// mode without them: d(omega^2) = (K - omega^2 M) of the plates over M of the stator.

#include "support/materials.h"
#include "support/paper_motor.h"

#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/motor/body_parts.h>
#include <ringmotor/pictures/sector_field.h>
#include <ringmotor/pictures/surface_trace.h>
#include <ringmotor/wave/body_modes.h>
#include <ringmotor/wave/frequency_shift.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace ringmotor;
using namespace ringmotor::tests;
using dealii::Point;

namespace
{
  constexpr unsigned int n_teeth = 90, n_waves = 7;

  Mode working_mode(const CyclicSector &sector)
  {
    ModeSolver solver(sector);
    return solver.below(n_waves, solver.shift_above(n_waves, 1, 0.)).front();
  }
} // namespace

TEST(Tooth, IsACantilever)
{
  StatorGeometry stator;
  stator.base_inner_radius = stator.tip_inner_radius = 30.e-3;
  stator.base_outer_radius = stator.tip_outer_radius = 30.5e-3;
  stator.tooth_height                                = 20.e-3;
  const SectorMesh mesh =
      make_tooth(stator_body(stator, n_teeth), SectorGrading::level(2), MPI_COMM_WORLD);
  const CyclicSector sector(mesh, stator_materials(), 3);
  std::vector<double> frequencies;
  for (const Mode &mode : ModeSolver(sector).lowest(0, 3))
  {
    EXPECT_FALSE(mode.rigid);
    frequencies.push_back(mode.frequency());
  }
  std::sort(frequencies.begin(), frequencies.end());

  const Material metal = Materials().stator_metal;
  const auto beam      = [&](const double depth)
  {
    const double length = stator.tooth_height, gyration = depth / std::sqrt(12.);
    return std::pow(1.8751, 2) / (2. * M_PI * length * length) * gyration *
           std::sqrt(metal.young_modulus / metal.density);
  };
  // Radially it is 0.5 mm thick; around the ring as wide as the pitch minus the slot, in the
  // middle.
  EXPECT_NEAR(frequencies[0] / beam(0.5e-3), 1., 0.005);
  const double width = 2. * 30.25e-3 * M_PI / n_teeth - stator.slot_width;
  EXPECT_NEAR(frequencies[1] / beam(width), 1., 0.02);
  EXPECT_LT(frequencies[1], beam(width));
}

TEST(CeramicShell, HasTheFrequencyOfTheSolidRing)
{
  StatorGeometry solid, shell;
  shell.piezoceramic_element = ElementKind::shell;
  double frequency[2];
  unsigned int n_dofs[2];
  for (unsigned int i = 0; i < 2; ++i)
  {
    const SectorMesh mesh = make_sector(stator_body(i == 0 ? solid : shell, n_teeth),
                                        SectorForm::half, SectorGrading::level(2), MPI_COMM_WORLD);
    const CyclicSector sector(mesh, stator_materials(), 3);
    frequency[i] = working_mode(sector).frequency();
    n_dofs[i]    = sector.n_dofs();
  }
  EXPECT_NEAR(frequency[1] / frequency[0], 1., 3e-3);
  EXPECT_LT(n_dofs[1], n_dofs[0]);
}

TEST(CeramicShell, IsDrawnWithItsThickness)
{
  StatorGeometry stator;
  stator.piezoceramic_element = ElementKind::shell;
  for (const SectorForm form : {SectorForm::half, SectorForm::whole})
  {
    const SectorMesh mesh =
        make_sector(stator_body(stator, n_teeth), form, SectorGrading::level(0), MPI_COMM_WORLD);
    const CyclicSector sector(mesh, stator_materials(), 2);
    const Mode mode = working_mode(sector);

    // Its corners reach from z = 0 down, and it moves with the base where they touch.
    double lowest = 0., highest = -1.;
    std::map<std::array<long, 3>, std::array<std::complex<double>, 3>> base_motion;
    const auto place = [](const Point<3> &x)
    {
      return std::array<long, 3>{
          {std::lround(1e9 * x[0]), std::lround(1e9 * x[1]), std::lround(1e9 * x[2])}};
    };
    const SectorField field = sample_sector(sector, mode, 2);
    for (const SectorField::Cell &cell : field.cells)
      if (cell.material == ids::base)
        for (unsigned int i = 0; i < cell.points.size(); ++i)
          base_motion[place(cell.points[i])] = cell.displacement[i];
    unsigned int n_shared = 0;
    for (const SectorField::Cell &cell : field.cells)
      if (cell.material == ids::piezoceramic)
        for (unsigned int i = 0; i < cell.points.size(); ++i)
        {
          lowest  = std::min(lowest, cell.points[i][2]);
          highest = std::max(highest, cell.points[i][2]);
          if (const auto base = base_motion.find(place(cell.points[i]));
              base != base_motion.end() && std::abs(cell.points[i][2]) < 1e-12)
          {
            ++n_shared;
            for (unsigned int d = 0; d < 3; ++d)
              EXPECT_LT(std::abs(cell.displacement[i][d] - base->second[d]),
                        1e-6 * std::abs(base->second[2]) + 1e-9);
          }
        }
    EXPECT_NEAR(lowest, -stator.piezoceramic_thickness, 1e-12);
    EXPECT_NEAR(highest, 0., 1e-12);
    EXPECT_GT(n_shared, 20u);

    const SurfaceTrace bottom = surface_trace(sector, mode, Surface::bottom);
    EXPECT_GT(bottom.n_faces, 0u);
    for (const Point<3> &x : bottom.points)
      EXPECT_NEAR(x[2], -stator.piezoceramic_thickness, 1e-12);
  }
}

TEST(TargetPlates, ShiftTheFrequencyAsRayleighSays)
{
  const Materials materials;
  const double area = 1e-7; // m^2
  const BarSection plate{area * materials.target_plate.young_modulus,
                         area * materials.target_plate.density};
  SectorMesh mesh = make_sector(stator_body(StatorGeometry(), n_teeth), SectorForm::half,
                                SectorGrading::level(1), MPI_COMM_WORLD);
  const CyclicSector without(mesh, stator_materials(), 3);
  const Mode mode = working_mode(without);

  // The plates' energies in the mode without them, by quadrature along the outer edges of the tooth
  // tops.
  double stiffness = 0., mass = 0.;
  const unsigned int degree = without.dofs().get_fe().degree;
  const dealii::QGauss<1> points(degree + 1);
  const dealii::FEValuesExtractors::Vector displacement(0);
  for (const auto &cell : without.dofs().active_cell_iterators())
    for (const unsigned int line : cell->line_indices())
      if (cell->line(line)->boundary_id() == ids::target_plate)
      {
        const Point<3> start = dealii::GeometryInfo<3>::unit_cell_vertex(
                           dealii::GeometryInfo<3>::line_to_cell_vertices(line, 0)),
                       end = dealii::GeometryInfo<3>::unit_cell_vertex(
                           dealii::GeometryInfo<3>::line_to_cell_vertices(line, 1));
        std::vector<Point<3>> on_line;
        for (const Point<1> &point : points.get_points())
          on_line.push_back(start + point[0] * (end - start));
        dealii::FEValues<3> values(
            without.geometry(), without.dofs().get_fe(), dealii::Quadrature<3>(on_line),
            dealii::update_values | dealii::update_gradients | dealii::update_jacobians);
        values.reinit(cell);
        std::vector<dealii::Tensor<1, 3>> u(points.size());
        std::vector<dealii::Tensor<2, 3>> gradient(points.size());
        for (const auto *field : {&mode.motion.solid.real, &mode.motion.solid.imaginary})
        {
          values[displacement].get_function_values(*field, u);
          values[displacement].get_function_gradients(*field, gradient);
          for (unsigned int q = 0; q < points.size(); ++q)
          {
            const dealii::Tensor<1, 3> along =
                dealii::apply_transformation(values.jacobian(q), end - start);
            const double length                = along.norm() * points.weight(q);
            const dealii::Tensor<1, 3> tangent = along / along.norm();
            stiffness +=
                plate.axial_stiffness * length * std::pow(tangent * (gradient[q] * tangent), 2);
            mass += plate.mass_per_length * length * u[q].norm_square();
          }
        }
      }
  const double expected = 0.5 * (stiffness / mode.eigenvalue - mass);
  ASSERT_LT(expected, -1e-4);
  MotorModel model;
  model.target_plates = plate;
  EXPECT_NEAR(frequency_shift(without, mode, model) / expected, 1., 1e-6);

  add_to_stator(model, mesh);
  const CyclicSector with(mesh, stator_materials(), 3);
  EXPECT_EQ(with.n_dofs(), without.n_dofs());
  EXPECT_NEAR((working_mode(with).frequency() / mode.frequency() - 1.) / expected, 1., 0.05);
}

TEST(TargetPlates, TakePartWhereTheyAreCalledFor)
{
  std::vector<double> frequencies;
  for (const EffectChoice choice : {EffectChoice::off, EffectChoice::on})
  {
    Parameters parameters                 = paper_motor();
    parameters.accuracy.mode              = AccuracyMode::fixed;
    parameters.accuracy.polynomial_degree = 2;
    parameters.effects["Target plates"]   = choice;
    BodyModes body(parameters, MPI_COMM_WORLD);
    body.find([](const Pass &) {});
    EXPECT_EQ(body.search().sector().sector_mesh().bars.size(), choice == EffectChoice::on ? 1 : 0);
    frequencies.push_back(body.search().working_mode(n_waves)->mode.frequency());
  }
  EXPECT_LT(frequencies[1], frequencies[0]);
}

TEST(Felt, ShiftsTheFrequencyAsRayleighSays)
{
  // A felt that follows the lower side stores half of its stiffness times the square of the normal
  // motion; the mode has unit mass in its sector.
  MotorModel model;
  model.felt_stiffness = 5e8; // N/m^3
  for (const ElementKind ceramic : {ElementKind::solid, ElementKind::shell})
  {
    StatorGeometry stator;
    stator.piezoceramic_element = ceramic;
    SectorMesh mesh             = make_sector(stator_body(stator, n_teeth), SectorForm::half,
                                              SectorGrading::level(1), MPI_COMM_WORLD);
    const CyclicSector without(mesh, stator_materials(), 3);
    const Mode mode     = working_mode(without);
    const double lowest = ceramic == ElementKind::solid ? -stator.piezoceramic_thickness : 0.;
    const dealii::FEValuesExtractors::Vector displacement(0);
    dealii::FEFaceValues<3> values(
        without.geometry(), without.dofs().get_fe(), dealii::QGauss<2>(5),
        dealii::update_values | dealii::update_JxW_values | dealii::update_quadrature_points);
    double stiffness = 0.;
    for (const auto &cell : without.dofs().active_cell_iterators())
      for (const unsigned int face : cell->face_indices())
        if (cell->face(face)->at_boundary() &&
            std::abs(cell->face(face)->center()[2] - lowest) < 1e-9)
        {
          values.reinit(cell, face);
          std::vector<dealii::Tensor<1, 3>> u(values.n_quadrature_points);
          for (const auto *field : {&mode.motion.solid.real, &mode.motion.solid.imaginary})
          {
            values[displacement].get_function_values(*field, u);
            for (unsigned int q = 0; q < u.size(); ++q)
              stiffness += model.felt_stiffness * values.JxW(q) * u[q][2] * u[q][2];
          }
        }
    const double expected = 0.5 * stiffness / mode.eigenvalue;
    ASSERT_GT(expected, 1e-5);
    EXPECT_NEAR(frequency_shift(without, mode, model) / expected, 1., 1e-6);

    add_to_stator(model, mesh);
    const CyclicSector with(mesh, stator_materials(), 3);
    EXPECT_NEAR((working_mode(with).frequency() / mode.frequency() - 1.) / expected, 1., 0.01);
  }
}

TEST(StatorEffects, AreChosenByTheTargetOfTheFrequency)
{
  for (const double target : {1e-2, 1e-5})
  {
    Parameters parameters                 = paper_motor();
    parameters.accuracy.mode              = AccuracyMode::fixed;
    parameters.accuracy.polynomial_degree = 2;
    parameters.accuracy.target            = target;
    parameters.effects["Felt support"]    = EffectChoice::automatic;
    BodyModes body(parameters, MPI_COMM_WORLD);
    body.find([](const Pass &) {});
    const bool is_on = target == 1e-5;
    EXPECT_EQ(!body.search().sector().sector_mesh().foundations.empty(), is_on);
    const std::vector<EffectRow> rows = body.effects();
    ASSERT_EQ(rows.size(), 3u);
    for (const EffectRow &row : rows)
    {
      if (row.name == "Piezoelectric coupling") // off, so that nothing was computed for it
      {
        EXPECT_EQ(row.choice, "off");
        EXPECT_FALSE(row.indicator);
        continue;
      }
      const bool is_felt = row.name == "Felt support"; // plates are asked for, but judged
      EXPECT_EQ(row.choice, is_on && is_felt ? "on" : "off") << row.name;
      EXPECT_EQ(row.is_automatic, is_felt);
      EXPECT_GT(std::abs(*row.indicator), 1e-5 / 3.) << row.name;
    }
  }
}
