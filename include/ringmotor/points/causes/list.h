// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/error_cause.h>

namespace ringmotor
{
  /** What makes each of all_error_causes(), in a file of its own. */
  namespace causes
  {
    std::unique_ptr<const ErrorCause> of_meshes();
    std::unique_ptr<const ErrorCause> of_modes();
    std::unique_ptr<const ErrorCause> of_time_step();
    std::unique_ptr<const ErrorCause> of_scheme();
    std::unique_ptr<const ErrorCause> of_window();
    std::unique_ptr<const ErrorCause> of_wave();
    std::unique_ptr<const ErrorCause> of_effects();
    std::unique_ptr<const ErrorCause> of_algebra();
  } // namespace causes
} // namespace ringmotor
