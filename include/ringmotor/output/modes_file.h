// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/balance/drive.h>
#include <ringmotor/motor/condensed_motor.h>

#include <memory>
#include <optional>
#include <string>

namespace ringmotor
{
  class Hdf5Reader;

  /** A file `modes.h5` that the program `stator` has written, with the wave of a motor. */
  class ModesFile
  {
  public:
    /**
     * @param parameters of the motor, must outlive this object
     * @throws UserError in one line if the file is missing, damaged, without the motor's wave, of
     *         another version or of another motor; it names the entry that differs. So do all
     *         others.
     */
    ModesFile(const std::string &path, const Parameters &parameters);
    /** That in the folder of the results. */
    explicit ModesFile(const Parameters &parameters);
    ~ModesFile();

    /** The motor's wave; what drives it is left out, see add_voltage_drive(). */
    StatorWave wave() const;
    /** The energies that the wave stores; see felt_energy() for the felt. */
    WaveEnergies energies() const;
    /** The wave with the electrodes that drive it; none if its ceramic had no potential. */
    std::optional<DrivenWave> driven_wave() const;
    /** The motion of the stator and the distribution of its strain energy in the wave. */
    SectorField body() const;

    const std::string path;

  private:
    const Parameters &parameters;
    const std::unique_ptr<const Hdf5Reader> reader;
  };

  /** The motor's wave with what drives it. @throws UserError for a voltage if the ceramic had no
   * potential */
  StatorWave read_stator_wave(const ModesFile &file, const Parameters &parameters);
} // namespace ringmotor
