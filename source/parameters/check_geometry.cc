// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/check_geometry.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/prm_file.h>
#include <ringmotor/parameters/short_text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace ringmotor
{
  namespace
  {
    std::string in_metres(const double length)
    {
      std::ostringstream text;
      text << length << " m";
      return text.str();
    }
  } // namespace

  std::string entry(const std::string &path, const double metres)
  {
    return path + " = " + in_metres(metres);
  }

  std::string entry(const std::string &path, const unsigned int count)
  {
    return path + " = " + std::to_string(count);
  }

  void check_slot_width(const double width, const double smallest_radius,
                        const unsigned int n_teeth)
  {
    const double widest = most_slot * 2. * smallest_radius * std::sin(M_PI / n_teeth);
    if (width > widest)
      throw UserError(entry("Stator/Slot width", width) + " leaves no tooth with " +
                      entry("Motor/Number of teeth", n_teeth) + " and " +
                      entry("a smallest inner radius of the teeth", smallest_radius) + "; " +
                      entry("allowed: up to 95 % of the pitch, here Stator/Slot width", widest));
  }

  namespace
  {
    /** Shells must be thin. */
    void check_shell(const std::string &element, const std::string &name, const double thickness,
                     const double width)
    {
      if (thickness > most_shell_thickness * width)
        throw UserError(
            entry(name, thickness) + " is not thin compared to the width of the part, " +
            entry("as " + element + " = shell requires; allowed: up to 30 % of it, here " + name,
                  most_shell_thickness * width) +
            ", or " + element + " = solid");
    }

    /** Two radii of one face: in order, and not so close that no solid is left between them. */
    void check_radii(const std::string &face, const double inner_radius, const double outer_radius)
    {
      constexpr double thinnest = 1.e-3;
      if (outer_radius - inner_radius < thinnest * outer_radius)
        throw UserError(entry("Stator/" + face + " inner radius", inner_radius) +
                        " leaves no width below " +
                        entry("Stator/" + face + " outer radius", outer_radius) +
                        "; allowed: less than 0.999 of it, so that the sides of the cross-section "
                        "do not meet");
    }

    void check_slot(const StatorGeometry &stator, const unsigned int n_teeth)
    {
      const double root_height_share =
          stator.base_thickness / (stator.base_thickness + stator.tooth_height);
      const double root_inner_radius =
          stator.base_inner_radius +
          root_height_share * (stator.tip_inner_radius - stator.base_inner_radius);
      const double smallest_radius = std::min(root_inner_radius, stator.tip_inner_radius);

      check_slot_width(stator.slot_width, smallest_radius, n_teeth);
    }

    /** Two heights or radii of the rotor must be in order, more than a sliver apart. */
    void check_order(const std::string &low_name, const double low, const std::string &high_name,
                     const double high)
    {
      constexpr double thinnest = 1e-6; // m
      if (high - low < thinnest)
        throw UserError(entry("Rotor/" + low_name, low) + " is incompatible with " +
                        entry("Rotor/" + high_name, high) +
                        "; allowed: the first less than the second by at least a micrometre");
    }
  } // namespace

  void check_cross_section(const StatorGeometry &stator, const unsigned int n_teeth)
  {
    if (stator.slot_angle)
      throw UserError("Stator/Slot angle = " + short_text(*stator.slot_angle) +
                      " is for a stator with a section file; allowed with dimensions: none, and "
                      "Stator/Slot width");
    check_radii("Base", stator.base_inner_radius, stator.base_outer_radius);
    check_radii("Tip", stator.tip_inner_radius, stator.tip_outer_radius);
    check_slot(stator, n_teeth);
  }

  void check_thin_parts(const StatorGeometry &stator)
  {
    if (stator.piezoceramic_element == ElementKind::shell)
      check_shell("Stator/Piezoceramic element", "Stator/Piezoceramic thickness",
                  stator.piezoceramic_thickness,
                  stator.base_outer_radius - stator.base_inner_radius);
  }

  void check_rotor(const RotorGeometry &rotor)
  {
    if (!rotor.has_dimensions())
      return;
    if (rotor.shell_thickness)
      throw UserError(entry("Rotor/Shell thickness", *rotor.shell_thickness) +
                      " is for a rotor with a section file; allowed with dimensions: none, and "
                      "Rotor/Flange thickness");
    check_order("Lip inner radius", rotor.lip_inner_radius, "Lip outer radius",
                rotor.lip_outer_radius);
    check_order("Lip outer radius", rotor.lip_outer_radius, "Ring inner radius",
                rotor.ring_inner_radius);
    if (rotor.flange_element == ElementKind::shell)
    {
      check_shell("Rotor/Flange element", "Rotor/Flange thickness", rotor.flange_thickness,
                  rotor.ring_inner_radius - rotor.lip_inner_radius);
      check_order("Lip outer radius", rotor.lip_outer_radius,
                  "Ring inner radius - half of Rotor/Flange thickness",
                  rotor.ring_inner_radius - 0.5 * rotor.flange_thickness);
    }
    check_order("Ring inner radius", rotor.ring_inner_radius, "Ring outer radius",
                rotor.ring_outer_radius);
    check_order("Ring lower face", rotor.ring_lower_face, "Flange lower face",
                rotor.flange_lower_face);
    check_order(
        "Flange lower face + Flange thickness", rotor.flange_lower_face + rotor.flange_thickness,
        "Ring upper face - Radial bar height", rotor.ring_upper_face - rotor.radial_bar_height);
  }

  double clearance(const StatorGeometry &stator, const RotorGeometry &rotor)
  {
    if (rotor.ring_lower_face >= 0.)
      return std::hypot(std::max(0., rotor.ring_inner_radius - stator.tip_outer_radius),
                        rotor.ring_lower_face);
    // The side of the stator is straight, and so is the ring's: they are closest where the ring
    // begins or ends beside the stator.
    const double height = stator.base_thickness + stator.tooth_height;
    double least        = std::numeric_limits<double>::infinity();
    for (const double face : {rotor.ring_lower_face, rotor.ring_upper_face})
    {
      const double below_tops = std::clamp(-face, 0., height),
                   side =
                       stator.tip_outer_radius +
                       below_tops / height * (stator.base_outer_radius - stator.tip_outer_radius);
      least = std::min(least, rotor.ring_inner_radius - side);
    }
    return least;
  }

  void check_clearance(const StatorGeometry &stator, const RotorGeometry &rotor)
  {
    const double left = clearance(stator, rotor);
    if (rotor.ring_lower_face < 0. && left <= 0.)
      throw UserError("the rotor's ring cuts into the side of the stator: " +
                      entry("Rotor/Ring inner radius", rotor.ring_inner_radius) + " with " +
                      entry("Rotor/Ring lower face", rotor.ring_lower_face) + "; allowed: above " +
                      in_metres(rotor.ring_inner_radius - left) +
                      ", or a ring that ends above the tooth tops");
  }

  void check_amplitude(const Wave &wave, const std::string &of, const double thickness)
  {
    constexpr double largest_share = 0.01;
    if (wave.amplitude > largest_share * thickness)
      throw UserError(entry("Wave/Amplitude", wave.amplitude) + " is not small compared to " +
                      entry(of, thickness) +
                      ", as required for linear vibration; allowed: up to 1 % of it; amplitudes "
                      "are in m (2 um is 2e-6)");
  }
} // namespace ringmotor
