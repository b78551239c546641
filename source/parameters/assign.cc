// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <ringmotor/parameters/assign.h>
#include <ringmotor/parameters/characters.h>
#include <ringmotor/parameters/declare.h>
#include <ringmotor/parameters/declared_entries.h>
#include <ringmotor/parameters/errors.h>

#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The part of @p text after its leading number; no value if there is no such number. */
    std::optional<std::string> text_after_number(const std::string &text)
    {
      char *end = nullptr;
      std::strtod(text.c_str(), &end);
      if (end == text.c_str())
        return {};
      return boost::algorithm::trim_copy(std::string(end));
    }

    /** What follows the first number of a list, or a single one, that something follows. */
    std::string first_rest(const std::string &value)
    {
      std::vector<std::string> numbers;
      boost::algorithm::split(numbers, value, [](const char c) { return c == ','; });
      for (const std::string &number : numbers)
        if (const auto rest = text_after_number(number); rest && !rest->empty())
          return *rest;
      return "";
    }

    bool is_path(const DeclaredEntries::Entry &entry)
    {
      return entry.allowed.find("a path") != std::string::npos;
    }

    bool is_text(const DeclaredEntries::Entry &entry)
    {
      return entry.allowed.find("a text") == 0;
    }

    /** Also whole numbers, which have no units. */
    bool has_number(const DeclaredEntries::Entry &entry)
    {
      return !entry.units.empty() || entry.allowed.find("a whole number") != std::string::npos;
    }

    /** Whether a text behind a number is an exponent in the notation of another language. */
    bool is_exponent(const std::string &rest)
    {
      const std::string compact = boost::algorithm::erase_all_copy(rest, " ");
      if (compact.empty() || std::string("dDeEqQ").find(compact.front()) == std::string::npos)
        return false;
      const bool is_signed = compact.size() > 1 && (compact[1] == '-' || compact[1] == '+');
      return compact.find_first_not_of("0123456789", is_signed ? 2 : 1) == std::string::npos;
    }

    /** What is probably wrong with a rejected number, or list of them; empty if nobody knows. */
    std::string problem_of_number(const std::string &value, const std::string &units)
    {
      const std::string comma = decimal_comma(value), rest = first_rest(value);
      if (!comma.empty())
        return comma;
      if (is_exponent(rest))
        return "has the exponent " + in_quotes(rest) + "; write exponents as in 1.41e11";
      const std::string compact = boost::algorithm::erase_all_copy(rest, " ");
      if (boost::algorithm::starts_with(compact, "*10") ||
          boost::algorithm::starts_with(compact, "x10"))
        return "has the power of ten " + in_quotes(rest) + "; write powers of ten as in 1.41e11";
      const auto starts_unit = [](const unsigned char character)
      { return std::isalpha(character) || character == '%' || character >= 128; };
      if (!units.empty() && !rest.empty() && starts_unit(rest.front()))
        return "has a unit; give the number in SI, " +
               (units == "none" ? "here a plain number" : "here in " + units) +
               ", without the unit";
      if (text_after_number(value) == "" && !std::isfinite(std::strtod(value.c_str(), nullptr)))
        return "is not a finite number";
      return "";
    }

    /** What is probably wrong with a rejected value; empty if nobody knows. */
    std::string problem_of(const std::string &value, const DeclaredEntries::Entry &entry)
    {
      if (is_path(entry))
        return problem_of_path(value);
      if (is_text(entry))
        return deceptive_character(value, Deception::control);
      if (const std::string found = deceptive_character(value, Deception::look_alike);
          !found.empty())
        return found;
      if (value.front() == '"' || value.front() == '\'')
        return "is in quotes; leave them out";
      const std::string of_number = has_number(entry) ? problem_of_number(value, entry.units) : "";
      return of_number.empty() ? deceptive_character(value, Deception::foreign) : of_number;
    }

    /** Passes one assignment to the handler, whose actions write to the parameters. */
    void assign(const PrmFile::Assignment &assignment, const DeclaredEntries &declared,
                ParameterHandler &prm)
    {
      const auto *const entry = declared.find(assignment.path);
      if (entry == nullptr)
        throw UserError(assignment.place + ": unknown entry " + in_quotes(assignment.path) + "; " +
                        declared.advice_for_entry(assignment.path));

      std::vector<std::string> names;
      boost::algorithm::split(names, assignment.path, [](const char c) { return c == '/'; });
      for (std::size_t i = 0; i + 1 < names.size(); ++i)
        prm.enter_subsection(names[i]);
      try
      {
        prm.set(names.back(), assignment.value);
      }
      catch (const ExceptionBase &) // a value outside the pattern; replaces deal.II's text
      {
        throw UserError(assignment.place + ": " + assignment.path +
                        explain_refusal(assignment.value, *entry));
      }
      for (std::size_t i = 0; i + 1 < names.size(); ++i)
        prm.leave_subsection();
    }

    /** Units that users may have in mind: name, units of the entry, power of ten between them. */
    struct OtherUnit
    {
      std::string name, of, power;
    };

    /** The value converted from the unit that makes it plausible, if there is one. */
    std::string guessed_units(const std::string &value, const std::string &units,
                              const std::function<bool(double)> &is_plausible)
    {
      const std::vector<OtherUnit> others{
          {"mm", "m", "-3"},         {"um", "m", "-6"},     {"GPa", "Pa", "9"}, {"MPa", "Pa", "6"},
          {"g/cm^3", "kg/m^3", "3"}, {"kN", "N", "3"},      {"mN", "N", "-3"},  {"kHz", "Hz", "3"},
          {"us", "s", "-6"},         {"mm^2", "m^2", "-6"}, {"%", "none", "-2"}};
      if (value.find_first_not_of("0123456789.+-") != std::string::npos) // has its own exponent
        return "";
      for (const OtherUnit &other : others)
      {
        const std::string in_si = value + "e" + other.power;
        if (other.of == units && is_plausible(std::strtod(in_si.c_str(), nullptr)))
          return " (" + value + " " + other.name + " is " + in_si + ")";
      }
      return "";
    }
  } // namespace

  std::string explain_refusal(const std::string &value, const DeclaredEntries::Entry &entry)
  {
    if (value.empty())
      return " is empty; allowed: " + entry.allowed;
    const std::string problem = problem_of(value, entry);
    return " = " + in_quotes(value) + " " + (problem.empty() ? "is not a valid value" : problem) +
           "; allowed: " + entry.allowed;
  }

  void assign_all(const std::vector<PrmFile::Assignment> &assignments,
                  const DeclaredEntries &declared, ParameterHandler &prm)
  {
    std::map<std::string, std::string> first_places;
    for (const PrmFile::Assignment &assignment : assignments)
    {
      const auto [first, is_new] = first_places.emplace(assignment.path, assignment.place);
      if (!is_new)
        throw UserError(assignment.place + ": " + assignment.path +
                        " is set a second time, the first is " + first->second +
                        "; remove one of them");
      assign(assignment, declared, prm);
    }
  }

  void check_plausible(const std::vector<PrmFile::Assignment> &assignments,
                       const DeclaredEntries &declared)
  {
    for (const PrmFile::Assignment &assignment : assignments)
    {
      const DeclaredEntries::Entry &entry = *declared.find(assignment.path);
      const auto rest                     = text_after_number(assignment.value);
      if (entry.plausible.empty() || !rest || !rest->empty()) // a word
        continue;
      char *end               = nullptr;
      const double least      = std::strtod(entry.plausible.c_str(), &end);
      const double most       = std::strtod(end + std::string(" to ").size(), nullptr);
      const auto is_plausible = [=](const double value)
      { return value == 0. || (std::abs(value) >= least && std::abs(value) <= most); };
      if (is_plausible(std::strtod(assignment.value.c_str(), nullptr)))
        continue;
      const std::string units = entry.units == "none" ? "" : " " + entry.units;
      throw UserError(assignment.place + ": " + assignment.path + " = " + assignment.value + units +
                      " is not plausible; plausible: " + entry.plausible + units +
                      guessed_units(assignment.value, entry.units, is_plausible) +
                      "; if it is meant, set Motor/Unusual values = accept");
    }
  }
} // namespace ringmotor
