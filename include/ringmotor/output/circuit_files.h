// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/wave/motor_circuits.h>

#include <string>

namespace ringmotor
{
  /** `circuits.csv`: the equivalent circuit of each phase with error bars. */
  void write_circuits(const std::string &path, const MotorCircuits &circuits);

  /** `admittance.csv`: conductance and susceptance of each phase around the resonance. */
  void write_admittance(const std::string &path, const MotorCircuits &circuits);

  /** `electrodes.csv`: the arcs of both phases. */
  void write_electrodes(const std::string &path, const ElectrodeLayout &layout);

  /** `excitation.csv`: how strongly the phases drive each nodal diameter up to @p largest_n. */
  void write_excitation(const std::string &path, const ElectrodeLayout &layout,
                        const unsigned int largest_n);
} // namespace ringmotor
