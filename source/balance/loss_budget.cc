// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/balance/loss_budget.h>
#include <ringmotor/wave/body_modes.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    Estimate sum(const std::initializer_list<Estimate> &parts)
    {
      Estimate sum{0., 0.};
      for (const Estimate &part : parts)
      {
        sum.value += part.value;
        sum.error += part.error;
      }
      return sum;
    }

    Estimate scaled(const double factor, const Estimate &estimate)
    {
      return {factor * estimate.value, std::abs(factor) * estimate.error};
    }

    LossBudget budget_of(const CurvePoint &point, const PointError &error, const WaveEnergies &wave,
                         const Materials &materials, const Support &felt)
    {
      const OperatingPoint &result = point.result;
      const double twice_omega     = 2. * wave.angular_frequency;
      // Energies are quadratic in the amplitude of the wave.
      const auto lost = [&](const double loss_factor, const Estimate &energy)
      {
        const double ratio = result.amplitude / wave.amplitude;
        Estimate loss      = scaled(twice_omega * loss_factor * ratio * ratio, energy);
        loss.error += 2. * loss.value * error.amplitude / result.amplitude;
        return loss;
      };
      LossBudget budget;
      budget.amplitude    = {result.amplitude, error.amplitude};
      budget.output       = {result.output_power(), std::abs(result.torque) * error.speed +
                                                        std::abs(result.speed) * error.torque};
      budget.friction     = {result.friction_loss(), error.loss};
      budget.stator_metal = lost(materials.stator_metal.loss_factor, wave.metal);
      budget.piezoceramic = lost(materials.piezoceramic.loss_factor, wave.piezoceramic);
      budget.rotor =
          scaled(materials.rotor_metal.loss_factor, {point.rotor_power, error.rotor_power});
      budget.support = lost(felt.felt_loss_factor.value_or(0.), wave.felt);
      return budget;
    }

    Quantity quantity(const std::string &name, const Unit &unit, const Estimate &estimate)
    {
      return {name, unit, estimate.value, estimate.error};
    }
  } // namespace

  double felt_energy(const Support &felt, const StatorGeometry &stator, const unsigned int n_teeth,
                     const WaveMotion &lower_side)
  {
    const double inner = std::max(felt.felt_inner_radius.value_or(0.), stator.base_inner_radius),
                 outer = std::min(felt.felt_outer_radius.value_or(stator.base_outer_radius),
                                  stator.base_outer_radius);
    if (!felt.has_felt() || inner >= outer)
      return 0.;
    // The wave is a polynomial on each face of the mesh, smooth enough from face to face.
    const QIterated<1> points(QGauss<1>(3), 12);
    const double pitch = 2. * numbers::PI / n_teeth;
    double square      = 0.; // integral of |U_z|^2 over one sector
    for (unsigned int i = 0; i < points.size(); ++i)
      for (unsigned int j = 0; j < points.size(); ++j)
      {
        const double r     = inner + (outer - inner) * points.point(i)[0];
        const double theta = pitch * (points.point(j)[0] - 0.5);
        const auto u       = lower_side(Point<3>(r * std::cos(theta), r * std::sin(theta), 0.));
        square +=
            points.weight(i) * points.weight(j) * (outer - inner) * pitch * r * std::norm(u[2]);
      }
    // The mean of Re(U exp(i omega t))^2 is |U|^2 / 2.
    return 0.25 * n_teeth * square * felt.stiffness();
  }

  Estimate LossBudget::stator() const
  {
    return sum({stator_metal, piezoceramic});
  }

  Estimate LossBudget::total() const
  {
    return sum({friction, stator_metal, piezoceramic, rotor, support});
  }

  Estimate LossBudget::input() const
  {
    return sum({output, total()});
  }

  Estimate LossBudget::efficiency() const
  {
    const Estimate loss = total();
    const double input  = output.value + loss.value;
    if (output.value <= 0.)
      return {0., output.error / loss.value};
    return {output.value / input,
            (loss.value * output.error + output.value * loss.error) / (input * input)};
  }

  std::vector<Quantity> LossBudget::losses() const
  {
    return {quantity("friction_loss", units::power, friction),
            quantity("internal_loss_stator_metal", units::power, stator_metal),
            quantity("internal_loss_piezoceramic", units::power, piezoceramic),
            quantity("internal_loss_stator", units::power, stator()),
            quantity("internal_loss_rotor", units::power, rotor),
            quantity("support_loss", units::power, support),
            quantity("total_loss", units::power, total())};
  }

  std::vector<Quantity> LossBudget::powers() const
  {
    return {quantity("input_power", units::power, input()),
            quantity("output_power", units::power, output),
            quantity("efficiency", units::one, efficiency())};
  }

  std::vector<std::vector<double>> loss_density(const SectorField &wave, const Materials &materials)
  {
    const MaterialTable table = material_table(materials, Body::stator);
    std::vector<std::vector<double>> density;
    for (const SectorField::Cell &cell : wave.cells)
    {
      density.push_back(cell.strain_energy);
      for (double &value : density.back())
        value *= 2. * table.at(cell.material).loss_factor * wave.angular_frequency;
    }
    return density;
  }

  LossBudget loss_budget(const CurvePoint &point, const WaveEnergies &wave,
                         const Materials &materials, const Support &felt)
  {
    return budget_of(point, point.errors.total(), wave, materials, felt);
  }

  std::vector<std::pair<std::string, LossBudget>> budgets_by_cause(const CurvePoint &point,
                                                                   const WaveEnergies &wave,
                                                                   const Materials &materials,
                                                                   const Support &felt)
  {
    WaveEnergies exact_wave = wave;
    for (Estimate *energy : {&exact_wave.metal, &exact_wave.piezoceramic, &exact_wave.felt})
      energy->error = 0.;
    std::vector<std::pair<std::string, LossBudget>> budgets;
    for (const auto &[cause, error] : point.errors.causes())
      budgets.emplace_back(cause, budget_of(point, error,
                                            cause == PointErrors::by_wave ? wave : exact_wave,
                                            materials, felt));
    return budgets;
  }
} // namespace ringmotor
