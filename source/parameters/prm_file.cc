// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/characters.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/prm_file.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>
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

    std::string first_word(const std::string &line)
    {
      return line.substr(0, line.find_first_of(" \t"));
    }

    /** Whether a line begins as those that no value goes on with. */
    bool is_statement(const std::string &line)
    {
      const std::string word = first_word(line);
      return word == "set" || word == "subsection" || word == "end";
    }

    /** With line feeds alone at the ends of lines. */
    std::string with_unix_lines(std::string text)
    {
      boost::algorithm::replace_all(text, "\r\n", "\n");
      boost::algorithm::replace_all(text, "\r", "\n");
      return text;
    }

    /** The parser's state from line to line. */
    class PrmParser
    {
    public:
      explicit PrmParser(const std::string &name) { file.name = name; }

      PrmFile parse(const std::string &text);

    private:
      void parse_line(const std::string &line);
      void check_plain(const std::string &names) const;
      void open_subsection(const std::string &subsection);
      void close_subsection();
      void assign(const std::string &assignment);

      [[noreturn]] void fail(const std::string &message) const
      {
        throw UserError(place + ": " + message);
      }

      unsigned int line_number = 0;         // of the line being read
      std::string place;                    // where it is
      std::vector<std::string> subsections; // the open ones, outermost first
      std::vector<std::string> opened_at;   // the places where they were opened
      PrmFile file;
    };

    PrmFile PrmParser::parse(const std::string &text)
    {
      place = file.name;
      if (const std::string problem = encoding_problem(text); !problem.empty())
        fail(problem);
      const std::string byte_order_mark = "\xEF\xBB\xBF";
      const bool is_marked = text.compare(0, byte_order_mark.size(), byte_order_mark) == 0;
      std::istringstream stream(
          with_unix_lines(is_marked ? text.substr(byte_order_mark.size()) : text));
      std::string raw_line, line;
      bool continued = false;
      for (unsigned int number = 1; std::getline(stream, raw_line); ++number)
      {
        if (!continued)
        {
          line_number = number;
          place       = file.name + ":" + std::to_string(number);
        }
        // Cut the comment first: a comment that ends with a backslash must not swallow a line.
        const std::string part = trim_copy(raw_line.substr(0, raw_line.find('#')));
        if (continued && is_statement(part))
          fail("ends with a backslash, which joins the next line, " + in_quotes(part) +
               "; remove the backslash");
        line += part;
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
      check_plain(trim_copy(line.substr(0, line.find('='))));
      const std::string keyword = first_word(line);
      const std::string rest    = trim_copy(line.substr(keyword.size()));

      if (keyword == "subsection")
        open_subsection(tidy(rest));
      else if (keyword == "set")
        assign(rest);
      else if (line == "end")
        close_subsection();
      else if (keyword == "include")
        fail("include is not supported; a file that differs from another one in a few entries has "
             "a line \"set Base file = PATH\" and these entries");
      else
        fail("cannot understand " + in_quotes(line) +
             "; allowed: subsection Name, set Entry = value, end, # comment");
    }

    /** Keywords, sections and entries are plain words. */
    void PrmParser::check_plain(const std::string &names) const
    {
      const std::string found = deceptive_character(names, Deception::foreign);
      if (!found.empty())
        fail(in_quotes(names) + " " + found);
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
      PrmFile::Assignment found{path_of(subsections, entry),
                                trim_copy(assignment.substr(equals + 1)), place, line_number};
      if (found.path != "Base file")
        file.assignments.push_back(std::move(found));
      else if (file.base)
        fail("Base file is set a second time, the first is " + file.base->place +
             "; remove one of them");
      else
        file.base = std::move(found);
    }
  } // namespace

  PrmFile parse_prm(const std::string &text, const std::string &name)
  {
    return PrmParser(name).parse(text);
  }

  PrmFile::Assignment parse_override(const std::string &text)
  {
    const std::string place = "--set " + in_quotes(text);
    if (const std::string problem = encoding_problem(text); !problem.empty())
      throw UserError(place + ": " + problem);
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
      throw UserError(place + ": no equals sign; write --set 'Section/Entry = value'");

    const std::string written = text.substr(0, equals);
    if (const std::string found = deceptive_character(written, Deception::foreign); !found.empty())
      throw UserError(place + ": " + in_quotes(trim_copy(written)) + " " + found);
    std::istringstream path(written);
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
    constexpr std::size_t longest = 80;
    return '"' + visible(text, longest) + '"';
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
