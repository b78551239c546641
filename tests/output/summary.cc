// SPDX-License-Identifier: LGPL-2.1-or-later
//
// summary.json: read back with the JSON library and compared with what was written.

#include "scratch.h"

#include <ringmotor/output/summary.h>
#include <ringmotor/parameters/errors.h>

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  Summary example()
  {
    Summary summary;
    summary.program        = "stator";
    summary.version        = "0.1.0";
    summary.git            = "abcdef";
    summary.blas_kernel    = "SkylakeX";
    summary.prm            = "subsection Motor\n  set Name = \"x\"\nend\n";
    summary.entries        = {{"Motor/Name", "x"}, {"Materials/Stator metal/Density", "8100"}};
    summary.identity       = {"some wave", "some motor"};
    summary.seconds        = {{"mesh", 0.25}, {"factorise", 1.5}, {"assemble", 0.5}};
    summary.peak_memory_MB = 123.5;
    summary.ranks          = {{2.5, 3.}, 3.25};
    summary.dofs           = 4294967296u;

    summary.results     = {{{"frequency", units::hertz,
                             Estimate(30004.123456789012, {{"body mesh", 1.5}, {"algebra", 2.0}})},
                            0.75,
                            {{"n", 7u}, {"family", std::string("axial")}, {"shift", 0.5}}}};
    summary.effects     = {{"Target plates", 0.01, "off"}, {"Tooth shear", {}, "on"}};
    summary.certificate = {{"missed modes", 0., 0.}, {"residual", 1e-12, 1e-9}};
    return summary;
  }
} // namespace

TEST(Summary, HoldsEverythingUnderItsName)
{
  const Scratch scratch;
  write_summary(scratch.path("summary.json"), example());
  const std::string text = content_of(scratch.path("summary.json"));

  const auto expected = nlohmann::json::parse(R"({
    "program": "stator", "version": "0.1.0", "git": "abcdef", "blas_kernel": "SkylakeX",
    "prm": "subsection Motor\n  set Name = \"x\"\nend\n",
    "entries": {"Motor/Name": "x", "Materials/Stator metal/Density": "8100"},
    "identity": {"wave": "some wave", "motor": "some motor"},
    "seconds": {"mesh": 0.25, "factorise": 1.5, "assemble": 0.5},
    "peak_memory_MB": 123.5,
    "ranks": {"shared_seconds": [2.5, 3.0], "longest_shares": 3.25},
    "dofs": 4294967296,
    "quantities": [{"name": "frequency", "n": 7, "family": "axial", "shift": 0.5,
                    "value": 30004.123456789012, "unit": "Hz", "error": 2.5,
                    "error_causes": {"body mesh": 1.5, "algebra": 2.0}, "seconds": 0.75}],
    "effects": [{"name": "Target plates", "indicator": 0.01, "choice": "off",
                 "automatic": false, "seconds": 0.0, "dofs": 0, "bytes": 0},
                {"name": "Tooth shear", "indicator": null, "choice": "on",
                 "automatic": false, "seconds": 0.0, "dofs": 0, "bytes": 0}],
    "certificate": {"holds": true,
                    "checks": [{"name": "missed modes", "value": 0.0, "limit": 0.0, "holds": true},
                               {"name": "residual", "value": 1e-12, "limit": 1e-9, "holds": true}]}
  })");
  EXPECT_EQ(nlohmann::json::parse(text), expected) << text;
  // phases are listed in the order of the run
  EXPECT_LT(text.find("factorise"), text.find("assemble"));
}

TEST(Summary, EmptyListsStayLists)
{
  const Scratch scratch;
  write_summary(scratch.path("s.json"), Summary());
  const auto json = nlohmann::json::parse(content_of(scratch.path("s.json")));
  EXPECT_TRUE(json["quantities"].is_array());
  EXPECT_TRUE(json["effects"].is_array());
  EXPECT_TRUE(json["seconds"].is_object());
  EXPECT_TRUE(json["certificate"]["checks"].is_array());
}

TEST(Summary, IsCertifiedOnlyIfSomethingWasCheckedAndEverythingHolds)
{
  Summary summary = example();
  EXPECT_TRUE(is_certified(summary));
  summary.certificate[1].value = 2e-9;
  EXPECT_FALSE(is_certified(summary));
  summary.certificate.clear();
  EXPECT_FALSE(is_certified(summary));
}

TEST(Summary, RefusesNumbersThatAreNotResults)
{
  const std::vector<std::pair<std::string, std::function<double &(Summary &)>>> members = {
      {"the quantity 'frequency'",
       [](Summary &s) -> double & { return s.results[0].quantity.estimate.value; }},
      {"the error 'algebra' of the quantity 'frequency'",
       [](Summary &s) -> double & { return s.results[0].quantity.estimate.errors["algebra"]; }},
      {"'Target plates'", [](Summary &s) -> double & { return *s.effects[0].indicator; }},
      {"the check 'residual'", [](Summary &s) -> double & { return s.certificate[1].value; }}};

  const Scratch scratch;
  for (const auto &[name, member] : members)
    for (const double number : {std::nan(""), -std::numeric_limits<double>::infinity()})
    {
      Summary summary           = example();
      member(summary)           = number;
      const std::string message = message_of<ComputationError>(
          [&]() { write_summary(scratch.path("summary.json"), summary); });
      EXPECT_NE(message.find(name), std::string::npos) << name << ": " << message;
    }
  EXPECT_EQ(scratch.n_entries(), 0u);
}

TEST(Summary, AForeignLetterInThePrmDoesNotLoseTheRun)
{
  const Scratch scratch;
  Summary summary = example();
  summary.prm     = "# 2 \xb5m"; // Latin-1, not UTF-8
  summary.entries = {{"Motor/Name", "2 \xb5m"}};
  write_summary(scratch.path("summary.json"), summary);
  const auto json = nlohmann::json::parse(content_of(scratch.path("summary.json")));
  EXPECT_EQ(json["prm"], "# 2 \xef\xbf\xbdm");
  EXPECT_EQ(json["entries"]["Motor/Name"], "2 \xef\xbf\xbdm");
}
