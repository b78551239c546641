// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/condensation/condensation.h>

// Internal to the source files of Condensation.

namespace ringmotor
{
  /** What remains when the cut is eliminated: a dense symmetric matrix of the retained unknowns. */
  struct Condensation::Reduced
  {
    /** An entry of a real field is the sum of factor * unknown over some of these. */
    struct Part
    {
      unsigned int unknown;
      double factor;
    };
    std::array<std::vector<std::vector<Part>>, 2> rows; ///< by field and row of its matrix
    std::vector<unsigned int> place,
        cut_place; ///< of a retained unknown, and of an eliminated one, or none
    unsigned int size = 0, n_cut = 0;
    std::vector<double> matrix;       ///< by columns, both triangles
    std::vector<double> cut_response; ///< by columns: minus the response to retained unknowns

    /** Retained unknowns, by their places, with coefficients. */
    using Sum = std::vector<std::pair<unsigned int, double>>;

    /** A linear form over one field in terms of retained unknowns. */
    Sum in_places(const unsigned int part, const LinearForm &form, const Field &field) const
    {
      Sum sum;
      for (const auto &[dof, coefficient] : form)
        if (field.row_of_dof[dof] != dealii::numbers::invalid_unsigned_int)
          for (const Part &entry : rows[part][field.row_of_dof[dof]])
            sum.emplace_back(place[entry.unknown], coefficient * entry.factor);
      return sum;
    }

    /** The same for several forms, over the real field, then over the imaginary one. */
    std::vector<Sum> in_places(const std::vector<LinearForm> &forms,
                               const std::array<Field, 2> &fields) const
    {
      std::vector<Sum> sums;
      for (const unsigned int part : {0u, 1u})
        for (const LinearForm &form : forms)
          sums.push_back(in_places(part, form, fields[part]));
      return sums;
    }

    /** The matrix with some rows and columns replaced by those of the unit matrix. */
    std::vector<double> with_held(const std::vector<unsigned int> &held) const
    {
      std::vector<double> result = matrix;
      for (const std::size_t i : held)
      {
        for (std::size_t j = 0; j < size; ++j)
          result[i * size + j] = result[j * size + i] = 0.;
        result[i * size + i] = 1.;
      }
      return result;
    }
  };
} // namespace ringmotor
