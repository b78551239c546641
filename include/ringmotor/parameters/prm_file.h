// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ringmotor
{
  /**
   * The content of a parameter file before it is interpreted. deal.II reads such files too, but it
   * silently accepts duplicate entries, and its messages are not written for users.
   */
  struct PrmFile
  {
    /** A line `set Entry = value`. */
    struct Assignment
    {
      std::string path;      ///< `Section/Sub/Entry`
      std::string value;     ///< without surrounding blanks; may be empty
      std::string place;     ///< where it was found, for messages
      unsigned int line = 0; ///< from 1; 0 on the command line
    };

    /** A line `subsection Name`. */
    struct Section
    {
      std::string path;  ///< `Section/Sub`
      std::string place; ///< where it was found, for messages
    };

    std::string name;               ///< as in messages: the path of the file
    std::optional<Assignment> base; ///< the line `set Base file = PATH`, see base_file.h
    std::vector<Section> sections;
    std::vector<Assignment> assignments;
  };

  /**
   * Splits the @p text of a parameter file into its lines: `subsection`, `set`, `end`, comments
   * from `#` to the end of the line, and a backslash that joins the next line. The place of a line
   * is `name:line`. A byte-order mark at the start, which some editors write, is skipped.
   *
   * @throws UserError for everything else, for subsections that are not balanced, a text that is
   * not UTF-8, and names with characters outside ASCII.
   */
  PrmFile parse_prm(const std::string &text, const std::string &name);

  /**
   * Splits `Section/Sub/Entry = value` into path and value.
   *
   * @throws UserError if the equals sign or the entry is missing.
   */
  PrmFile::Assignment parse_override(const std::string &text);

  /** @p text in quotes for a one-line message: without control characters, not too long, UTF-8. */
  std::string in_quotes(const std::string &text);

  /** The first few of @p names, separated by commas, and how many more there are. */
  std::string some_of(const std::vector<std::string> &names);
} // namespace ringmotor
