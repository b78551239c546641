// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace ringmotor
{
  /**
   * Prints @p words on standard error if the user stops the program (Ctrl-C) or the system asks it
   * to end; the program then ends immediately, as by the signal. Call it again to change the words.
   */
  void tell_when_interrupted(const std::string &words);

  /** Leaves the words out if a file of note_failure() is there: another rank has failed, said why,
   * and is ending this one, which has nothing to add. */
  void be_silent_after_failure(const std::string &file);
} // namespace ringmotor
