// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace ringmotor
{
  /**
   * Keeps other programs out of the folder of a case while one works there: their results would
   * belong to different motors. The system releases the lock when the process ends, for whatever
   * reason. To be used on MPI rank 0 only.
   */
  class CaseLock
  {
  public:
    /**
     * Makes the folder if it is missing.
     * @throws UserError if another program is at work in it, or if it cannot be made
     */
    explicit CaseLock(const std::string &folder);
    /** Removes a folder that was made here and has stayed empty. */
    ~CaseLock();
    CaseLock(const CaseLock &)            = delete;
    CaseLock &operator=(const CaseLock &) = delete;

  private:
    const std::string folder;
    const bool is_new;
    int descriptor;
  };
} // namespace ringmotor
