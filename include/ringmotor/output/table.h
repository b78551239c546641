// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/results/quantity.h>

#include <string>
#include <variant>
#include <vector>

namespace ringmotor
{
  /**
   * A table of results, written as CSV (RFC 4180, comma, point, one header line). The name of a
   * column carries its unit: `frequency_Hz`. Numbers are written with the fewest digits that read
   * back to the same double.
   */
  class CsvTable
  {
  public:
    /** One entry; an empty text stands for "no value". */
    using Entry = std::variant<double, int, unsigned int, std::string>;

    explicit CsvTable(const std::vector<std::string> &columns);

    /** Adds a row with one entry per column.
     *  @throw ComputationError for a number that is not finite, naming its column */
    void add_row(const std::vector<Entry> &row);

    /** The whole table as CSV. */
    std::string to_csv() const;

    /** Writes it with write_file(). @throw UserError if writing fails */
    void write(const std::string &path) const;

  private:
    std::vector<std::string> columns;
    std::vector<std::vector<Entry>> rows;
  };

  /** A row of a table, each entry with the name of its column. */
  using NamedRow = std::vector<std::pair<std::string, CsvTable::Entry>>;

  /** Adds quantities to a row, each in the unit in which it is shown and, if it is known, with its
   * error bar: `speed_rpm`, `speed_error_rpm`. */
  void add_entries(NamedRow &row, const std::vector<Quantity> &quantities);

  /** Writes a CsvTable of at least one row; all rows have the columns of the first one. */
  void write_table(const std::string &path, const std::vector<NamedRow> &rows);
} // namespace ringmotor
