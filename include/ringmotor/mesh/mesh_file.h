// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <string>

namespace ringmotor
{
  /** A mesh file that its user may have to mend. */
  struct MeshFile
  {
    std::string name;
    std::string entry;          ///< that names it, "Stator/Mesh file"
    std::string format;         ///< of its cells, and where it is described
    unsigned int n_digits = 17; ///< significant digits of the coordinate that has most
    std::string note      = {}; ///< what else may be the cause of all mistakes, or nothing

    /** Refuses the file: what was @p found in it, and @p what_to_do. @throws UserError */
    [[noreturn]] void refuse(const std::string &found, const std::string &what_to_do) const;

    /** The same for nodes that are off by @p distance, over the largest radius: if that can come
     * from rounding, the file has too few digits. @throws UserError */
    [[noreturn]] void refuse_place(const double distance, const std::string &found,
                                   const std::string &what_to_do) const;
  };

  /** For messages */
  std::string in_degrees(const double angle);
  std::string in_metres(const double length);
  std::string in_millimetres(const double length);
  std::string in_micrometres(const double length);
  /** Of a place (r, theta, z). */
  std::string in_words(const dealii::Point<3> &place);
} // namespace ringmotor
