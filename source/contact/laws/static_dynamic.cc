// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/laws/list.h>

namespace ringmotor::laws
{
  namespace
  {
    /** mu_s for a point that stuck at the end of the last step, mu_d for one that slipped (eqs. 3-6
     * of Maeno 1992). */
    class StaticDynamic : public FrictionLawBase
    {
    public:
      StaticDynamic()
          : FrictionLawBase({"static-dynamic", "a jump from the static to the dynamic one"})
      {
      }

      FrictionCoefficient coefficient(const Friction &friction, const FrictionMemory &memory,
                                      const double, const double) const override
      {
        const double dynamic = friction.dynamic_coefficient;
        const double excess  = friction.static_coefficient - dynamic;
        return {memory.stuck ? dynamic + excess : dynamic, 0.};
      }

      /** A point that slips drops to mu_d and stays there. */
      bool lose_static_limit(const PointStatus status, FrictionMemory &memory) const override
      {
        if (!memory.stuck || status != PointStatus::slip)
          return false;
        memory.stuck = false;
        return true;
      }

      /** More than one memory is self-consistent. A point that slips loses mu_s; one without it
       * whose predecessor stuck gets it, unless it is refused, so that the search terminates. */
      bool settle(const Friction &friction, const FrictionMemory &found, const PointStatus status,
                  const bool is_refused, FrictionMemory &memory) const override
      {
        if (status == PointStatus::open ||
            friction.static_coefficient == friction.dynamic_coefficient)
          return true;
        const bool sticks =
            memory.stuck ? found.stuck && status == PointStatus::stick : found.stuck && !is_refused;
        const bool agreed = sticks == memory.stuck;
        memory.stuck      = sticks;
        return agreed;
      }
    };
  } // namespace

  LawPointer static_dynamic()
  {
    return std::make_unique<const StaticDynamic>();
  }
} // namespace ringmotor::laws
