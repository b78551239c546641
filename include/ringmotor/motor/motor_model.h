// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sections.h>
#include <ringmotor/motor/warp.h>
#include <ringmotor/parameters/parameters.h>

#include <optional>

namespace ringmotor
{
  /**
   * The physical model of a motor: its bodies, their interface and its friction. By default the
   * teeth are rigid, the rotor has no tangential compliance, and both are massless; each effect
   * that is not off adds its part, see Effect. All code that computes, draws or stores a motor
   * reads this and not the choice of effects.
   */
  struct MotorModel
  {
    // The stator and its wave
    std::optional<BarSection> target_plates; ///< along the outer edges of the tooth tops
    double felt_stiffness = 0.;              ///< N/m^3, of the felt under the stator
    std::optional<PiezoelectricLaw> ceramic; ///< with a potential; else it is isotropic
    bool wave_feels_contact = false;         ///< contact forces change its frequency

    // The bodies in contact
    bool teeth_give_way          = false; ///< elastic teeth under contact forces
    bool teeth_move_with_inertia = false; ///< where the base drives them
    bool teeth_vibrate           = false; ///< with inertia under contact forces
    bool stator_gives_way        = false; ///< its base, with inertia, under contact forces
    bool rotor_gives_way_along   = false; ///< elastic rotor also under friction
    bool rotor_vibrates          = false; ///< with inertia
    bool rotor_moves_as_whole    = false; ///< with its mass and its inertia against tilting
    /** Of the rotor's internal damping, with inertia or without: the largest of its parts; see
     * rotor_loss_factor() for that of the whole rotor. */
    double rotor_loss_factor = 0.;

    // The interface between them
    Warp warp;
    double lining_normal_compliance     = 0.; ///< m^3/N
    double lining_tangential_compliance = 0.; ///< m^3/N
    Friction friction;

    /** Whether it is marched through time: because the user wants it, or the ring is not uniform.
     */
    bool is_marched = false;

    /** Whether the teeth or the rotor, of small mass, have inertia under contact forces. */
    bool has_inertia() const { return teeth_vibrate || rotor_vibrates; }
    /** Whether the response of the rotor depends on the history of forces, which requires its
     * modes. */
    bool rotor_needs_modes() const { return rotor_vibrates || rotor_loss_factor > 0.; }
    /** Whether it has modes of a whole ring, which all meshes of the contact share. */
    bool has_ring_modes() const { return stator_gives_way || rotor_needs_modes(); }
    bool needs_modes() const { return teeth_vibrate || has_ring_modes(); }
  };

  /** The model with all effects that are not off; `auto` stands for `on` here. */
  MotorModel motor_model(const Parameters &parameters);

  /** MotorModel::is_marched of these parameters. */
  bool is_marched(const Parameters &parameters);
} // namespace ringmotor
