// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace ringmotor
{
  /**
   * Says @p words on standard error if the user stops the program (Ctrl-C) or the system asks it to
   * end, which it then does at once, as by the signal. To be called again with other words when
   * there is something else to say.
   */
  void tell_when_interrupted(const std::string &words);
} // namespace ringmotor
