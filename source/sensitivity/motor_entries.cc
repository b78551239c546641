// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <ringmotor/parameters/assign.h>
#include <ringmotor/parameters/entries.h>
#include <ringmotor/sensitivity/motor_entries.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Sections that say how a motor is computed and what is written of it. */
    bool is_about_the_run(const std::string &path)
    {
      const std::string section = path.substr(0, path.find('/'));
      for (const char *const other :
           {"Modes", "Time", "Accuracy", "Uncertainty", "Effects", "Output"})
        if (section == other)
          return true;
      return false;
    }

    std::optional<double> number_in(const std::string &text)
    {
      char *end          = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      return end == text.c_str() || *end != '\0' ? std::nullopt : std::make_optional(value);
    }

    bool is_of(const std::string &body, const MotorEntry &entry)
    {
      return entry.path.rfind(body + "/", 0) == 0;
    }

    bool is_radius(const MotorEntry &entry)
    {
      return (is_of("Stator", entry) || is_of("Rotor", entry)) &&
             entry.path.find("radius") != std::string::npos;
    }

    constexpr double same = 1e-6; // relative

    /** Radii of the rotor that are radii of the stator, too, change with these. */
    void join_radii(std::vector<MotorEntry> &entries)
    {
      for (MotorEntry &entry : entries)
        for (auto other = entries.begin(); other != entries.end(); ++other)
          if (is_of("Stator", entry) && is_radius(entry) && entry.together.empty() &&
              is_of("Rotor", *other) && is_radius(*other) &&
              std::abs(other->value - entry.value) <= same * entry.value)
            entry.together = other->path;
      const auto changes_with_another = [&](const MotorEntry &entry)
      {
        return std::any_of(entries.begin(), entries.end(),
                           [&](const MotorEntry &other) { return other.together == entry.path; });
      };
      std::vector<MotorEntry> left;
      std::remove_copy_if(entries.begin(), entries.end(), std::back_inserter(left),
                          changes_with_another);
      entries = left;
    }

    /** Radii are large compared to what lies between them. */
    void set_scales_of_radii(std::vector<MotorEntry> &entries)
    {
      for (MotorEntry &entry : entries)
        for (const MotorEntry &other : entries)
        {
          const double distance = std::abs(other.value - entry.value);
          if (is_radius(entry) && is_radius(other) && distance > same * entry.value)
            entry.scale = std::min(entry.scale, distance);
        }
    }
  } // namespace

  std::vector<MotorEntry> motor_entries(const Parameters &parameters)
  {
    Parameters copy = parameters;
    ParameterHandler prm;
    copy.declare(prm);
    const DeclaredEntries declared(prm);
    std::vector<MotorEntry> entries;
    for (const auto &[path, text] : entries_of(parameters))
    {
      const std::string &units          = declared.find(path)->units;
      const std::optional<double> value = number_in(text);
      if (!units.empty() && value && *value != 0. && !is_about_the_run(path))
        entries.push_back({path, *value, units, std::abs(*value)});
    }
    join_radii(entries);
    set_scales_of_radii(entries);
    return entries;
  }

  Parameters with_entry(const Parameters &parameters, const MotorEntry &entry, const double value)
  {
    Parameters changed = parameters;
    ParameterHandler prm;
    changed.declare(prm);
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << value;
    std::vector<PrmFile::Assignment> assignments{{entry.path, text.str(), "a changed motor"}};
    if (!entry.together.empty())
      assignments.push_back({entry.together, text.str(), "a changed motor"});
    assign_all(assignments, DeclaredEntries(prm), prm);
    return changed;
  }
} // namespace ringmotor
