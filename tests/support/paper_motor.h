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
    Effects &effects                    = parameters.effects;
    effects.tooth_shear                 = EffectChoice::on;
    effects.rotor_tangential_compliance = EffectChoice::on;
    effects.static_friction_excess      = EffectChoice::on;
    effects.rotor_inertia               = EffectChoice::off;
    effects.tooth_inertia               = EffectChoice::off;
    effects.tooth_vibration             = EffectChoice::off;
    effects.damping                     = EffectChoice::off;
    effects.stator_back_reaction        = EffectChoice::off;
    effects.spin_convection             = EffectChoice::off;
    effects.felt_support                = EffectChoice::off;
    effects.piezoelectric_coupling      = EffectChoice::off;
    effects.friction_lining             = EffectChoice::off;
    parameters.accuracy.contact_target  = 0.03;
    parameters.time.spectral_radius     = 0.8;
    parameters.support.felt_thickness   = 1e-3;
    parameters.support.felt_modulus     = 5e5;
    parameters.support.felt_loss_factor = 0.3;
    parameters.stator.target_plate_area = 1e-7;
    return parameters;
  }
} // namespace ringmotor::tests
