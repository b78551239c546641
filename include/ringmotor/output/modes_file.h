// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/balance/drive.h>
#include <ringmotor/motor/condensed_motor.h>

#include <optional>
#include <string>

namespace ringmotor
{
  /**
   * Reads the motor's wave from a file `modes.h5` that the program `stator` has written for the
   * motor of @p parameters.
   * @throws UserError in one line if the file is missing, damaged, without the motor's wave, of
   *         another version or of another motor; it names the entry that differs
   */
  StatorWave read_stator_wave(const std::string &path, const Parameters &parameters);

  /** Reads the energies that the wave stores, from the same file and with the same errors; see
   * felt_energy() for the felt. */
  WaveEnergies read_wave_energies(const std::string &path, const Parameters &parameters);

  /** Reads the wave with the electrodes that drive it, from the same file and with the same errors;
   * none if its ceramic had no potential. */
  std::optional<DrivenWave> read_driven_wave(const std::string &path, const Parameters &parameters);

  /** Reads the motion of the stator and the distribution of its strain energy in the wave, from the
   * same file and with the same errors. */
  SectorField read_wave_body(const std::string &path, const Parameters &parameters);
} // namespace ringmotor
