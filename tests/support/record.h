// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace ringmotor::tests
{
  /** Keeps a measured number in the report of the running test (--gtest_output), for
   * doc/verification.md (scripts/development/test_records.py). The name says what it is and its
   * unit; numbers of one name make a list, in the order of the calls.
   */
  inline void record(const std::string &name, const double value)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%.4g", value);
    std::string all = text;
    const testing::TestResult &report =
        *testing::UnitTest::GetInstance()->current_test_info()->result();
    for (int i = 0; i < report.test_property_count(); ++i)
      if (report.GetTestProperty(i).key() == name)
        all = report.GetTestProperty(i).value() + (", " + all);
    testing::Test::RecordProperty(name, all);
  }
} // namespace ringmotor::tests
