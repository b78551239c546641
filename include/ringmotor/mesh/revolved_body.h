// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/face_profile.h>
#include <ringmotor/mesh/section.h>
#include <ringmotor/mesh/slots.h>
#include <ringmotor/parameters/motor.h>

#include <optional>

namespace ringmotor
{
  struct Parameters;

  /** A body that is its cross-section, revolved, with slots. */
  struct RevolvedBody
  {
    Section section;
    Slots slots;
    double skin_thickness = 0.; ///< m, of a shell of ceramic bonded to the edges ids::skin; 0: none
    double shell_thickness = 0.; ///< m, of Section::shell
    /** m, what is thinnest at re-entrant corners, where dimensions tell; else edges do. */
    std::optional<double> thinnest = {};
    double bar_stiffness           = 0.; ///< N/m^3, of bars at the edges ids::radial_bars
    FaceProfile face{}; ///< of the edges in contact, which are level in the section
  };

  /** The stator that dimensions describe: a trapezoid of one cell for the base and one for the
   * tooth, and one for the ceramic ring below, which has vertical sides. */
  RevolvedBody stator_body(const StatorGeometry &stator, const unsigned int n_teeth);

  /** The stator of `Stator/Section file`, or of the dimensions.
   * @throws UserError for an unsuitable section, see read_section(), for slots that leave no teeth,
   * and for parts without material */
  RevolvedBody stator_body(const Parameters &parameters);

  /** The rotor that dimensions describe: a ring with a flange and its lip, all solid, or with a
   * flange that is a shell from half its thickness away from the ring on. z is the height above the
   * plane of the tooth tops. */
  RevolvedBody rotor_body(const RotorGeometry &rotor, const unsigned int n_teeth);

  /** The rotor of `Rotor/Section file`, or of the dimensions. @throws UserError as above, for bars
   * without stiffness and shells without thickness or the other way round, and for shells that are
   * not tied to the body, see shell_line() and name_shell_root() */
  RevolvedBody rotor_body(const Parameters &parameters);
} // namespace ringmotor
