// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace ringmotor
{
  struct Parameters;

  /** The bodies that a file can describe. */
  enum class BodyOf
  {
    stator,
    rotor
  };

  /** What describes a body, for messages to whoever wrote it. */
  struct BodyOrigin
  {
    std::string entry;      ///< that names the file, "Stator/Mesh file"
    std::string file;       ///< empty: dimensions
    bool is_sector = false; ///< the file is a mesh of a sector, not a section

    bool has_dimensions() const { return file.empty(); }
    /** `Stator/Mesh file = "..."` */
    std::string text() const;
    /** What has names in the file besides parts: "curve" or "surface". */
    std::string face() const { return is_sector ? "surface" : "curve"; }
    /** `Physical Curve("contact")` */
    std::string naming_of_face(const std::string &name) const;
    /** `Physical Volume("tooth")` */
    std::string naming_of_part(const std::string &name) const;

    /** Refuses the file. @throws UserError of what was @p found in it, and @p what_to_do */
    [[noreturn]] void refuse(const std::string &found, const std::string &what_to_do) const;
  };

  /** What describes the stator or the rotor of a motor. */
  BodyOrigin origin_of(const Parameters &parameters, const BodyOf body);

  /** The same of `Modes/Body`. */
  BodyOrigin origin_of_modes(const Parameters &parameters);
} // namespace ringmotor
