// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/body_origin.h>

#include <deal.II/base/types.h>

#include <functional>

namespace ringmotor
{
  // What the parameters have to give for the parts and faces of a body from a file.

  /** @throws UserError for a part without material */
  void check_materials(const Parameters &parameters, const BodyOrigin &origin,
                       const std::function<bool(dealii::types::material_id)> &has_part);

  /** @throws UserError if a felt touches nothing */
  void check_felt(const Parameters &parameters, const BodyOrigin &origin, const bool has_face);

  /** N/m^3, of bars over the @p height (m) of the faces that hold them, 0 without these.
   * @throws UserError for bars without stiffness or the other way round */
  double bar_stiffness(const Parameters &parameters, const BodyOrigin &origin, const double height);
} // namespace ringmotor
