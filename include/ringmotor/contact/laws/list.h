// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/friction_law.h>

namespace ringmotor::laws
{
  using LawPointer = std::unique_ptr<const FrictionLawBase>;

  LawPointer coulomb();
  LawPointer static_dynamic();
  LawPointer velocity();
  LawPointer slip_weakening();
} // namespace ringmotor::laws
