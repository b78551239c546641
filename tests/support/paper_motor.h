// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

namespace ringmotor::tests
{
  /** The reference motor as its paper models it: no inertia of rotor and teeth, no damping, no
   * shift of the frequency by the contact. With felt and target plates, for tests that use them. */
  inline Parameters paper_motor()
  {
    Parameters parameters;
    Effects &effects                       = parameters.effects;
    effects["Tooth shear"]                 = EffectChoice::on;
    effects["Rotor tangential compliance"] = EffectChoice::on;
    effects["Static friction excess"]      = EffectChoice::on;
    effects["Rotor inertia"]               = EffectChoice::off;
    effects["Tooth inertia"]               = EffectChoice::off;
    effects["Tooth vibration"]             = EffectChoice::off;
    effects["Stator compliance"]           = EffectChoice::off;
    effects["Damping"]                     = EffectChoice::off;
    effects["Stator back-reaction"]        = EffectChoice::off;
    effects["Spin convection"]             = EffectChoice::off;
    effects["Felt support"]                = EffectChoice::off;
    effects["Piezoelectric coupling"]      = EffectChoice::off;
    effects["Friction lining"]             = EffectChoice::off;
    parameters.accuracy.contact_target     = 0.03;
    parameters.time.spectral_radius        = 0.8;
    parameters.support.felt_thickness      = 1e-3;
    parameters.support.felt_modulus        = 5e5;
    parameters.support.felt_loss_factor    = 0.3;
    parameters.stator.target_plate_area    = 1e-7;
    return parameters;
  }
} // namespace ringmotor::tests
