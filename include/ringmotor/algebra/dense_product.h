// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace ringmotor
{
  enum class Transposed
  {
    no,
    yes
  };

  /** result += factor * a b, or a^T b, for dense matrices by columns; @p b has @p n_inner rows.
   * Fast for few columns, too, where a general product would spend its time on copying a. */
  void add_product(const double factor, const Transposed transposed, const std::vector<double> &a,
                   const std::size_t n_inner, const std::vector<double> &b,
                   std::vector<double> &result);
} // namespace ringmotor
