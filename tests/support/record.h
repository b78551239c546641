// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace ringmotor::tests
{
  /** Keeps a measured number in the test's XML report (--gtest_output=xml), for the documentation.
   */
  inline void record(const std::string &name, const double value)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%.4g", value);
    testing::Test::RecordProperty(name, text);
  }
} // namespace ringmotor::tests
