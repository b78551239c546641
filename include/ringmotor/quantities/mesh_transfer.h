// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/quantities/contact_fields.h>

namespace ringmotor
{
  /**
   * A state on the contact points of one mesh as a start on those of another mesh of the same
   * motor. Forces go to the nearest points, in proportion to their areas, so that no force is lost;
   * motion and status are those of the nearest point. Displacements are left out.
   */
  ContactFields transferred(const ContactFields &fields, const CondensedMotor &from,
                            const CondensedMotor &to);
} // namespace ringmotor
