// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/check_parts.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/section.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/parameters/required.h>
#include <ringmotor/parameters/short_text.h>

namespace ringmotor
{
  void check_materials(const Parameters &parameters, const BodyOrigin &origin,
                       const std::function<bool(dealii::types::material_id)> &has_part)
  {
    for (const auto &[part, material] : {std::make_pair(ids::piezoceramic, "Piezoceramic"),
                                         {ids::lining, "Lining"},
                                         {ids::adhesive, "Adhesive"}})
      if (has_part(part))
        for (const char *const constant : {"Young modulus", "Poisson ratio", "Density"})
          check_given(parameters, origin.entry + " has the part '" + name_of_part(part) + "'",
                      {std::string("Materials/") + material + "/" + constant});
  }

  void check_felt(const Parameters &parameters, const BodyOrigin &origin, const bool has_face)
  {
    if (parameters.support.has_felt() && !has_face &&
        parameters.effects["Felt support"] != EffectChoice::off)
      throw UserError("the section Support has a felt, but " + origin.entry + " has no " +
                      origin.face() + " 'felt' that lies on it; name it, " +
                      origin.naming_of_face("felt") + ", or set Effects/Felt support = off");
  }

  double bar_stiffness(const Parameters &parameters, const BodyOrigin &origin, const double height)
  {
    const std::string entry = "Rotor/Radial bar stiffness";
    const double stiffness  = parameters.rotor.radial_bar_stiffness;
    if (height > 0.)
    {
      check_given(parameters, origin.entry + " has the " + origin.face() + " 'bars'", {entry});
      return stiffness / height;
    }
    if (missing_entries(parameters, {entry}).empty() && stiffness > 0.)
      throw UserError(entry + " = " + short_text(stiffness) + ", but " + origin.entry + " has no " +
                      origin.face() + " 'bars'; name it, " + origin.naming_of_face("bars") +
                      ", or give 0");
    return 0.;
  }
} // namespace ringmotor
