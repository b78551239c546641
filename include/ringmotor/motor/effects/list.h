// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/effect.h>

namespace ringmotor::effects
{
  using EffectPointer = std::unique_ptr<const Effect>;

  EffectPointer tooth_shear();
  EffectPointer rotor_tangential_compliance();
  EffectPointer initial_deformation();
  EffectPointer static_friction_excess();
  EffectPointer rotor_inertia();
  EffectPointer tooth_inertia();
  EffectPointer tooth_vibration();
  EffectPointer damping();
  EffectPointer stator_back_reaction();
  EffectPointer stator_compliance();
  EffectPointer spin_convection();
  EffectPointer target_plates();
  EffectPointer felt_support();
  EffectPointer piezoelectric_coupling();
  EffectPointer friction_lining();
} // namespace ringmotor::effects
