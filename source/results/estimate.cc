// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/results/estimate.h>

#include <cmath>

namespace ringmotor
{
  namespace
  {
    /** Adds @p factor times the errors of another number. */
    void add(Estimate::Errors &errors, const double factor, const Estimate &other)
    {
      for (const auto &[cause, error] : other.errors)
        errors[cause] += std::abs(factor) * error;
    }
  } // namespace

  double Estimate::error() const
  {
    double squares = 0.;
    for (const auto &[cause, error] : errors)
      squares += error * error;
    return std::sqrt(squares);
  }

  double Estimate::relative_error() const
  {
    return value == 0. ? 0. : error() / std::abs(value);
  }

  Estimate Estimate::relative() const
  {
    Estimate relative(1.);
    if (value != 0.)
      add(relative.errors, 1. / value, *this);
    return relative;
  }

  Estimate &Estimate::operator+=(const Estimate &other)
  {
    value += other.value;
    add(errors, 1., other);
    return *this;
  }

  Estimate operator+(Estimate one, const Estimate &other)
  {
    return one += other;
  }

  Estimate operator-(const Estimate &one, const Estimate &other)
  {
    return one + -1. * other;
  }

  Estimate operator*(const Estimate &one, const Estimate &other)
  {
    Estimate product(one.value * other.value);
    add(product.errors, other.value, one);
    add(product.errors, one.value, other);
    return product;
  }

  Estimate operator/(const Estimate &one, const Estimate &other)
  {
    Estimate quotient(one.value / other.value);
    add(quotient.errors, 1. / other.value, one);
    add(quotient.errors, quotient.value / other.value, other);
    return quotient;
  }
} // namespace ringmotor
