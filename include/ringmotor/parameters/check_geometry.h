// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

#include <string>

namespace ringmotor
{
  /** Half a pitch, measured at right angles to the slot's wall, contains half the slot and half the
   * tooth; the largest share of the slot, so that at least 5 % are left for the tooth. */
  inline constexpr double most_slot = 0.95;

  /** Checks the width of slots (m) between teeth that begin at a radius (m). @throws UserError */
  void check_slot_width(double width, double smallest_radius, unsigned int n_teeth);

  // Checks of dimensions against each other. All of them throw a UserError that names the
  // conflicting entries and what is allowed.

  /** A length as the user writes it, with its entry: `Stator/Slot width = 0.0006 m`. */
  std::string entry(const std::string &path, double metres);
  /** The same for a number. */
  std::string entry(const std::string &path, unsigned int count);

  /** The radii of the stator, and slots narrow enough to leave teeth. */
  void check_cross_section(const StatorGeometry &stator, unsigned int n_teeth);

  /** Shells and target plates have to be thin. */
  void check_thin_parts(const StatorGeometry &stator);

  /** Shells must be thin: up to this share of the width of the part. */
  constexpr double most_shell_thickness = 0.3;

  /** Lip, flange and ring must be in the right order. */
  void check_rotor(const RotorGeometry &rotor);

  /** The distance (m) of the rotor's ring from the stator: along r from its outer side, negative if
   * one cuts into the other; of a ring above the tooth tops from their outer edge. */
  double clearance(const StatorGeometry &stator, const RotorGeometry &rotor);

  /** The ring must not cut into the stator. */
  void check_clearance(const StatorGeometry &stator, const RotorGeometry &rotor);

  /** Amplitudes must be small compared to a thickness (m), the entry or what it is of; this finds
   * those given in um instead of m. */
  void check_amplitude(const Wave &wave, const std::string &of, double thickness);
} // namespace ringmotor
