// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/operation.h>

#include <functional>

namespace ringmotor
{
  /** The status of a contact point in a step. */
  enum class PointStatus : unsigned char
  {
    open,
    stick,
    slip
  };

  /** The memory that a contact point has of earlier steps; each law depends on a part of it. */
  struct FrictionMemory
  {
    bool stuck     = false; ///< it stuck at the end of the last step
    double slipped = 0.;    ///< m, how far it has slipped since it last stuck or came into contact

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &stuck &slipped;
    }
  };

  /** A coefficient of friction and how it changes with the slip of the step. */
  struct FrictionCoefficient
  {
    double value      = 0.;
    double derivative = 0.; ///< 1/m, by the length of the slip
  };

  /**
   * The coefficient of friction of a contact point that slips by @p slip (m, not negative) in a
   * step of @p time_step (s), by the chosen law; for zero slip it is the limit up to which the
   * point sticks. See FrictionLawBase::coefficient().
   */
  FrictionCoefficient friction_coefficient(const Friction &friction, const FrictionMemory &memory,
                                           const double slip, const double time_step);

  /** The coefficient of friction of a point for a slip (m, not negative). */
  using PointFriction = std::function<FrictionCoefficient(unsigned int point, double slip)>;
} // namespace ringmotor
