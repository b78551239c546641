// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/laws/list.h>

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

  const std::vector<FrictionLawEntry> &friction_law_entries()
  {
    static const std::vector<FrictionLawEntry> entries = []
    {
      std::vector<FrictionLawEntry> all;
      for (const auto &law : all_friction_laws())
        all.push_back(law->entry);
      return all;
    }();
    return entries;
  }

  const FrictionLawBase &law_of(const Friction &friction)
  {
    return *all_friction_laws()[friction.law.index()];
  }

  bool has_static_excess(const Friction &friction)
  {
    return friction.law.entry().has_static_coefficient &&
           friction.static_coefficient != friction.dynamic_coefficient;
  }

  FrictionCoefficient friction_coefficient(const Friction &friction, const FrictionMemory &memory,
                                           const double slip, const double time_step)
  {
    return law_of(friction).coefficient(friction, memory, slip, time_step);
  }
} // namespace ringmotor
