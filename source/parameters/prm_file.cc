// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/prm_file.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <boost/algorithm/string/trim_all.hpp>

#include <algorithm>
#include <sstream>

namespace ringmotor
{
  using boost::algorithm::trim_copy;

  namespace
  {
    /** Without surrounding blanks, and with single blanks between words. */
    std::string tidy(const std::string &name)
    {
      return boost::algorithm::trim_all_copy(name);
    }

    /** The path of a name within the open subsections. */
    std::string path_of(std::vector<std::string> subsections, const std::string &name)
    {
      subsections.push_back(name);
      return boost::algorithm::join(subsections, "/");
    }

    /** The parser's state from line to line. */
    class PrmParser
    {
    public:
      explicit PrmParser(const std::string &name) : name(name) {}

      PrmFile parse(const std::string &text);

    private:
      void parse_line(const std::string &line);
      void open_subsection(const std::string &subsection);
      void close_subsection();
      void assign(const std::string &assignment);

      [[noreturn]] void fail(const std::string &message) const
      {
        throw UserError(place + ": " + message);
      }

      const std::string name;
      unsigned int line_number = 0;         // of the line being read
      std::string place;                    // where it is
      std::vector<std::string> subsections; // the open ones, outermost first
      std::vector<std::string> opened_at;   // the places where they were opened
      PrmFile file;
    };

    PrmFile PrmParser::parse(const std::string &text)
    {
      const std::string byte_order_mark = "\xEF\xBB\xBF";
      const bool is_marked = text.compare(0, byte_order_mark.size(), byte_order_mark) == 0;
      std::istringstream stream(is_marked ? text.substr(byte_order_mark.size()) : text);
      std::string raw_line, line;
      bool continued = false;
      for (unsigned int number = 1; std::getline(stream, raw_line); ++number)
      {
        if (!continued)
        {
          line_number = number;
          place       = name + ":" + std::to_string(number);
        }
        // Cut the comment first: a comment that ends with a backslash must not swallow a line.
        line += trim_copy(raw_line.substr(0, raw_line.find('#')));
        continued = !line.empty() && line.back() == '\\';
        if (continued)
        {
          line.pop_back();
          continue;
        }
        parse_line(trim_copy(line));
        line.clear();
      }
      parse_line(trim_copy(line));

      if (!subsections.empty())
      {
        place = opened_at.back();
        fail("subsection " + in_quotes(subsections.back()) +
             " is never closed; add a line \"end\"");
      }
      return std::move(file);
    }

    void PrmParser::parse_line(const std::string &line)
    {
      if (line.empty())
        return;
      const std::size_t end_of_keyword = std::min(line.find_first_of(" \t"), line.size());
      const std::string keyword        = line.substr(0, end_of_keyword);
      const std::string rest           = trim_copy(line.substr(end_of_keyword));

      if (keyword == "subsection")
        open_subsection(tidy(rest));
      else if (keyword == "set")
        assign(rest);
      else if (line == "end")
        close_subsection();
      else if (keyword == "include")
        fail("include is not supported: a parameter file is self-contained; copy the lines of the "
             "included file here, or vary single entries with --set");
      else
        fail("cannot understand " + in_quotes(line) +
             "; allowed: subsection Name, set Entry = value, end, # comment");
    }

    void PrmParser::open_subsection(const std::string &subsection)
    {
      if (subsection.empty())
        fail("subsection without a name; write \"subsection Name\"");
      file.sections.push_back({path_of(subsections, subsection), place});
      subsections.push_back(subsection);
      opened_at.push_back(place);
    }

    void PrmParser::close_subsection()
    {
      if (subsections.empty())
        fail(
            "\"end\" without an open subsection; remove it or add the missing \"subsection Name\"");
      subsections.pop_back();
      opened_at.pop_back();
    }

    void PrmParser::assign(const std::string &assignment)
    {
      const std::size_t equals = assignment.find('=');
      const std::string entry  = tidy(assignment.substr(0, equals));
      if (equals == std::string::npos || entry.empty())
        fail("cannot understand " + in_quotes("set " + assignment) +
             "; write \"set Entry = value\"");
      file.assignments.push_back({path_of(subsections, entry),
                                  trim_copy(assignment.substr(equals + 1)), place, line_number});
    }
  } // namespace

  PrmFile parse_prm(const std::string &text, const std::string &name)
  {
    return PrmParser(name).parse(text);
  }

  PrmFile::Assignment parse_override(const std::string &text)
  {
    const std::string place  = "--set " + in_quotes(text);
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
      throw UserError(place + ": no equals sign; write --set 'Section/Entry = value'");

    std::istringstream path(text.substr(0, equals));
    std::vector<std::string> names;
    for (std::string name; std::getline(path, name, '/');)
      names.push_back(tidy(name));
    if (names.empty() || names.back().empty())
      throw UserError(place + ": no entry before the equals sign; write --set 'Section/Entry = "
                              "value'");
    return {boost::algorithm::join(names, "/"), trim_copy(text.substr(equals + 1)), place};
  }

  std::string in_quotes(const std::string &text)
  {
    const std::size_t longest = 80;
    std::string visible       = text.substr(0, longest);
    std::replace_if(
        visible.begin(), visible.end(),
        [](const unsigned char character) { return character < ' ' || character == 127; }, '?');
    return '"' + visible + (text.size() > longest ? "..." : "") + '"';
  }

  std::string some_of(const std::vector<std::string> &names)
  {
    constexpr std::size_t most_shown = 4;
    const std::vector<std::string> shown(names.begin(),
                                         names.begin() + std::min(names.size(), most_shown));
    return boost::algorithm::join(shown, ", ") +
           (names.size() > most_shown
                ? " and " + std::to_string(names.size() - most_shown) + " more"
                : "");
  }
} // namespace ringmotor
