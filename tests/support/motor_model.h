// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "output/scratch.h"

#include <ringmotor/output/modes_file.h>
#include <ringmotor/output/stator_files.h>
#include <ringmotor/quantities/body_modes.h>

namespace ringmotor::tests
{
  /** The reference motor with one coefficient of friction and a solid flange. */
  inline Parameters reference_motor()
  {
    Parameters parameters;
    parameters.accuracy.target              = 1e-3;
    parameters.friction.law                 = FrictionLaw::coulomb;
    parameters.friction.static_coefficient  = 0.40;
    parameters.friction.dynamic_coefficient = 0.40;
    parameters.rotor.flange_element         = ElementKind::solid;
    parameters.rotor.radial_bar_stiffness   = 1e9;
    return parameters;
  }

  /** Its wave, as the program stator hands it to the contact. */
  inline StatorWave stator_wave(const Parameters &parameters)
  {
    BodyModes body(parameters, MPI_COMM_SELF);
    body.find([](const Pass &) {});
    const ModeSearch &search = body.search();
    WaveResult wave;
    wave.found             = *search.working_mode(parameters.motor.n_waves);
    wave.amplitude         = parameters.wave.amplitude;
    wave.angular_frequency = 2. * M_PI * wave.found.frequency.value;
    normalise_to_amplitude(wave.found.mode, tooth_points(search.sector()), wave.amplitude);
    wave.energy = wave_energy(search.sector(), wave.found.mode);
    wave.shape  = {{"A_t/A_n", "1", {0.84, 1e-4}}};
    const Scratch scratch;
    const std::string path = scratch.path("modes.h5");
    write_modes_h5(path, parameters, search.sector(), search.modes(), &wave);
    return read_stator_wave(path, parameters);
  }
} // namespace ringmotor::tests
