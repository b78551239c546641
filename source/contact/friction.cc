// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/laws/list.h>

namespace ringmotor
{
  const PartList<FrictionLawBase> &all_friction_laws()
  {
    static const PartList<FrictionLawBase> list = made_by<FrictionLawBase>(
        {laws::coulomb, laws::static_dynamic, laws::velocity, laws::slip_weakening});
    return list;
  }

  const std::vector<FrictionLawEntry> &friction_law_entries()
  {
    static const auto entries = entries_of<FrictionLawEntry>(all_friction_laws());
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
