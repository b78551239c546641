// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace ringmotor
{
  /**
   * A mistake in the input of the user: a parameter file, a mesh file, a folder, the command line.
   * The message is one line that names the entry as `Section/Entry`, what was found, what is
   * allowed and what to do. Programs print it and end with exit status 1.
   */
  class UserError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * A computation that did not deliver the requested result. The message says what was tried.
   * Programs print it and end with exit status 2.
   */
  class ComputationError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace ringmotor
