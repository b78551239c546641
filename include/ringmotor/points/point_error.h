// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>

#include <map>
#include <string>

namespace ringmotor
{
  /** Errors of the quantities of an operating point, or its change to another one, in SI units; by
   * the names of those point_quantities() that have error bars of their own. */
  class PointError
  {
  public:
    PointError(const std::map<std::string, double> &numbers = {}) : numbers(numbers) {}

    double &operator[](const std::string &quantity);
    /** 0 if it has not been set. */
    double operator[](const std::string &quantity) const;

    PointError &operator*=(const double factor);
    PointError &operator+=(const PointError &other);
    /** Adds an error of an independent cause: the squares add up. */
    PointError &add_independent(const PointError &other);
    /** Raises each number to at least that of @p least. */
    PointError &raise(const PointError &least);

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &numbers;
    }

  private:
    std::map<std::string, double> numbers;
  };

  PointError operator*(const double factor, PointError error);
  PointError operator+(PointError one, const PointError &other);
} // namespace ringmotor
