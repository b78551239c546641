// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/mesh_file.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/prm_file.h>

#include <deal.II/base/numbers.h>

#include <sstream>

namespace ringmotor
{
  namespace
  {
    std::string text(const double number)
    {
      std::ostringstream out;
      out.precision(8);
      out << number;
      return out.str();
    }
  } // namespace

  void MeshFile::refuse(const std::string &found, const std::string &what_to_do) const
  {
    throw UserError("Stator/Mesh file = " + in_quotes(name) + ": " + found + "; " + what_to_do +
                    (note.empty() ? "" : "; " + note));
  }

  void MeshFile::refuse_place(const double distance, const std::string &found,
                              const std::string &what_to_do) const
  {
    // Two nodes, each off by half a unit of the last digit in two coordinates, that of 1.000 being
    // the coarsest.
    const double by_rounding = 2. * std::pow(10., 1. - n_digits);
    if (distance > by_rounding)
      refuse(found, what_to_do);
    const int n_needed = 1 + static_cast<int>(std::ceil(std::log10(2. / places::file_rounding)));
    refuse(found + ", but the coordinates have " + std::to_string(n_digits) +
               " significant digits only",
           "save at least " + std::to_string(n_needed) + " digits (Gmsh saves 16)");
  }

  std::string in_degrees(const double angle)
  {
    return text(angle * 180. / dealii::numbers::PI) + " degrees";
  }

  std::string in_metres(const double length)
  {
    return text(length) + " m";
  }

  std::string in_micrometres(const double length)
  {
    return text(1e6 * length) + " um";
  }

  std::string in_millimetres(const double length)
  {
    return text(1e3 * length) + " mm";
  }

  std::string in_words(const dealii::Point<3> &place)
  {
    return "r = " + in_millimetres(place[0]) + ", theta = " + in_degrees(place[1]) +
           ", z = " + in_millimetres(place[2]);
  }
} // namespace ringmotor
