// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sample.h"

namespace ringmotor::sample
{
  /** What a message has to say. */
  using Words = std::vector<std::string>;

  inline void expect_refused_override(const std::string &override_text, const Words &words)
  {
    expect_message(message_of([&] { with({override_text}); }), words);
  }

  inline void expect_refused_text(const std::string &text, const Words &words)
  {
    expect_message(message_of([&] { read_parameters_from_text(text, "my.prm"); }), words);
  }
} // namespace ringmotor::sample
