// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <array>
#include <complex>

// The half of a sector that is not meshed is the mirror image of the other one at theta = 0. A wave
// moves it by U(-theta) = S conj(U(theta)), where S reverses the component along theta: the second
// of (x, y, z), (r, theta, z) and (normal, along, radial) alike.

namespace ringmotor
{
  /** An entry of S. */
  inline double mirror_sign(const unsigned int component)
  {
    return component == 1 ? -1. : 1.;
  }

  inline dealii::Point<2> mirrored(const dealii::Point<2> &point)
  {
    return {point[0], -point[1]};
  }

  inline dealii::Point<3> mirrored(const dealii::Point<3> &point)
  {
    return {point[0], -point[1], point[2]};
  }

  /** The amplitude of a wave at the mirrored position. */
  inline std::array<std::complex<double>, 3>
  mirrored(const std::array<std::complex<double>, 3> &amplitude)
  {
    return {{std::conj(amplitude[0]), -std::conj(amplitude[1]), std::conj(amplitude[2])}};
  }
} // namespace ringmotor
