// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/quantities/motor_circuits.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  MotorCircuits::MotorCircuits(const Parameters &parameters)
      : layout(parameters.electrodes, parameters.motor, parameters.stator),
        losses(parameters.piezoelectricity)
  {
  }

  namespace
  {
    /** Adds a part to the error of a quantity. */
    void add_error(Quantity &quantity, const std::string &cause, const double error)
    {
      quantity.error = quantity.error.value_or(0.) + error;
      quantity.error_causes[cause] += error;
    }
  } // namespace

  void MotorCircuits::add_pass(const ModeSearch &search, const WaveResult &wave)
  {
    PhaseCapacitances capacitances(search.sector(), layout);
    const double quality = stator_quality(search.sector(), wave.found.mode, losses);
    const auto circuits =
        phase_circuits(capacitances, search.sector(), wave.found.mode, wave.amplitude, quality);
    const FrequencySample &now = wave.found.samples.back();
    std::vector<PhaseResult> results;
    for (const Phase phase : {Phase::a, Phase::b})
    {
      const PhaseCircuit &circuit = circuits[static_cast<unsigned int>(phase)];
      PhaseResult result{phase, circuit, circuit.quantities()};
      if (earlier_frequency)
      {
        const std::vector<Quantity> earlier = of_phases[results.size()].circuit.quantities();
        for (unsigned int i = 0; i < earlier.size(); ++i)
          add_error(result.quantities[i], "body mesh",
                    shape_estimate(result.quantities[i].value, earlier[i].value, now,
                                   *earlier_frequency,
                                   wave.found.frequency.error / wave.found.frequency.value)
                        .error);
        for (Quantity &quantity : result.quantities)
        {
          if (quantity.unit.shown == units::capacitance.shown)
            add_error(quantity, "harmonics of the electrodes",
                      capacitances.rest(phase) * quantity.value);
          if (quantity.name == "C0")
            add_error(quantity, "other modes", std::abs(circuit.change_of_parallel));
        }
      }
      results.push_back(std::move(result));
    }
    of_phases         = std::move(results);
    earlier_frequency = now;
  }

  double MotorCircuits::excitation(const unsigned int n) const
  {
    const auto strength = [&](const unsigned int k)
    {
      return std::hypot(std::abs(layout.harmonic(Phase::a, static_cast<int>(k))),
                        std::abs(layout.harmonic(Phase::b, static_cast<int>(k))));
    };
    double largest = 0.;
    for (unsigned int k = 0; k < 200; ++k)
      largest = std::max(largest, strength(k));
    return strength(n) / largest;
  }
} // namespace ringmotor
