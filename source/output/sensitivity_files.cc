// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/sensitivity_files.h>
#include <ringmotor/output/table.h>
#include <ringmotor/output/text.h>
#include <ringmotor/parameters/short_text.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace ringmotor
{
  namespace
  {
    constexpr int column_width = 19; // of the log

    /** `  2.31 +- 0.04`, with as many digits as the error bar leaves. */
    std::string describe(const LogDerivative &derivative, const double factor)
    {
      if (!derivative.is_known)
        return "-";
      const double error = factor * derivative.error;
      const int digits   = error < 0.005 ? 3 : error < 0.05 ? 2 : 1;
      return text(factor * derivative.value, digits) + " +- " + text(error, digits);
    }

    std::string in_columns(const std::string &entry, const std::vector<std::string> &columns)
    {
      std::ostringstream line;
      line << std::left << std::setw(50) << entry << std::right;
      for (const std::string &column : columns)
        line << std::setw(column_width) << column;
      return line.str();
    }

    /** The names of the quantities in few words, for the head. */
    std::vector<std::string> heads()
    {
      std::vector<std::string> heads;
      for (const SensitiveQuantity &quantity : sensitive_quantities())
      {
        std::string name = quantity.name;
        if (name.rfind("half_load_", 0) == 0)
          name = name.substr(10) + "*";
        std::replace(name.begin(), name.end(), '_', ' ');
        heads.push_back(name);
      }
      return heads;
    }
  } // namespace

  void write_sensitivities(const std::string &path, const std::vector<Sensitivity> &all)
  {
    std::vector<std::string> columns{"entry", "value", "unit", "scale", "step"};
    for (const SensitiveQuantity &quantity : sensitive_quantities())
      columns.insert(columns.end(), {quantity.name, quantity.name + "_error"});
    columns.push_back("remark");
    CsvTable table(columns);
    for (const Sensitivity &one : all)
    {
      std::vector<CsvTable::Entry> row{one.entry.path, one.entry.value,
                                       one.entry.units == "none" ? "1" : one.entry.units,
                                       one.entry.scale, one.step};
      for (std::size_t i = 0; i < sensitive_quantities().size(); ++i)
        if (i < one.of.size() && one.of[i].is_known)
          row.insert(row.end(), {one.of[i].value, one.of[i].error});
        else
          row.insert(row.end(), {"", ""});
      row.emplace_back(one.entry.together.empty()
                           ? one.obstacle
                           : "together with " + one.entry.together +
                                 (one.obstacle.empty() ? "" : "; " + one.obstacle));
      table.add_row(row);
    }
    table.write(path);
  }

  std::vector<std::string> describe(const std::vector<Sensitivity> &all, const unsigned int n_most)
  {
    std::vector<std::string> lines{
        "percent of change per percent of an entry (a radius: of its distance from the next one); "
        "*: at half of the motor's own stall torque",
        in_columns("", heads())};
    unsigned int n_shown = 0, n_known = 0;
    for (const Sensitivity &one : all)
      if (one.obstacle.empty() && ++n_known <= n_most)
      {
        std::vector<std::string> columns;
        for (const LogDerivative &derivative : one.of)
          columns.push_back(describe(derivative, one.per_scale()));
        lines.push_back(in_columns(one.entry.path + " = " + short_text(one.entry.value), columns));
        ++n_shown;
      }
    if (n_known > n_shown)
      lines.push_back("and " + std::to_string(n_known - n_shown) +
                      " other entries with smaller changes, in sensitivities.csv");
    for (const Sensitivity &one : all)
      if (!one.obstacle.empty())
        lines.push_back("not varied: " + one.entry.path + ", as " + one.obstacle);
    return lines;
  }
} // namespace ringmotor
