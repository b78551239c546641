// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/friction.h>
#include <ringmotor/parameters/part_list.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace ringmotor
{
  /**
   * A law of friction: the entries that it needs, its coefficient, and how marching and the search
   * for a steady state treat the memory of its points. One class for each, in
   * contact/laws; all_friction_laws() is the list. Laws have no state of their own.
   */
  class FrictionLawBase
  {
  public:
    explicit FrictionLawBase(const FrictionLawEntry &entry) : entry(entry) {}
    virtual ~FrictionLawBase() = default;

    /** Checks the entries that this law needs besides the coefficients. @throws UserError */
    virtual void check(const Friction &) const {}

    /** The largest coefficient that a point can have. */
    double largest_coefficient(const Friction &friction) const
    {
      return entry.has_static_coefficient
                 ? std::max(friction.static_coefficient, friction.dynamic_coefficient)
                 : friction.dynamic_coefficient;
    }

    /**
     * The coefficient of a point that slips by @p slip (m, not negative) in a step of @p time_step
     * (s), and its derivative by the slip; for zero slip it is the limit up to which the point
     * sticks. A jump within a step has no derivative: see lose_static_limit().
     */
    virtual FrictionCoefficient coefficient(const Friction &friction, const FrictionMemory &memory,
                                            const double slip, const double time_step) const = 0;

    /**
     * Marching: lets a point drop to the dynamic coefficient if it has exceeded its static limit
     * within the step, which is then solved again. Limits are only lost, never gained, so this
     * terminates.
     * @param status of the point in the solution with @p memory
     * @return whether @p memory has changed
     */
    virtual bool lose_static_limit(const PointStatus /*status*/, FrictionMemory & /*memory*/) const
    {
      return false;
    }

    /**
     * The steady state, which is solved again until the assumed memory of its points agrees with
     * what happened: changes @p memory, assumed in this solution, to that for the next one.
     * @param found the memory one step earlier, of the point that represents this one at that time,
     * as far as it is foreseen for the next solution
     * @param status of the point in this solution
     * @param is_refused whether the point gets no static limit any more, so that the search ends
     * @return whether @p memory agreed with @p found as far as this law depends on it
     */
    virtual bool settle(const Friction & /*friction*/, const FrictionMemory & /*found*/,
                        const PointStatus /*status*/, const bool /*is_refused*/,
                        FrictionMemory & /*memory*/) const
    {
      return true;
    }

    /** Whether two memories are the same as far as this law depends on them. */
    virtual bool agree(const Friction & /*friction*/, const FrictionMemory &one,
                       const FrictionMemory &other) const
    {
      return one.stuck == other.stuck;
    }

    /** Whether memories may alternate or wander without end: then the state is taken that has been
     * found, and its error is the range of those that follow. */
    virtual bool may_wander() const { return false; }

    /** Whether the search for a steady state starts with a chain of states with given coefficients,
     * which follow from the slip and memory of the previous state; see GivenCoefficients. */
    virtual bool starts_from_given_coefficients() const { return false; }

    /** What a user can do where no steady state is found because of this law: the end of a
     * sentence, from its semicolon on, or nothing. */
    virtual std::string remedy() const { return {}; }

    const FrictionLawEntry entry;
  };

  /** All of them, in the order of their entries. */
  const PartList<FrictionLawBase> &all_friction_laws();

  /** The class of the chosen law. */
  const FrictionLawBase &law_of(const Friction &friction);

  /** Whether the friction limit of sticking points differs from that of slipping points. */
  bool has_static_excess(const Friction &friction);
} // namespace ringmotor
