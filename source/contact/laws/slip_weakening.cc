// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/laws/list.h>
#include <ringmotor/parameters/errors.h>

#include <algorithm>
#include <cmath>

namespace ringmotor::laws
{
  namespace
  {
    /** From mu_s to mu_d, linearly in the slipped distance, over the weakening length. */
    class SlipWeakening : public FrictionLawBase
    {
    public:
      SlipWeakening() : FrictionLawBase({"slip-weakening", "a decay over a sliding length"}) {}

      void check(const Friction &friction) const override
      {
        if (!friction.weakening_length)
          throw UserError("Friction/Law = slip-weakening needs Friction/Weakening length, which is "
                          "not set; give it in m");
      }

      FrictionCoefficient coefficient(const Friction &friction, const FrictionMemory &memory,
                                      const double slip, const double) const override
      {
        const double dynamic = friction.dynamic_coefficient;
        const double excess  = friction.static_coefficient - dynamic;
        const double left    = 1. - (memory.slipped + slip) / *friction.weakening_length;
        if (left <= 0.)
          return {dynamic, 0.};
        return {dynamic + left * excess, -excess / *friction.weakening_length};
      }

      /** The slipped distances must agree to a small fraction of the weakening length, beyond which
       * they do not matter. */
      bool settle(const Friction &friction, const FrictionMemory &found, const PointStatus,
                  const bool, FrictionMemory &memory) const override
      {
        const bool agreed = agree(friction, found, memory);
        memory            = found;
        return agreed;
      }

      /** A point that just sticks forgets how far it has slipped, those behind it get a larger
       * coefficient, and it slips: such a passage has no memory that agrees with itself. */
      bool may_wander() const override { return true; }

      bool agree(const Friction &friction, const FrictionMemory &one,
                 const FrictionMemory &other) const override
      {
        const double length = *friction.weakening_length;
        return std::abs(std::min(one.slipped, length) - std::min(other.slipped, length)) <=
               1e-9 * length;
      }

      bool starts_from_given_coefficients() const override { return true; }

      std::string remedy() const override
      {
        return "; friction that decreases with the slip can make teeth stick and slip in turn, "
               "without a steady state: try Time/Scheme = marching";
      }
    };
  } // namespace

  LawPointer slip_weakening()
  {
    return std::make_unique<const SlipWeakening>();
  }
} // namespace ringmotor::laws
