// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/frequency_response.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /** `response.csv`: all states at the given voltage, by torque and along each curve. */
  void write_responses(const std::string &path, const std::vector<FrequencyResponse> &responses);

  /** In one line: the peak, where sweeps lose and regain the wave, and how far the curve reaches.
   */
  std::string describe(const FrequencyResponse &response);
} // namespace ringmotor
