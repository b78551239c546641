// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/body_shape.h>

namespace ringmotor
{
  // The kinds of shapes, between which stator_shape() and rotor_shape() choose.

  /** The body of the dimensions or of the section, revolved. @throws UserError see stator_body() */
  std::unique_ptr<const StatorShape> revolved_stator(const Parameters &parameters);
  std::unique_ptr<const RotorShape> revolved_rotor(const Parameters &parameters);

  /** The body of the file of one sector. @throws UserError see read_sector() */
  std::unique_ptr<const StatorShape> read_stator(const Parameters &parameters);
  std::unique_ptr<const RotorShape> read_rotor(const Parameters &parameters);
} // namespace ringmotor
