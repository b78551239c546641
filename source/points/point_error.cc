// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/point_error.h>
#include <ringmotor/points/point_quantities.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  double &PointError::operator[](const std::string &quantity)
  {
    Assert(quantity_named(quantity).error_of == quantity,
           dealii::ExcMessage(quantity + " has no error bar of its own"));
    return numbers[quantity];
  }

  double PointError::operator[](const std::string &quantity) const
  {
    const auto number = numbers.find(quantity);
    return number == numbers.end() ? 0. : number->second;
  }

  PointError &PointError::operator*=(const double factor)
  {
    for (auto &[quantity, number] : numbers)
      number *= factor;
    return *this;
  }

  PointError &PointError::operator+=(const PointError &other)
  {
    for (const auto &[quantity, number] : other.numbers)
      numbers[quantity] += number;
    return *this;
  }

  PointError &PointError::add_independent(const PointError &other)
  {
    for (const auto &[quantity, number] : other.numbers)
      numbers[quantity] = std::hypot(numbers[quantity], number);
    return *this;
  }

  PointError &PointError::raise(const PointError &least)
  {
    for (const auto &[quantity, number] : least.numbers)
      numbers[quantity] = std::max(numbers[quantity], number);
    return *this;
  }

  PointError operator*(const double factor, PointError error)
  {
    return error *= factor;
  }

  PointError operator+(PointError one, const PointError &other)
  {
    return one += other;
  }
} // namespace ringmotor
