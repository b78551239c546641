// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/balance/loss_budget.h>
#include <ringmotor/motor/body_parts.h>
#include <ringmotor/points/point_quantities.h>
#include <ringmotor/wave/body_modes.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The integral of |U_z|^2 between two radii over one sector. */
    double square_of_rise(const WaveMotion &wave, const RadialRange &radii, const double pitch)
    {
      // The wave is a polynomial on each face of the mesh, smooth enough from face to face.
      const QIterated<1> points(QGauss<1>(3), 12);
      double square = 0.;
      for (unsigned int i = 0; i < points.size(); ++i)
        for (unsigned int j = 0; j < points.size(); ++j)
        {
          const double r     = radii.inner + radii.width() * points.point(i)[0];
          const double theta = pitch * (points.point(j)[0] - 0.5);
          const auto u       = wave(Point<3>(r * std::cos(theta), r * std::sin(theta), 0.));
          square +=
              points.weight(i) * points.weight(j) * radii.width() * pitch * r * std::norm(u[2]);
        }
      return square;
    }
  } // namespace

  double felt_energy(const Support &felt, const std::vector<RadialRange> &on_felt,
                     const unsigned int n_teeth, const WaveMotion &lower_side)
  {
    if (!felt.has_felt())
      return 0.;
    const RadialRange of_felt{
        felt.felt_inner_radius.value_or(0.),
        felt.felt_outer_radius.value_or(std::numeric_limits<double>::infinity())};
    double square = 0.;
    for (const RadialRange &radii : on_felt)
      if (const RadialRange common = radii.common(of_felt); !common.is_empty())
        square += square_of_rise(lower_side, common, 2. * numbers::PI / n_teeth);
    // The mean of Re(U exp(i omega t))^2 is |U|^2 / 2.
    return 0.25 * n_teeth * square * felt.stiffness();
  }

  Estimate LossBudget::stator() const
  {
    return stator_metal + piezoceramic + stator_vibration;
  }

  Estimate LossBudget::of_wave() const
  {
    return stator_metal + piezoceramic + support;
  }

  Estimate LossBudget::total() const
  {
    return friction + stator() + rotor + support;
  }

  Estimate LossBudget::input() const
  {
    return output + total();
  }

  Estimate LossBudget::efficiency() const
  {
    // The output stands once only, so that its error does not count twice.
    return output.value > 0. ? 1. / (1. + total() / output) : output.deviation() / total().value;
  }

  std::vector<Quantity> LossBudget::losses() const
  {
    std::vector<Quantity> all{{"friction_loss", units::power, friction},
                              {"internal_loss_stator_metal", units::power, stator_metal},
                              {"internal_loss_piezoceramic", units::power, piezoceramic},
                              {"internal_loss_stator_vibration", units::power, stator_vibration},
                              {"internal_loss_stator", units::power, stator()}};
    for (const auto &[name, loss] : {std::make_pair("internal_loss_rotor_metal", &rotor_metal),
                                     {"internal_loss_lining", &lining},
                                     {"internal_loss_adhesive", &adhesive}})
      if (*loss)
        all.emplace_back(name, units::power, **loss);
    all.emplace_back("internal_loss_rotor", units::power, rotor);
    all.emplace_back("support_loss", units::power, support);
    all.emplace_back("total_loss", units::power, total());
    return all;
  }

  std::vector<Quantity> LossBudget::powers() const
  {
    return {{"input_power", units::power, input()},
            {"output_power", units::power, output},
            {"efficiency", units::one, efficiency()}};
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
                         const Materials &materials, const RotorLossFactor &of_rotor,
                         const Support &felt)
  {
    const auto estimate = [&](const std::string &quantity)
    { return quantity_named(quantity).estimate(point); };
    LossBudget budget;
    budget.amplitude = estimate("amplitude");
    // Energies are quadratic in the amplitude of the wave.
    const Estimate ratio = budget.amplitude / wave.amplitude;
    const auto lost      = [&](const double loss_factor, const Estimate &energy)
    { return 2. * wave.angular_frequency * loss_factor * (ratio * ratio) * energy; };
    budget.output                  = estimate("torque") * estimate("speed");
    budget.friction                = estimate("friction_loss");
    budget.stator_metal            = lost(materials.stator_metal.loss_factor, wave.metal);
    budget.piezoceramic            = lost(materials.piezoceramic.loss_factor, wave.piezoceramic);
    budget.stator_vibration        = estimate("stator_vibration_loss");
    const Estimate per_loss_factor = estimate("rotor_power_per_loss_factor");
    budget.rotor                   = of_rotor.sum() * per_loss_factor;
    if (of_rotor.has_lining || of_rotor.has_adhesive)
      budget.rotor_metal = of_rotor.metal * per_loss_factor;
    if (of_rotor.has_lining)
      budget.lining = of_rotor.lining * per_loss_factor;
    if (of_rotor.has_adhesive)
      budget.adhesive = of_rotor.adhesive * per_loss_factor;
    budget.support = lost(felt.felt_loss_factor.value_or(0.), wave.felt);
    return budget;
  }
} // namespace ringmotor
