// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "support/paper_motor.h"

#include <deal.II/base/utilities.h>

#include <gtest/gtest.h>
#include <ringmotor/motor/relevant.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/parameters.h>

#include <sstream>
#include <string>
#include <vector>

namespace ringmotor::sample
{
  inline std::string printed(const Parameters &parameters)
  {
    std::ostringstream text;
    print_parameters(text, parameters);
    return text.str();
  }

  /** All entries with the values of the reference motor, effects as in the paper. */
  inline std::string complete_text()
  {
    return printed(tests::paper_motor());
  }

  /** The parameters of complete_text() after `--set`. */
  inline Parameters with(const std::vector<std::string> &overrides)
  {
    return read_parameters_from_text(complete_text(), "complete.prm", overrides);
  }

  /** The values that an entry with a choice of words allows, as its message names them; otherwise
   * none. */
  inline std::vector<std::string> allowed_words(const std::string &entry)
  {
    try
    {
      with({entry + " = no such word"});
    }
    catch (const UserError &error)
    {
      const std::string message = error.what(), allowed = "; allowed: ";
      const std::size_t at = message.rfind(allowed);
      if (message.find(" | ", at) != std::string::npos)
        return dealii::Utilities::split_string_list(message.substr(at + allowed.size()), " | ");
    }
    return {};
  }

  /** `Section/Entry = value` with a value other than the reference motor's. */
  inline std::string changed(const std::string &entry)
  {
    const std::string reference     = text_of(with({}));
    std::vector<std::string> values = allowed_words(entry);
    for (const std::string value : {"3", "3000", "3e9", "4", "0.31", "4e9", "1e-5", "solid",
                                    "shell", "speed", "lapped", "0:0.034", "9e-9", "text"})
      values.push_back(value);
    for (const std::string &value : values)
      try
      {
        const std::string change = entry + " = " + value;
        if (text_of(with({change})) != reference)
          return change;
      }
      catch (const UserError &)
      {
        // not a value of this entry
      }
    return "";
  }

  /** The message of the UserError that @p action throws; the test fails if it throws none. */
  template <typename Action>
  std::string message_of(const Action &action)
  {
    try
    {
      action();
    }
    catch (const UserError &error)
    {
      return error.what();
    }
    ADD_FAILURE() << "no UserError was thrown";
    return "";
  }

  /** The message has all the @p words, is one line and shows no deal.II internals. */
  inline void expect_message(const std::string &message, const std::vector<std::string> &words)
  {
    for (const std::string &word : words)
      EXPECT_NE(message.find(word), std::string::npos) << '"' << word << "\" not in: " << message;
    for (const std::string unwanted : {"\n", "Stacktrace", "dealii", "MAX_DOUBLE"})
      EXPECT_EQ(message.find(unwanted), std::string::npos) << unwanted << " in: " << message;
  }
} // namespace ringmotor::sample
