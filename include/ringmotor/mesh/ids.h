// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/types.h>

namespace ringmotor
{
  /**
   * Material ids of cells and boundary ids of faces in every sector mesh, generated or read from a
   * Gmsh file (where they are the physical ids of volumes and surfaces, see meshes/README.md).
   */
  namespace ids
  {
    constexpr dealii::types::material_id base  = 1; ///< metal of the base ring
    constexpr dealii::types::material_id tooth = 2; ///< metal of the tooth, above the slot's bottom
    constexpr dealii::types::material_id piezoceramic = 3; ///< ceramic ring bonded below the base

    constexpr dealii::types::material_id rotor     = 4; ///< ring, flange and lip of the rotor
    constexpr dealii::types::material_id lip_shell = 5; ///< lip of the rotor where it is a shell

    constexpr dealii::types::material_id lining   = 6; ///< friction lining of the rotor
    constexpr dealii::types::material_id adhesive = 7; ///< between lining and rotor

    constexpr dealii::types::boundary_id free      = 0;  ///< no load, no condition
    constexpr dealii::types::boundary_id mirror    = 11; ///< half sector: the plane theta = 0
    constexpr dealii::types::boundary_id cut       = 12; ///< half sector: the plane theta = alpha/2
    constexpr dealii::types::boundary_id cut_low   = 13; ///< whole sector: the cut at smaller theta
    constexpr dealii::types::boundary_id cut_high  = 14; ///< whole sector: the cut at larger theta
    constexpr dealii::types::boundary_id tooth_top = 15; ///< the face that can touch the rotor
    constexpr dealii::types::boundary_id lip       = 16; ///< the face that can touch the teeth
    constexpr dealii::types::boundary_id ring_top  = 17; ///< upper face of the rotor's ring
    constexpr dealii::types::boundary_id ring_bore = 18; ///< inner side of the rotor's ring
    constexpr dealii::types::boundary_id shell_root =
        19; ///< faces of a solid that the edge of a shell is tied to, and that edge
    constexpr dealii::types::boundary_id skin = 20; ///< face of a solid that a shell is bonded to
    constexpr dealii::types::boundary_id clamped = 21; ///< face that does not move

    constexpr dealii::types::boundary_id radial_bars =
        22; ///< band of the ring's inner side that the bars hold
    constexpr dealii::types::boundary_id tooth_foot =
        23;                                           ///< where a single tooth is cut off the base
    constexpr dealii::types::boundary_id bottom = 24; ///< lower face of the stator

    // Edges
    constexpr dealii::types::boundary_id target_plate = 30; ///< where a plate is bonded to a tooth

    /** Where a sector is cut from its neighbours. */
    constexpr bool is_cut(const dealii::types::boundary_id id)
    {
      return id == cut || id == cut_low || id == cut_high;
    }
    /** The planes at which the mesh of a sector ends: its cuts and its mirror plane. */
    constexpr bool is_plane(const dealii::types::boundary_id id)
    {
      return id == mirror || is_cut(id);
    }
  } // namespace ids
} // namespace ringmotor
