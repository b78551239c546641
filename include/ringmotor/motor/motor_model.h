// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sections.h>
#include <ringmotor/motor/warp.h>
#include <ringmotor/parameters/parameters.h>

#include <optional>

namespace ringmotor
{
  /**
   * A motor as it is modelled: what its bodies do, what stands between them, and how they rub. By
   * itself both bodies are stiff and without mass; effects that take part put in what they are
   * about, see Effect. What computes, draws or keeps a motor reads this and no choice of effects.
   */
  struct MotorModel
  {
    // The stator and its wave
    std::optional<BarSection> target_plates; ///< along the outer edges of the tooth tops
    double felt_stiffness   = 0.;            ///< N/m^3, of the felt under the stator
    bool wave_feels_contact = false;         ///< contact forces change its frequency

    // The bodies in contact
    bool teeth_give_way        = false; ///< elastic teeth under contact forces
    bool teeth_vibrate         = false; ///< with inertia
    bool rotor_gives_way_along = false; ///< elastic rotor also under friction
    bool rotor_vibrates        = false; ///< with inertia
    bool rotor_moves_as_whole  = false; ///< its mass and its tilting inertia matter, too
    double rotor_loss_factor   = 0.;    ///< of its internal damping, with inertia or without

    // What stands between them
    Warp warp;
    double lining_normal_compliance     = 0.; ///< m^3/N
    double lining_tangential_compliance = 0.; ///< m^3/N
    Friction friction;

    /** Whether a body has inertia in the contact. */
    bool has_inertia() const { return teeth_vibrate || rotor_vibrates; }
    /** Whether motions of the rotor depend on how forces change in time, which its modes tell. */
    bool rotor_needs_modes() const { return rotor_vibrates || rotor_loss_factor > 0.; }
    bool needs_modes() const { return teeth_vibrate || rotor_needs_modes(); }
  };

  /** The model with all effects that are not off; `auto` stands for `on` here. */
  MotorModel motor_model(const Parameters &parameters);
} // namespace ringmotor
