// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/run_control.h>

namespace ringmotor
{
  /**
   * Who may spend which part of the targets of `Accuracy`: everything that is decided by such a
   * part, in one place.
   */
  class AccuracyBudget
  {
  public:
    explicit AccuracyBudget(const Accuracy &accuracy)
        : contact(accuracy.contact_target), strictest(accuracy.strictest_target())
    {
    }

    /** The relative error that the results may have. */
    double whole() const { return contact; }
    /** The error of the stator's wave, which changes all results. */
    double wave() const { return 0.2 * strictest; }
    /** An effect that is left out, of the @p target of its program: the more, the more it costs.
     * @param times by which it would multiply the time of each point */
    static double effect(const double target, const double times = 1.)
    {
      return times / (times + 2.) * target;
    }
    /** All effects together that are left out: everything else, which is independent of them, may
     * have two thirds of the target. */
    static double left_out(const double target) { return 0.75 * target; }
    /** The meshes alone, on which short steps and varied motors are worth their cost. */
    double meshes() const { return 0.9 * contact; }
    /** How closely the means of a marched motor must settle. */
    double marched_means() const { return 0.1 * strictest; }
    /** The same where they wander, so that half the error takes four times the steps. */
    double wandering_means() const { return 0.3 * strictest; }
    /** The speed of a rotor that stands still, over the scale of speeds. */
    double standstill() const { return contact; }

    /** Steps in a period with which differences between meshes are known to a fraction of the
     * target. Long steps make contact begin and end in jumps, on each mesh at other places: with 90
     * steps speeds scatter by 0.4 %, with 180 by half of that; several times as much with inertia.
     */
    double steps_to_compare_with(const bool has_inertia) const
    {
      return (has_inertia ? 5. : 1.2) / strictest;
    }
    /** The level of the modes of rotor and teeth that is likely to suffice: the errors of level 2
     * are seldom known to be below one per cent. */
    unsigned int modes_level() const { return contact >= 0.08 ? 1 : contact >= 0.013 ? 2 : 3; }

  private:
    double contact, strictest;
  };
} // namespace ringmotor
