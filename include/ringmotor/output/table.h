// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

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

    /** Writes it with write_file(). @throw UserError if the disk refuses */
    void write(const std::string &path) const;

  private:
    std::vector<std::string> columns;
    std::vector<std::vector<Entry>> rows;
  };
} // namespace ringmotor
