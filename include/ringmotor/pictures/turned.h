// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace ringmotor
{
  /** A vector (a point, or complex) turned about the z axis. */
  template <typename VectorType>
  VectorType turned(const VectorType &vector, const double cosine, const double sine)
  {
    VectorType result = vector;
    result[0]         = cosine * vector[0] - sine * vector[1];
    result[1]         = sine * vector[0] + cosine * vector[1];
    return result;
  }
} // namespace ringmotor
