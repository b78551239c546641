// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ringmotor
{
  /**
   * How a value of type T is written in a parameter file. `read(write(value))` is exactly `value`,
   * which deal.II's own conversion (six digits) does not promise. `read` returns nothing for a text
   * that is not allowed. `allowed` describes what is; users see it in `--help` and in messages.
   */
  template <typename T>
  struct Notation
  {
    std::function<std::string(const T &)> write;
    std::function<std::optional<T>(const std::string &)> read;
    std::string allowed;
    /** The range of plausible numbers in words: `1e-05 to 0.05`; empty if all allowed ones are.
     * Others are most likely in other units, see check_plausible(). */
    std::string plausible = "";
  };

  /** A deal.II pattern given by a predicate and a description in words. */
  class WordedPattern : public dealii::Patterns::PatternBase
  {
  public:
    WordedPattern(std::function<bool(const std::string &)> accepts, std::string allowed);

    bool match(const std::string &text) const override;
    std::string description(OutputStyle style = Machine) const override;
    std::unique_ptr<PatternBase> clone() const override;

  private:
    std::function<bool(const std::string &)> accepts;
    std::string allowed;
  };

  /** Whether a parameter file must contain an entry. */
  enum class Presence
  {
    optional,
    required
  };

  /**
   * Declares entry @p name in the current subsection with the present value of @p variable as
   * default, and writes every value that the entry is set to into @p variable. The @p sentence ends
   * with `Units: m.` where the entry has a dimension and with `Units: none.` where it is a plain
   * number.
   */
  template <typename T>
  void add_entry(dealii::ParameterHandler &prm, const std::string &name, T &variable,
                 const Notation<T> &notation, const std::string &sentence,
                 const Presence presence = Presence::optional)
  {
    const bool required = presence == Presence::required;
    prm.declare_entry(
        name, notation.write(variable),
        WordedPattern([read = notation.read](const std::string &text)
                      { return read(text).has_value(); },
                      notation.allowed),
        sentence + " Allowed: " + notation.allowed + "." +
            (notation.plausible.empty() ? "" : " Plausible: " + notation.plausible + ".") +
            (required ? " Required." : ""),
        required);
    prm.add_action(name, [&variable, read = notation.read](const std::string &text)
                   { variable = *read(text); });
  }

  /** Finite numbers of any sign. */
  Notation<double> any_number();

  /** Finite positive numbers. */
  Notation<double> positive_number();

  /** Finite numbers that are not negative. */
  Notation<double> non_negative_number();

  /** Numbers that are plausible if they are zero or of a magnitude from @p least to @p most. */
  Notation<double> plausible(const Notation<double> &number, double least, double most);

  /** Lengths (m) of motor parts: radii, thicknesses and widths, and heights of faces, which may
   * have any sign. */
  Notation<double> radius();
  Notation<double> thickness();
  Notation<double> height();

  /** Moduli of elasticity (Pa) of the materials of motors, except felt. */
  Notation<double> modulus();

  /** Numbers from @p lower to @p upper, both included, described by @p allowed. */
  Notation<double> number_within(double lower, double upper, const std::string &allowed);

  /** A number, or the @p word that stands for no value. */
  template <typename T>
  Notation<std::optional<T>> number_or(const std::string &word, const Notation<T> &number)
  {
    using Value      = std::optional<T>;
    const auto write = [word, number](const Value &value)
    { return value ? number.write(*value) : word; };
    const auto read = [word, number](const std::string &text) -> std::optional<Value>
    {
      if (text == word)
        return Value();
      if (const auto value = number.read(text))
        return Value(value);
      return {};
    };
    return {write, read, word + ", or " + number.allowed, number.plausible};
  }

  /** Why a list of numbers that are not whole is refused although each may be one: a comma between
   * digits, `0,05`, or a number `05` may have come from a decimal comma. Empty if it has none. */
  std::string decimal_comma(const std::string &list);

  /** The items of such a list, between its commas; none if they may be decimal commas. */
  std::vector<std::string> items_of(const std::string &list);

  /** Numbers separated by commas, or the @p word that stands for the empty list. */
  Notation<std::vector<double>> numbers_or(const std::string &word, const Notation<double> &number);

  /** Whole numbers from @p lower to @p upper, both included. */
  Notation<unsigned int> whole_number(unsigned int lower, unsigned int upper);

  /** `true` or `false`. */
  Notation<bool> yes_or_no();

  /** A non-empty text that fits on one line of a parameter file. */
  Notation<std::string> any_text();

  /** Why a text is refused as a path: it has what only a shell understands (`~`, variables,
   * quotes), or what is not seen; empty if it is none of these. */
  std::string problem_of_path(const std::string &text);

  /** The path of a folder or file, which is taken literally. */
  Notation<std::string> path();

  /** The path of a file, or the word `none`, which stands for the empty string. */
  Notation<std::string> file_or_none();

  /** One of some words, each with its meaning. */
  template <typename Enum>
  Notation<Enum> selection(const std::vector<std::pair<std::string, Enum>> &choices)
  {
    std::string allowed;
    for (const auto &choice : choices)
      allowed += (allowed.empty() ? "" : " | ") + choice.first;

    const auto write = [choices](const Enum &value)
    {
      for (const auto &[word, meaning] : choices)
        if (meaning == value)
          return word;
      AssertThrow(false, dealii::ExcInternalError());
      return std::string();
    };
    const auto read = [choices](const std::string &text) -> std::optional<Enum>
    {
      for (const auto &[word, meaning] : choices)
        if (word == text)
          return meaning;
      return {};
    };
    return {write, read, allowed};
  }
} // namespace ringmotor
