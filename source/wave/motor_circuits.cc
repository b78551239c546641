// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/body_parts.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/wave/body_modes.h>
#include <ringmotor/wave/motor_circuits.h>

#include <cmath>
#include <string>

namespace ringmotor
{
  MotorCircuits::MotorCircuits(const Parameters &parameters)
      : layout(parameters.electrodes, parameters.motor, mean_radius_of_ceramic(parameters)),
        harmonics(layout, parameters.motor.n_teeth), losses(parameters.piezoelectricity),
        materials(material_table(parameters.materials, Body::stator)),
        n_waves(parameters.motor.n_waves)
  {
  }

  void MotorCircuits::add_pass(const ModeSearch &search, const WaveResult &wave)
  {
    samples.push_back(
        {wave.found.frequency, wave.found.samples.back(),
         motional_branches(harmonics, search.sector(), wave.found.mode,
                           2. * dealii::numbers::PI * wave.found.frequency.value, wave.amplitude,
                           stator_quality(search.sector(), wave.found.mode, materials, losses))});
  }

  void MotorCircuits::add_capacitances(const ModeSearch &search)
  {
    const FoundMode *wave = search.working_mode(n_waves);
    if (wave == nullptr)
      throw ComputationError("the motor's wave was not found on the coarse mesh for the "
                             "capacitances of the phases");
    constexpr double any       = 1.; // force factors and losses do not matter here
    const CyclicSector &sector = search.sector();
    ElectricResponse response(sector.sector_mesh(), sector.material_table(),
                              sector.dofs().get_fe().degree);
    capacitances.push_back(
        parallel_capacitances(harmonics, response, wave->mode,
                              motional_branches(harmonics, sector, wave->mode,
                                                std::sqrt(wave->mode.eigenvalue), any, any)));
  }

  PhaseCircuit MotorCircuits::circuit(const Phase phase) const
  {
    const unsigned int i = PhaseHarmonics::index(phase);
    return {samples.back().frequency.value, samples.back().branches[i], capacitances.back()[i],
            losses.dielectric_loss_factor};
  }

  std::vector<Quantity> MotorCircuits::quantities(const Phase phase) const
  {
    const unsigned int i = PhaseHarmonics::index(phase);
    const auto &before = samples[samples.size() - 2], &last = samples.back();
    const auto &coarse = capacitances[capacitances.size() - 2][i], &fine = capacitances.back()[i];
    const double of_frequency = last.frequency.relative_error();
    const auto of_branch =
        [&](const std::string &name, const Unit &unit, double MotionalBranch::*const number)
    {
      return Quantity(name, unit,
                      shape_estimate(last.branches[i].*number, before.branches[i].*number,
                                     last.quality_of_mesh, before.quality_of_mesh, of_frequency));
    };
    const auto capacitance = [&](const std::string &name, double ParallelCapacitance::*const number,
                                 const double of_other_modes)
    {
      return Quantity(
          name, units::capacitance,
          Estimate(fine.*number, {{by_body_mesh, std::abs(fine.*number - coarse.*number)},
                                  {"harmonics of the electrodes", fine.rest},
                                  {"other modes", of_other_modes}}));
    };
    const Quantity c0 =
                       capacitance("C0", &ParallelCapacitance::at_resonance, std::abs(fine.change)),
                   cm = of_branch("Cm", units::motional_capacitance, &MotionalBranch::capacitance);
    const PhaseCircuit here = circuit(phase);
    const Estimate k_square =
        here.coupling_squared() * (c0.estimate.relative() * cm.estimate.relative());
    const double f_open = here.open_circuit_frequency();
    return {{"short_circuit_frequency", units::hertz, last.frequency},
            {"open_circuit_frequency", units::hertz,
             f_open * last.frequency.relative() + 0.5 * f_open * k_square.deviation()},
            {"k_eff^2", units::one, k_square},
            of_branch("force_factor", units::force_factor, &MotionalBranch::force_factor),
            c0,
            capacitance("free_capacitance", &ParallelCapacitance::free, 0.),
            capacitance("clamped_capacitance", &ParallelCapacitance::clamped, 0.),
            of_branch("Lm", units::inductance, &MotionalBranch::inductance),
            cm,
            of_branch("Rm", units::resistance, &MotionalBranch::resistance),
            of_branch("Q", units::one, &MotionalBranch::quality)};
  }
} // namespace ringmotor
