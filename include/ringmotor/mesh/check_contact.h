// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace ringmotor
{
  struct Parameters;

  /**
   * Checks the bodies of a motor for the program contact, whether they come from dimensions or from
   * sections: both have level faces in contact that overlap, the rotor does not cut into the
   * stator, is pressed and driven and free to turn, and points of the output lie where the bodies
   * touch.
   * @throws UserError that names the entries, also for sections that cannot be read
   */
  void check_bodies_in_contact(const Parameters &parameters);

  /**
   * The same for the program losses, which also needs the loss factors of all parts.
   * @returns warnings, one line each
   */
  std::vector<std::string> check_bodies_for_losses(const Parameters &parameters);
} // namespace ringmotor
