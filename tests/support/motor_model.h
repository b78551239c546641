// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "output/scratch.h"
#include "support/paper_motor.h"

#include <ringmotor/motor/effect.h>
#include <ringmotor/output/modes_file.h>
#include <ringmotor/output/stator_files.h>
#include <ringmotor/wave/body_modes.h>

#include <stdexcept>
#include <string>

namespace ringmotor::tests
{
  /** The reference motor with one coefficient of friction and a solid flange. */
  inline Parameters reference_motor()
  {
    Parameters parameters                   = paper_motor();
    parameters.accuracy.target              = 1e-3;
    parameters.friction.law                 = FrictionLaw("coulomb");
    parameters.friction.static_coefficient  = 0.40;
    parameters.friction.dynamic_coefficient = 0.40;
    parameters.rotor.flange_element         = ElementKind::solid;
    parameters.rotor.radial_bar_stiffness   = 1e9;
    return parameters;
  }

  /** The effect of an entry. */
  inline const Effect &effect(const std::string &name)
  {
    for (const auto &candidate : all_effects())
      if (candidate->name == name)
        return *candidate;
    throw std::logic_error("no effect " + name);
  }

  /** The rotor of prm/stiff_spring.prm instead of that of the reference motor. */
  inline void stiffen_spring(RotorGeometry &rotor)
  {
    rotor.ring_inner_radius = 35.6e-3;
    rotor.ring_outer_radius = 42.0e-3;
    rotor.ring_lower_face   = -2.4e-3;
    rotor.ring_upper_face   = 5.0e-3;
    rotor.flange_thickness  = 0.45e-3;
    rotor.lip_inner_radius  = 33.9e-3;
  }

  /** Its wave, as the program stator passes it to the contact. */
  inline StatorWave stator_wave(const Parameters &parameters)
  {
    BodyModes body(parameters, MPI_COMM_SELF);
    body.find([](const Pass &) {});
    const Scratch scratch;
    const std::string path = scratch.path("modes.h5");
    write_modes_h5(path, parameters, body.search().sector(), body.search().modes(), body.wave());
    return read_stator_wave(ModesFile(path, parameters), parameters);
  }
} // namespace ringmotor::tests
