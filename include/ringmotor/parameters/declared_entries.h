// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <set>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace ringmotor
{
  /** The names a parameter file may use, with what is needed to explain them. */
  class DeclaredEntries
  {
  public:
    struct Entry
    {
      std::string allowed;   ///< the allowed values in words
      std::string units;     ///< `m`, `Pa`, ...; `none` for a plain number, empty if not a number
      std::string plausible; ///< see Notation#plausible
      bool is_required;      ///< see Presence
    };

    /** Collects all entries declared in @p prm with add_entry(). */
    explicit DeclaredEntries(const dealii::ParameterHandler &prm);

    /** Whether what add_entry() has written of an entry says that a file has to give it. */
    static bool says_required(const std::string &documentation);

    /** The entry `Section/Sub/Entry`, or a null pointer. */
    const Entry *find(const std::string &path) const;

    /** Whether `Section/Sub` is declared. */
    bool has_section(const std::string &path) const;

    /** What the user may have meant by the undeclared entry @p path, as the end of a sentence. */
    std::string advice_for_entry(const std::string &path) const;

    /** What the user may have meant by the undeclared section @p path, as the end of a sentence. */
    std::string advice_for_section(const std::string &path) const;

  private:
    std::map<std::string, Entry> entries;
    std::set<std::string> sections;
  };
} // namespace ringmotor
