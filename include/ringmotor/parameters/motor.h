// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace ringmotor
{
  /** How a thin part of the motor is modelled. */
  enum class ElementKind
  {
    solid,
    shell
  };

  /** What identifies the motor: its name, its wave and its symmetry. */
  struct Motor
  {
    std::string name            = "ring motor"; ///< used in titles only
    unsigned int n_waves        = 7;            ///< wavelengths around the ring
    unsigned int n_teeth        = 90;           ///< teeth, and so equal sectors, around the ring
    bool accepts_unusual_values = false;        ///< see check_plausible()

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };

  /**
   * The stator: a metal ring with teeth on top and a piezoceramic ring below. Its cross-section is
   * a trapezoid from the base (z = 0) to the tooth tops (z = base_thickness + tooth_height) with
   * straight sides. Slots have parallel walls. All lengths in m. The dimensions describe the stator
   * only while #section_file and #mesh_file are empty.
   */
  struct StatorGeometry
  {
    double base_inner_radius         = 30.0e-3; ///< at z = 0
    double base_outer_radius         = 36.0e-3; ///< at z = 0
    double tip_inner_radius          = 30.0e-3; ///< at the tooth tops
    double tip_outer_radius          = 34.2e-3; ///< at the tooth tops
    double base_thickness            = 4.37e-3; ///< from z = 0 to the slot roots
    double tooth_height              = 2.0e-3;  ///< from the slot roots to the tooth tops
    double slot_width                = 0.6e-3;  ///< between the parallel walls
    double piezoceramic_thickness    = 0.5e-3;  ///< of the ring below z = 0; 0 means no ring
    ElementKind piezoceramic_element = ElementKind::solid;
    std::optional<double> target_plate_area; ///< m^2, see Effects#target_plates
    std::optional<double> slot_angle;        ///< rad, between radial walls, instead of slot_width
    std::string section_file; ///< Gmsh file of the cross-section, as #mesh_file; empty: none
    std::string mesh_file;    ///< Gmsh file of one sector, absolute path after reading; empty: none

    /** Whether the dimensions describe it, not a file. */
    bool has_dimensions() const { return section_file.empty() && mesh_file.empty(); }
    /** `Stator/Mesh file = "..."`, for messages, if a file does. */
    std::string file_entry() const;

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };

  /**
   * The rotor: a ring, a flange spring running inwards from it, and a lip at the flange's inner end
   * that touches the teeth. Lengths in m; heights are above the plane of the tooth tops. The
   * dimensions describe the rotor only while #section_file and #mesh_file are empty.
   */
  struct RotorGeometry
  {
    double ring_inner_radius    = 36.5e-3;
    double ring_outer_radius    = 41.0e-3;
    double ring_lower_face      = -3.0e-3;
    double ring_upper_face      = 3.6e-3;
    double flange_lower_face    = 0.;
    double flange_thickness     = 0.60e-3;
    ElementKind flange_element  = ElementKind::shell;
    double lip_inner_radius     = 33.2e-3;
    double lip_outer_radius     = 34.2e-3;
    double radial_bar_stiffness = 1.e9;    ///< N/m per m of circumference; 0 means no bars
    double radial_bar_height    = 0.5e-3;  ///< of the band that the bars hold, below the upper edge
    std::optional<double> shell_thickness; ///< of the curve `shell` of #section_file
    std::string section_file; ///< Gmsh file of the cross-section, as #mesh_file; empty: none
    std::string mesh_file;    ///< Gmsh file of one sector, absolute path after reading; empty: none

    /** Whether the dimensions describe it, not a file. */
    bool has_dimensions() const { return section_file.empty() && mesh_file.empty(); }

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };
} // namespace ringmotor
