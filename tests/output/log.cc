// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The log's lines have a fixed form; times are compared with pauses of known length.

#include <ringmotor/output/log.h>

#include <chrono>
#include <gtest/gtest.h>
#include <memory>
#include <regex>
#include <sstream>
#include <thread>

using namespace ringmotor;

namespace
{
  void pause_ms(const int duration)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(duration));
  }

  bool has_form(const std::string &text, const std::string &form)
  {
    return std::regex_match(text, std::regex(form));
  }
} // namespace

TEST(Log, PrintsPlainLinesInAFile)
{
  std::ostringstream out;
  Log log(true, out, false);
  log.line("mesh: 40 cells");
  log.progress("frames", 0.5);
  log.line("done");
  EXPECT_TRUE(has_form(out.str(), R"(\[ +\d+\.\d\d s\] mesh: 40 cells\n\[ +\d+\.\d\d s\] done\n)"))
      << out.str();
}

TEST(Log, ShowsProgressOnATerminalAndWipesIt)
{
  std::ostringstream out;
  Log log(true, out, true);
  log.progress("frames", 0.);
  log.progress("frames", 0.25);
  log.line("a line in between");
  log.progress("frames", 1.);
  log.line("done");
  const std::string stamp = R"(\[ +\d+\.\d\d s\] )", wipe = "\r\033\\[K";
  EXPECT_TRUE(has_form(out.str(), stamp + "frames: 0 %" + wipe + stamp +
                                      "frames: 25 %, \\d+ s left" + wipe + stamp +
                                      "a line in between\n" + wipe + stamp + "done\n"))
      << out.str();
}

TEST(Log, ForeseesTheTimeLeft)
{
  std::ostringstream out;
  Log log(true, out, true);
  pause_ms(300); // time before the task must not count
  const auto now   = []() { return std::chrono::steady_clock::now(); };
  using Seconds    = std::chrono::duration<double>;
  const auto begin = now();
  log.progress("steps", 0.);
  const auto begun = now();
  pause_ms(100);
  const auto end = now();
  log.progress("steps", 0.01); // one of a hundred: 99 times as long remains
  const auto ended = now();
  std::smatch left;
  const std::string text = out.str();
  ASSERT_TRUE(std::regex_search(text, left, std::regex(R"(1 %, (\d+) s left)"))) << text;
  EXPECT_GE(std::stoi(left[1]), 99. * Seconds(end - begun).count() - 1.);
  EXPECT_LE(std::stoi(left[1]), 99. * Seconds(ended - begin).count() + 1.);
}

TEST(Log, IsSilentOnOtherRanks)
{
  std::ostringstream out;
  Log log(false, out, true);
  log.line("text");
  log.progress("frames", 0.5);
  EXPECT_EQ(out.str(), "");
}

TEST(Phases, AddUpInTheOrderOfTheRun)
{
  Phases phases;
  for (unsigned int pass = 0; pass < 2; ++pass)
  {
    {
      const auto scope = phases.measure("solve");
      pause_ms(20);
    }
    const auto scope = phases.measure("assemble");
    pause_ms(1);
  }
  ASSERT_EQ(phases.seconds().size(), 2u);
  EXPECT_EQ(phases.seconds()[0].first, "solve");
  EXPECT_EQ(phases.seconds()[1].first, "assemble");
  EXPECT_GE(phases.seconds()[0].second, 0.040);
  EXPECT_GE(phases.seconds()[1].second, 0.002);
}

TEST(PeakMemory, SeesALargeArray)
{
  const double before = peak_memory_MB();
  EXPECT_GT(before, 1.);
  // Larger than anything before, so it must raise the peak; written to, so it is resident.
  const std::size_t n_bytes = static_cast<std::size_t>(before * 1e6) + 100000000;
  const std::vector<char> memory(n_bytes, 'x');
  EXPECT_GE(peak_memory_MB(), before + 99. + memory[0] - 'x');
}
