// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/declare.h>
#include <ringmotor/parameters/motor.h>
#include <ringmotor/parameters/prm_file.h>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    Notation<ElementKind> element_kind()
    {
      return selection<ElementKind>({{"solid", ElementKind::solid}, {"shell", ElementKind::shell}});
    }

    void add_length(ParameterHandler &prm, const std::string &name, double &variable,
                    const Notation<double> &length, const std::string &sentence)
    {
      add_entry(prm, name, variable, length, sentence, Presence::required);
    }
  } // namespace

  void Motor::declare(ParameterHandler &prm)
  {
    add_entry(prm, "Name", name, any_text(), "Name of the motor, used in titles.");
    add_entry(prm, "Number of waves", n_waves, whole_number(1, 4999),
              "Number of wavelengths n of the travelling wave around the ring.",
              Presence::required);
    add_entry(prm, "Number of teeth", n_teeth, whole_number(3, 10000),
              "Number of teeth N around the ring, which is also the number of its equal sectors.",
              Presence::required);
    add_entry(prm, "Unusual values", accepts_unusual_values,
              selection<bool>({{"refuse", false}, {"accept", true}}),
              "Whether allowed but implausible numbers, which are most likely in other units, are "
              "refused or accepted.");
  }

  std::string StatorGeometry::file_entry() const
  {
    return section_file.empty() ? "Stator/Mesh file = " + in_quotes(mesh_file)
                                : "Stator/Section file = " + in_quotes(section_file);
  }

  void StatorGeometry::declare(ParameterHandler &prm)
  {
    add_length(prm, "Base inner radius", base_inner_radius, radius(),
               "Inner radius of the metal base at its lower face, where z = 0. Units: m.");
    add_length(prm, "Base outer radius", base_outer_radius, radius(),
               "Outer radius of the metal base at its lower face, where z = 0. Units: m.");
    add_length(prm, "Tip inner radius", tip_inner_radius, radius(),
               "Inner radius of the tooth tops; the inner side is straight from the base to here. "
               "Units: m.");
    add_length(prm, "Tip outer radius", tip_outer_radius, radius(),
               "Outer radius of the tooth tops; the outer side is straight from the base to here. "
               "Units: m.");
    add_length(prm, "Base thickness", base_thickness, thickness(),
               "Thickness of the metal base, from its lower face to the slot roots. Units: m.");
    add_length(prm, "Tooth height", tooth_height, thickness(),
               "Height of the teeth, from the slot roots to the tooth tops. Units: m.");
    add_length(prm, "Slot width", slot_width, thickness(),
               "Distance between the parallel walls of a slot. Units: m.");
    add_entry(
        prm, "Piezoceramic thickness", piezoceramic_thickness,
        plausible(non_negative_number(), 1e-5, 0.05),
        "Thickness of the piezoceramic ring bonded below the base, which has the radii of the "
        "base's lower face; 0 omits the ring. Units: m.",
        Presence::required);
    add_entry(prm, "Piezoceramic element", piezoceramic_element, element_kind(),
              "Elements of the piezoceramic ring.");
    add_entry(prm, "Target plate cross-section", target_plate_area,
              number_or("none", plausible(positive_number(), 1e-10, 1e-4)),
              "Cross-section of the thin plates, targets of optical measurements, on the outer "
              "edges of the tooth tops; used if Effects/Target plates is on. Units: "
              "m^2.");
    add_entry(prm, "Slot angle", slot_angle,
              number_or("none", number_within(1e-6, 2., "a number from 1e-6 to 2")),
              "Angle between the radial walls of a slot, instead of Slot width, for a stator with "
              "a section file. Units: rad.");
    add_entry(prm, "Section file", section_file, file_or_none(),
              "Gmsh file (.msh) of the cross-section of the stator, see meshes/README.md, which "
              "replaces the dimensions above except Slot width. A relative path is searched in the "
              "folder of this parameter file first, then in the current directory.");
    add_entry(
        prm, "Mesh file", mesh_file, file_or_none(),
        "Gmsh file (.msh) of one sector of the stator, see meshes/README.md, which replaces the "
        "dimensions above, for bodies that are not of revolution; contact and losses need the half "
        "of a sector that has a mirror plane. A relative path is searched in the folder of this "
        "parameter file first, then in the current directory.");
  }

  void RotorGeometry::declare(ParameterHandler &prm)
  {
    add_length(prm, "Ring inner radius", ring_inner_radius, radius(),
               "Inner radius of the rotor ring. Units: m.");
    add_length(prm, "Ring outer radius", ring_outer_radius, radius(),
               "Outer radius of the rotor ring. Units: m.");
    add_length(prm, "Ring lower face", ring_lower_face, height(),
               "Height of the ring's lower face above the plane of the tooth tops. Units: m.");
    add_length(prm, "Ring upper face", ring_upper_face, height(),
               "Height of the ring's upper face above the plane of the tooth tops. Units: m.");
    add_length(prm, "Flange lower face", flange_lower_face, height(),
               "Height of the flange's lower face above the plane of the tooth tops. Units: m.");
    add_length(prm, "Flange thickness", flange_thickness, thickness(),
               "Thickness of the flange spring between ring and lip. Units: m.");
    add_entry(prm, "Flange element", flange_element, element_kind(),
              "Elements of the flange spring.");
    add_length(prm, "Lip inner radius", lip_inner_radius, radius(),
               "Inner radius of the lip, the part of the rotor that can touch. Units: m.");
    add_length(prm, "Lip outer radius", lip_outer_radius, radius(),
               "Outer radius of the lip, the part of the rotor that can touch. Units: m.");
    add_entry(
        prm, "Radial bar stiffness", radial_bar_stiffness,
        plausible(non_negative_number(), 1e3, 1e14),
        "Radial stiffness, per length of circumference, of the bars that support the upper edge of "
        "the ring's inner face; 0 omits the bars. Units: N/m^2.",
        Presence::required);
    add_entry(prm, "Radial bar height", radial_bar_height, thickness(),
              "Height of the band below that edge over which the forces of the bars are "
              "distributed; displacements under a line force would diverge. Units: m.",
              Presence::required);
    add_entry(
        prm, "Shell thickness", shell_thickness,
        number_or("none", plausible(positive_number(), 1e-5, 0.05)),
        "Thickness of the shell whose line is the curve 'shell' of a section file. Units: m.");
    add_entry(prm, "Section file", section_file, file_or_none(),
              "Gmsh file (.msh) of the cross-section of the rotor, see meshes/README.md, which "
              "replaces the dimensions above except Shell thickness. A relative path is searched "
              "in the folder of this "
              "parameter file first, then in the current directory.");
    add_entry(prm, "Mesh file", mesh_file, file_or_none(),
              "Gmsh file (.msh) of half of one sector of the rotor, see meshes/README.md, which "
              "replaces the dimensions above except Radial bar stiffness, for rotors that are not "
              "of revolution. A relative path is searched in the folder of this parameter file "
              "first, then in the current directory.");
  }
} // namespace ringmotor
