// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>
#include <ringmotor/parameters/declared_entries.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <numeric>
#include <sstream>
#include <vector>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The text between `Units: `, or another @p start, and the end of that sentence; empty if
     * absent. */
    std::string told(const std::string &start, const std::string &documentation)
    {
      const std::size_t found = documentation.find(start);
      if (found == std::string::npos)
        return "";
      const std::size_t begin = found + start.size();
      std::string sentence = documentation.substr(begin, documentation.find(". ", begin) - begin);
      if (!sentence.empty() && sentence.back() == '.')
        sentence.pop_back();
      return sentence;
    }

    std::string last_name(const std::string &path)
    {
      return path.substr(path.rfind('/') + 1);
    }

    /** Everything before the last name, empty at the top level. */
    std::string section_of(const std::string &path)
    {
      return path.substr(0, path.size() == last_name(path).size() ? 0 : path.rfind('/'));
    }

    /** Insertions, deletions and replacements that turn one name into the other, ignoring case. */
    unsigned int edit_distance(const std::string &from, const std::string &to)
    {
      std::vector<unsigned int> row(to.size() + 1);
      std::iota(row.begin(), row.end(), 0);
      for (std::size_t i = 0; i < from.size(); ++i)
      {
        unsigned int diagonal = row[0];
        row[0]                = i + 1;
        for (std::size_t j = 0; j < to.size(); ++j)
        {
          const bool equal = std::tolower(static_cast<unsigned char>(from[i])) ==
                             std::tolower(static_cast<unsigned char>(to[j]));
          const unsigned int replaced = diagonal + (equal ? 0 : 1);
          diagonal                    = row[j + 1];
          row[j + 1]                  = std::min({replaced, row[j] + 1, diagonal + 1});
        }
      }
      return row.back();
    }

    /**
     * The candidate whose last name resembles that of @p path most, or an empty string if none
     * does; ties are resolved by the whole path.
     */
    std::string nearest(const std::string &path, const std::vector<std::string> &candidates)
    {
      const std::string name                                  = last_name(path);
      std::string best                                        = "";
      std::pair<unsigned int, unsigned int> smallest_distance = {name.size() / 3 + 1, 0};
      for (const std::string &candidate : candidates)
      {
        const std::pair<unsigned int, unsigned int> distance = {
            edit_distance(name, last_name(candidate)), edit_distance(path, candidate)};
        const bool similar = distance.first <= name.size() / 3;
        if (similar && distance < smallest_distance)
        {
          best              = candidate;
          smallest_distance = distance;
        }
      }
      return best;
    }

    /** The last names of those @p paths that lie directly in @p section. */
    std::string names_in(const std::string &section, const std::vector<std::string> &paths)
    {
      std::string names;
      for (const std::string &path : paths)
        if (section_of(path) == section)
          names += (names.empty() ? "" : ", ") + last_name(path);
      return names;
    }
  } // namespace

  DeclaredEntries::DeclaredEntries(const ParameterHandler &prm)
  {
    // The JSON output is deal.II's only public way to list what has been declared.
    std::ostringstream text;
    prm.print_parameters(text, ParameterHandler::JSON);

    const std::function<void(const nlohmann::json &, const std::string &)> collect =
        [&](const nlohmann::json &tree, const std::string &prefix)
    {
      for (const auto &[name, node] : tree.items())
      {
        const std::string path = prefix + name;
        if (node.contains("pattern_description"))
        {
          const std::string documentation = node["documentation"];
          entries[path] = {node["pattern_description"], told("Units: ", documentation),
                           told("Plausible: ", documentation), says_required(documentation)};
        }
        else
        {
          sections.insert(path);
          collect(node, path + "/");
        }
      }
    };
    collect(nlohmann::json::parse(text.str()), "");
  }

  bool DeclaredEntries::says_required(const std::string &documentation)
  {
    return documentation.find(" Required.") != std::string::npos;
  }

  const DeclaredEntries::Entry *DeclaredEntries::find(const std::string &path) const
  {
    const auto entry = entries.find(path);
    return entry == entries.end() ? nullptr : &entry->second;
  }

  bool DeclaredEntries::has_section(const std::string &path) const
  {
    return sections.count(path) > 0;
  }

  std::string DeclaredEntries::advice_for_entry(const std::string &path) const
  {
    std::vector<std::string> paths;
    for (const auto &[entry_path, entry] : entries)
      paths.push_back(entry_path);

    const std::string similar = nearest(path, paths);
    if (!similar.empty())
      return "did you mean " + similar + "?";
    const std::string names = names_in(section_of(path), paths);
    if (!names.empty())
      return section_of(path) + " has: " + names;
    return "the sections are: " + names_in("", {sections.begin(), sections.end()});
  }

  std::string DeclaredEntries::advice_for_section(const std::string &path) const
  {
    const std::vector<std::string> paths(sections.begin(), sections.end());
    const std::string similar = nearest(path, paths);
    if (!similar.empty())
      return "did you mean " + similar + "?" +
             (last_name(similar) == last_name(path) ? " (is an \"end\" missing or misplaced above?)"
                                                    : "");
    return "the sections are: " + names_in("", paths);
  }
} // namespace ringmotor
