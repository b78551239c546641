// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/output/log.h>
#include <ringmotor/points/discretisation.h>

#include <string>

namespace ringmotor
{
  /** Before anything is computed, and again when its effects are chosen. @throws UserError for a
   * motor whose sensitivities are not computed */
  void check_for_sensitivities(const Parameters &parameters);

  /**
   * Computes how the entries of a motor change its results, logs the largest changes and writes
   * `sensitivities.csv`. Collective.
   * @param parameters without effects of the contact that are `auto`
   * @param common the discretisation of all motors
   * @param folder of the results, which exists; ends in a slash
   */
  void run_sensitivities(const std::string &folder, const Parameters &parameters,
                         const Discretisation &common, Log &log);
} // namespace ringmotor
