// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/response_file.h>
#include <ringmotor/output/table.h>
#include <ringmotor/output/text.h>

#include <algorithm>

namespace ringmotor
{
  void write_responses(const std::string &path, const std::vector<FrequencyResponse> &responses)
  {
    std::vector<NamedRow> rows;
    for (const FrequencyResponse &response : responses)
      for (const ResponsePoint &point : response.points)
      {
        rows.emplace_back();
        add_entries(rows.back(), {{"torque", units::torque, response.torque},
                                  {"amplitude", units::amplitude, point.amplitude},
                                  {"frequency", units::hertz, point.frequency},
                                  {"speed", units::speed, point.speed},
                                  {"motional_conductance", units::conductance, point.conductance},
                                  {"motional_susceptance", units::conductance, point.susceptance}});
        rows.back().emplace_back("state", point.is_stable ? "stable" : "unstable");
      }
    write_table(path, rows);
  }

  std::string describe(const FrequencyResponse &response)
  {
    const auto peak      = std::max_element(response.points.begin(), response.points.end(),
                                            [](const ResponsePoint &one, const ResponsePoint &other)
                                            { return one.amplitude < other.amplitude; });
    const auto kilohertz = [](const ResponsePoint &point) {
      return text(1e-3 * point.frequency, {"kHz", "kHz", 1.}, 3);
    };
    std::string line = "response to the frequency at " + text(1e3 * response.torque, 2) + " mN m: ";
    if (peak == response.points.end())
      return line + "none (" + response.end + ")";
    line += "largest amplitude " + text(1e6 * peak->amplitude, 2) + " um at " + kilohertz(*peak);
    if (const ResponsePoint *const lost = response.loses())
      line += "; a falling frequency loses the wave at " + kilohertz(*lost);
    if (const ResponsePoint *const regained = response.regains())
      line += ", a rising one regains it at " + kilohertz(*regained);
    if (!response.end.empty())
      line += "; no state below " + text(1e6 * response.points.front().amplitude, 2) + " um (" +
              response.end + ")";
    return line;
  }
} // namespace ringmotor
