// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <ringmotor/parameters/declare.h>

#include <algorithm>
#include <array>
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
      const auto is_forbidden = [](const unsigned char character)
      { return character < ' ' || character == '#'; };
      return !text.empty() && text.back() != '\\' &&
             std::none_of(text.begin(), text.end(), is_forbidden);
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
    return plausible(any_number(), 0., 0.05);
  }

  Notation<double> modulus()
  {
    return plausible(positive_number(), 1e8, 1.5e12);
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
      for (const std::string &item : Utilities::split_string_list(text, ','))
        if (const auto value = number.read(item))
          values.push_back(*value);
        else
          return {};
      return values.empty() ? std::nullopt : std::make_optional(values);
    };
    return {write, read, word + ", or numbers separated by commas, each " + number.allowed};
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

  Notation<std::string> file_or_none()
  {
    const auto write = [](const std::string &value) { return value.empty() ? "none" : value; };
    const auto read  = [](const std::string &text) -> std::optional<std::string>
    {
      if (!fits_in_file(text))
        return {};
      return text == "none" ? std::string() : text;
    };
    return {write, read, "none, or the path of a file"};
  }
} // namespace ringmotor
