// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <ringmotor/parameters/characters.h>
#include <ringmotor/parameters/declare.h>

#include <boost/algorithm/string/predicate.hpp>

#include <array>
#include <cctype>
#include <charconv>
#include <limits>

namespace ringmotor
{
  using namespace dealii;

  WordedPattern::WordedPattern(std::function<bool(const std::string &)> accepts,
                               std::string allowed)
      : accepts(std::move(accepts)), allowed(std::move(allowed))
  {
  }

  bool WordedPattern::match(const std::string &text) const
  {
    return accepts(text);
  }

  std::string WordedPattern::description(const OutputStyle) const
  {
    return allowed;
  }

  std::unique_ptr<Patterns::PatternBase> WordedPattern::clone() const
  {
    return std::make_unique<WordedPattern>(*this);
  }

  namespace
  {
    /** The shortest decimal text that is read back as the same number. */
    std::string shortest_text(const double &value)
    {
      std::array<char, 32> buffer;
      const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                     std::chars_format::general)
                           .ptr;
      return {buffer.data(), end};
    }

    /** Whether a text can be written as a value and read back: no comment, no line continuation. */
    bool fits_in_file(const std::string &text)
    {
      return !text.empty() && text.find('#') == std::string::npos && text.back() != '\\' &&
             encoding_problem(text).empty() &&
             deceptive_character(text, Deception::control).empty() &&
             text.find('\t') == std::string::npos;
    }

    constexpr double largest  = std::numeric_limits<double>::max();
    constexpr double smallest = std::numeric_limits<double>::min();
  } // namespace

  Notation<double> number_within(const double lower, const double upper, const std::string &allowed)
  {
    const auto read = [lower, upper](const std::string &text) -> std::optional<double>
    {
      if (Patterns::Double(lower, upper).match(text))
        return Utilities::string_to_double(text);
      return {};
    };
    return {shortest_text, read, allowed};
  }

  Notation<double> any_number()
  {
    return number_within(-largest, largest, "a number");
  }

  Notation<double> positive_number()
  {
    return number_within(smallest, largest, "a number above 0");
  }

  Notation<double> non_negative_number()
  {
    return number_within(0., largest, "a number from 0");
  }

  Notation<double> plausible(const Notation<double> &number, const double least, const double most)
  {
    Notation<double> narrower = number;
    narrower.plausible        = shortest_text(least) + " to " + shortest_text(most);
    return narrower;
  }

  Notation<double> radius()
  {
    return plausible(positive_number(), 1e-3, 0.5);
  }

  Notation<double> thickness()
  {
    return plausible(positive_number(), 1e-5, 0.05);
  }

  Notation<double> height()
  {
    return plausible(any_number(), -0.05, 0.05);
  }

  Notation<double> modulus()
  {
    return plausible(positive_number(), 1e8, 1.5e12);
  }

  std::string decimal_comma(const std::string &list)
  {
    const auto is_digit = [](const std::string &text, const std::size_t place)
    { return place < text.size() && std::isdigit(static_cast<unsigned char>(text[place])); };
    for (std::size_t comma = list.find(','); comma != std::string::npos;
         comma             = list.find(',', comma + 1))
      if (comma > 0 && is_digit(list, comma - 1) && is_digit(list, comma + 1))
        return "has a comma between digits; write a decimal point, no separators of thousands, and "
                           "a blank after each comma of a list";
    for (const std::string &item : Utilities::split_string_list(list, ','))
    {
      const std::size_t first = item.find_first_not_of("+-");
      if (first != std::string::npos && item[first] == '0' && is_digit(item, first + 1))
        return "has a number with a leading zero, as behind a decimal comma; write a decimal point";
    }
    return "";
  }

  std::vector<std::string> items_of(const std::string &list)
  {
    return decimal_comma(list).empty() ? Utilities::split_string_list(list, ',')
                                       : std::vector<std::string>();
  }

  Notation<std::vector<double>> numbers_or(const std::string &word, const Notation<double> &number)
  {
    using Values     = std::vector<double>;
    const auto write = [word, number](const Values &values)
    {
      std::string text;
      for (const double value : values)
        text += (text.empty() ? "" : ", ") + number.write(value);
      return text.empty() ? word : text;
    };
    const auto read = [word, number](const std::string &text) -> std::optional<Values>
    {
      Values values;
      if (text == word)
        return values;
      for (const std::string &item : items_of(text))
        if (const auto value = number.read(item))
          values.push_back(*value);
        else
          return {};
      return values.empty() ? std::nullopt : std::make_optional(values);
    };
    return {write, read,
            word + ", or numbers separated by a comma and a blank, each " + number.allowed};
  }

  Notation<unsigned int> whole_number(const unsigned int lower, const unsigned int upper)
  {
    const auto write = [](const unsigned int &value) { return std::to_string(value); };
    const auto read  = [lower, upper](const std::string &text) -> std::optional<unsigned int>
    {
      if (Patterns::Integer(lower, upper).match(text))
        return Utilities::string_to_int(text);
      return {};
    };
    return {write, read,
            "a whole number from " + std::to_string(lower) + " to " + std::to_string(upper)};
  }

  Notation<bool> yes_or_no()
  {
    return selection<bool>({{"true", true}, {"false", false}});
  }

  Notation<std::string> any_text()
  {
    const auto write = [](const std::string &value) { return value; };
    const auto read  = [](const std::string &text)
    { return fits_in_file(text) ? std::make_optional(text) : std::nullopt; };
    return {write, read, "a text of one line without #"};
  }

  std::string problem_of_path(const std::string &text)
  {
    const std::string unseen = deceptive_character(text, Deception::blank);
    if (!unseen.empty())
      return unseen;
    const auto has = [&text](const char *const characters)
    { return text.find_first_of(characters) != std::string::npos; };
    const auto begins_with = [&text](const std::string &start)
    { return text.compare(0, start.size(), start) == 0; };
    if (begins_with("~"))
      return "begins with ~, which only a shell replaces; write the whole path of the home folder";
    if (has("$`"))
      return "has a $ or `, which only a shell replaces; write out what it stands for";
    for (const std::string quote : {"\"", "'", "\u2018", "\u2019", "\u201A", "\u201C", "\u201D",
                                    "\u201E", "\u00AB", "\u00BB"})
      if (begins_with(quote) || boost::algorithm::ends_with(text, quote))
        return "has quotes around it; leave them out, blanks need none";
    if (has("\\"))
      return "has a backslash; separate folders by /";
    if (has("#"))
      return "has a #, which begins a comment in parameter files";
    if (begins_with("file:"))
      return "is an address; write the path alone, without file:";
    return fits_in_file(text) ? "" : "has bytes that a parameter file cannot hold";
  }

  Notation<std::string> path()
  {
    const auto write = [](const std::string &value) { return value; };
    const auto read  = [](const std::string &text)
    {
      return !text.empty() && problem_of_path(text).empty() ? std::make_optional(text)
                                                            : std::nullopt;
    };
    return {write, read, "a path as it stands: no $ # \\, no ~ in front, no quotes around it"};
  }

  Notation<std::string> file_or_none()
  {
    const Notation<std::string> file = path();
    const auto write = [](const std::string &value) { return value.empty() ? "none" : value; };
    const auto read  = [file](const std::string &text)
    { return text == "none" ? std::make_optional<std::string>() : file.read(text); };
    return {write, read, "none, or " + file.allowed};
  }
} // namespace ringmotor
