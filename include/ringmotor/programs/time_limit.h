// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace ringmotor
{
  /**
   * Ends the program with exit status 2 once `Accuracy/Time limit` is exceeded, at any moment: a
   * single operating point may take much longer than the limit. What is kept by then stays valid,
   * as after an interruption. It ends with the object, so that results are written as a whole.
   */
  class TimeLimit
  {
  public:
    /** Does nothing without a limit, or on another rank than the first one.
     * @param advice what the user can do, for the message */
    TimeLimit(const std::string &program, const Parameters &parameters, const std::string &advice);
    ~TimeLimit();
    TimeLimit(const TimeLimit &)            = delete;
    TimeLimit &operator=(const TimeLimit &) = delete;

  private:
    void wait(const double seconds, const std::string &program, const std::string &noted_in,
              const std::string &advice);

    std::mutex mutex;
    std::condition_variable changed;
    bool is_over = false;
    std::thread watch;
  };
} // namespace ringmotor
