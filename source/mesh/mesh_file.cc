// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/mesh_file.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/prm_file.h>

#include <deal.II/base/exceptions.h>
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
    throw UserError(entry + " = " + in_quotes(name) + ": " + found + "; " + what_to_do +
                    (note.empty() ? "" : "; " + note));
  }

  void MeshFile::refuse_place(const double distance, const std::string &found,
                              const std::string &what_to_do) const
  {
    // Two nodes, each off by half a unit of the last digit in two coordinates, that of 1.000 being
    // the coarsest.
    const auto by_rounding      = [](const double n) { return 2. * std::pow(10., 1. - n); };
    const unsigned int n_needed = 8;
    Assert(by_rounding(n_needed) < places::file_rounding, dealii::ExcInternalError());
    if (n_digits >= n_needed || distance > by_rounding(n_digits))
      refuse(found, what_to_do);
    refuse(found + ", but the coordinates have " + std::to_string(n_digits) +
               (n_digits == 1 ? " significant digit only" : " significant digits only"),
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
