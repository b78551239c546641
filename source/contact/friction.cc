// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <ringmotor/contact/laws/list.h>

#include <algorithm>

namespace ringmotor
{
  namespace
  {
    std::vector<std::unique_ptr<const FrictionLawBase>> make_laws()
    {
      std::vector<std::unique_ptr<const FrictionLawBase>> list;
      for (const auto make :
           {laws::coulomb, laws::static_dynamic, laws::velocity, laws::slip_weakening})
        list.push_back(make());
      return list;
    }
  } // namespace

  const std::vector<std::unique_ptr<const FrictionLawBase>> &all_friction_laws()
  {
    static const std::vector<std::unique_ptr<const FrictionLawBase>> list = make_laws();
    return list;
  }

  const FrictionLawBase &law_of(const Friction &friction)
  {
    const auto &laws = all_friction_laws();
    const auto found = std::find_if(laws.begin(), laws.end(),
                                    [&](const auto &law) { return law->word == friction.law; });
    AssertThrow(found != laws.end(), dealii::ExcMessage("Friction/Law has a word without a class"));
    return **found;
  }

  bool has_static_excess(const Friction &friction)
  {
    return law_of(friction).has_static_coefficient() &&
           friction.static_coefficient != friction.dynamic_coefficient;
  }

  FrictionCoefficient friction_coefficient(const Friction &friction, const FrictionMemory &memory,
                                           const double slip, const double time_step)
  {
    return law_of(friction).coefficient(friction, memory, slip, time_step);
  }
} // namespace ringmotor
