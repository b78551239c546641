// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/output/table.h>
#include <ringmotor/parameters/errors.h>

#include <deal.II/base/exceptions.h>

#include <array>
#include <charconv>
#include <cmath>

using namespace dealii;

namespace ringmotor
{
  namespace
  {
    std::string formatted(const std::string &text)
    {
      if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
      std::string in_quotes = "\"";
      for (const char letter : text)
        in_quotes += letter == '"' ? "\"\"" : std::string(1, letter);
      return in_quotes + '"';
    }

    template <typename Number>
    std::string formatted(const Number number)
    {
      std::array<char, 32> digits;
      // Adding zero removes the sign of a negative zero.
      const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), number + 0);
      return std::string(digits.data(), result.ptr);
    }
  } // namespace

  CsvTable::CsvTable(const std::vector<std::string> &columns) : columns(columns) {}

  void CsvTable::add_row(const std::vector<Entry> &row)
  {
    AssertDimension(row.size(), columns.size());
    for (std::size_t column = 0; column < row.size(); ++column)
      if (const double *number = std::get_if<double>(&row[column]))
        if (!std::isfinite(*number))
          throw ComputationError("The column '" + columns[column] + "' of a table got the value " +
                                 formatted(*number) + ", not a finite number");
    rows.push_back(row);
  }

  std::string CsvTable::to_csv() const
  {
    std::string csv;
    for (std::size_t column = 0; column < columns.size(); ++column)
      csv += (column > 0 ? "," : "") + formatted(columns[column]);
    csv += '\n';

    const auto format = [](const auto &entry) { return formatted(entry); };
    for (const auto &row : rows)
    {
      for (std::size_t column = 0; column < row.size(); ++column)
        csv += (column > 0 ? "," : "") + std::visit(format, row[column]);
      csv += '\n';
    }
    return csv;
  }

  void CsvTable::write(const std::string &path) const
  {
    write_file(path, to_csv());
  }

  void add_entries(NamedRow &row, const std::vector<Quantity> &quantities)
  {
    for (const auto &[name, unit, estimate, has_error] : quantities)
    {
      row.emplace_back(name_with_unit(name, unit.shown), estimate.value / unit.size);
      if (has_error)
        row.emplace_back(name_with_unit(name + "_error", unit.shown), estimate.error() / unit.size);
    }
  }

  void write_table(const std::string &path, const std::vector<NamedRow> &rows)
  {
    Assert(!rows.empty(), ExcMessage("a table of rows with names has at least one row"));
    std::vector<std::string> columns;
    for (const auto &entry : rows.front())
      columns.push_back(entry.first);
    CsvTable table(columns);
    for (const NamedRow &row : rows)
    {
      std::vector<CsvTable::Entry> entries;
      for (const auto &entry : row)
        entries.push_back(entry.second);
      table.add_row(entries);
    }
    table.write(path);
  }
} // namespace ringmotor
