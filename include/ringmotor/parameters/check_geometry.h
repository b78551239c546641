// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

#include <string>

namespace ringmotor
{
  // What dimensions have to do with each other. All these throw a UserError that names the entries
  // which do not go together, and what is allowed.

  /** A length as the user writes it, with its entry: `Stator/Slot width = 0.0006 m`. */
  std::string entry(const std::string &path, double metres);
  /** The same of a number. */
  std::string entry(const std::string &path, unsigned int count);

  /** The radii of the stator, and slots between which teeth are left. */
  void check_cross_section(const StatorGeometry &stator, unsigned int n_teeth);

  /** Shells and target plates have to be thin. */
  void check_thin_parts(const StatorGeometry &stator);

  /** Lip, flange and ring in their order. */
  void check_rotor(const RotorGeometry &rotor);

  /** Lip and tooth tops have to share a strip that is more than a sliver. */
  void check_overlap(const StatorGeometry &stator, const RotorGeometry &rotor);

  /** Amplitudes in um are easily written as if the file took um. */
  void check_amplitude(const Wave &wave, const StatorGeometry &stator);
} // namespace ringmotor
