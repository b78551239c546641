// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/laws/list.h>

namespace ringmotor::laws
{
  namespace
  {
    /** mu_d always. */
    class Coulomb : public FrictionLawBase
    {
    public:
      Coulomb() : FrictionLawBase({"coulomb", "one coefficient (the dynamic one)", false}) {}

      FrictionCoefficient coefficient(const Friction &friction, const FrictionMemory &,
                                      const double, const double) const override
      {
        return {friction.dynamic_coefficient, 0.};
      }
    };
  } // namespace

  LawPointer coulomb()
  {
    return std::make_unique<const Coulomb>();
  }
} // namespace ringmotor::laws
