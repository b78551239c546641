// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/condensation/condensation.h>

// Internal to the source files of Condensation.

namespace ringmotor
{
  /** How the rows of both condensed fields follow from the unknowns of a nodal diameter. */
  struct Condensation::Tied
  {
    /** An entry of a real field is the sum of factor * unknown over some of these. */
    struct Part
    {
      unsigned int place; ///< of the unknown
      double factor;
    };
    std::array<std::vector<std::vector<Part>>, 2> rows; ///< by field and row of its matrix
    std::vector<unsigned int> supports;                 ///< places; none where they are free
    unsigned int size = 0;                              ///< number of unknowns

    /** Unknowns, by their places, with coefficients. */
    using Sum = std::vector<std::pair<unsigned int, double>>;

    /** Linear forms over the real field, then over the imaginary one. */
    std::vector<Sum> in_places(const std::vector<LinearForm> &forms,
                               const std::array<Field, 2> &fields) const
    {
      std::vector<Sum> sums;
      for (const unsigned int part : {0u, 1u})
        for (const LinearForm &form : forms)
        {
          sums.emplace_back();
          for (const auto &[dof, coefficient] : form)
            if (const unsigned int row = fields[part].row_of_dof[dof];
                row != dealii::numbers::invalid_unsigned_int)
              for (const auto &[place, factor] : rows[part][row])
                sums.back().emplace_back(place, coefficient * factor);
        }
      return sums;
    }
  };
} // namespace ringmotor
