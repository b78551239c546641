// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Tables as CSV: the quoting rules are those of RFC 4180, numbers must be read back (strtod) as the
// same double.

#include "scratch.h"

#include <ringmotor/output/table.h>
#include <ringmotor/parameters/errors.h>

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>

using namespace ringmotor;
using namespace ringmotor::tests;

TEST(CsvTable, IsPlainAndPretty)
{
  const Scratch scratch;
  CsvTable table({"n", "family", "frequency_Hz", "error_Hz"});
  table.add_row({7u, "axial", 30004., 2.5});
  table.add_row({-1, "", 0.1, 1e-7});
  table.write(scratch.path("frequencies.csv"));
  EXPECT_EQ(content_of(scratch.path("frequencies.csv")), "n,family,frequency_Hz,error_Hz\n"
                                                         "7,axial,30004,2.5\n"
                                                         "-1,,0.1,1e-07\n");
}

TEST(CsvTable, QuotesTextsThatNeedIt)
{
  CsvTable table({"plain", "with, comma"});
  table.add_row({"say \"n = 7\"", "two\nlines"});
  EXPECT_EQ(table.to_csv(), "plain,\"with, comma\"\n\"say \"\"n = 7\"\"\",\"two\nlines\"\n");
}

TEST(CsvTable, LosesNoDigit)
{
  for (const double number : {1. / 3., std::nextafter(30004., 1e9), 5e-324, -1.7976931348623157e308,
                              std::acos(-1.), 2e-6, 123456789012345680.})
  {
    CsvTable table({"x"});
    table.add_row({number});
    const std::string csv = table.to_csv();
    EXPECT_EQ(std::strtod(csv.c_str() + 2, nullptr), number) << csv;
  }
}

TEST(CsvTable, RefusesWhatIsNotAResult)
{
  CsvTable table({"n", "frequency_Hz"});
  for (const double number : {std::nan(""), std::numeric_limits<double>::infinity()})
  {
    const std::string message = message_of<ComputationError>([&]() { table.add_row({7, number}); });
    EXPECT_NE(message.find("frequency_Hz"), std::string::npos) << message;
  }
  EXPECT_EQ(table.to_csv(), "n,frequency_Hz\n");
}
