// SPDX-License-Identifier: LGPL-2.1-or-later

// The properties of friction laws other than the coefficient, against their definitions in
// doc/theory.md: which entries they need, when a static limit is lost within a step and when
// memories agree in a steady state, each as a table of all cases. The search for the memory of the
// law with a jump terminates: a point gets mu_s at most once and loses it at most once. Advice
// names existing entries.

#include "support/paper_motor.h"
#include <deal.II/base/parameter_handler.h>

#include <ringmotor/contact/friction_law.h>
#include <ringmotor/parameters/declared_entries.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/parameters.h>

#include <gtest/gtest.h>

#include <regex>
#include <set>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  const FrictionLaw all_words[]      = {FrictionLaw("coulomb"), FrictionLaw("static-dynamic"),
                                        FrictionLaw("velocity"), FrictionLaw("slip-weakening")};
  constexpr PointStatus all_status[] = {PointStatus::open, PointStatus::stick, PointStatus::slip};

  Friction friction_of(const FrictionLaw word)
  {
    Friction friction;
    friction.law                 = word;
    friction.static_coefficient  = 0.5;
    friction.dynamic_coefficient = 0.3;
    return friction;
  }

  /** The message with which a law refuses its entries, or an empty string. */
  std::string refusal(const Friction &friction)
  {
    try
    {
      law_of(friction).check(friction);
      return "";
    }
    catch (const UserError &error)
    {
      return error.what();
    }
  }

  /** Settles the memory of a point that was assumed to have stuck or not. */
  bool settle_stuck(const bool found, const PointStatus status, const bool had_stuck, bool &stuck)
  {
    const Friction friction = friction_of(FrictionLaw("static-dynamic"));
    FrictionMemory memory{stuck, 0.};
    const bool agreed = law_of(friction).settle(friction, {found, 0.}, status, had_stuck, memory);
    stuck             = memory.stuck;
    return agreed;
  }
} // namespace

TEST(FrictionLawList, HasAClassForEachWordOfTheEntry)
{
  dealii::ParameterHandler prm;
  Friction friction;
  friction.declare(prm);
  const std::string allowed = DeclaredEntries(prm).find("Law")->allowed;
  const std::regex word("[^ |]+");
  std::set<FrictionLaw> seen;
  for (std::sregex_iterator found(allowed.begin(), allowed.end(), word), end; found != end; ++found)
  {
    prm.parse_input_from_string("set Law = " + found->str());
    EXPECT_TRUE(seen.insert(friction.law).second) << found->str();
    EXPECT_EQ(law_of(friction).entry.name, friction.law.entry().name) << found->str();
  }
  EXPECT_EQ(seen.size(), 4u) << allowed;
  EXPECT_EQ(all_friction_laws().size(), seen.size());
}

TEST(FrictionLawList, RefusesALawThatIsMissing)
{
  EXPECT_ANY_THROW(law_of(friction_of(FrictionLaw("none"))));
}

TEST(FrictionLaws, NeedTheirEntries)
{
  for (const FrictionLaw word : all_words)
  {
    Friction with_length = friction_of(word), with_velocity = friction_of(word);
    with_length.weakening_length          = 1e-7;
    with_velocity.decay_velocity          = 0.1;
    const std::string without_velocity    = refusal(with_length),
                      without_length      = refusal(with_velocity);
    const std::string velocity_and_unit[] = {"Law = velocity", "Decay velocity", "m/s"};
    const std::string length_and_unit[]   = {"Law = slip-weakening", "Weakening length", "m"};
    EXPECT_EQ(without_velocity.empty(), word != FrictionLaw("velocity")) << without_velocity;
    EXPECT_EQ(without_length.empty(), word != FrictionLaw("slip-weakening")) << without_length;
    for (const std::string &part : velocity_and_unit)
      EXPECT_EQ(without_velocity.find(part) != std::string::npos, word == FrictionLaw("velocity"));
    for (const std::string &part : length_and_unit)
      EXPECT_EQ(without_length.find(part) != std::string::npos,
                word == FrictionLaw("slip-weakening"));
  }
}

TEST(FrictionLaws, HaveAnExcessUnlessOneCoefficientIsAll)
{
  for (const FrictionLaw word : all_words)
  {
    Friction friction = friction_of(word);
    EXPECT_EQ(has_static_excess(friction), word != FrictionLaw("coulomb"));
    friction.static_coefficient = 0.2; // below the dynamic one: unusual, but different
    EXPECT_EQ(has_static_excess(friction), word != FrictionLaw("coulomb"));
    friction.static_coefficient = 0.3;
    EXPECT_FALSE(has_static_excess(friction));
  }
}

TEST(FrictionLaws, LoseAStaticLimitOnlyWhereItJumpsAndThePointSlips)
{
  for (const FrictionLaw word : all_words)
    for (const bool stuck : {true, false})
      for (const PointStatus status : all_status)
      {
        FrictionMemory memory{stuck, 2e-7};
        const bool loses =
            word == FrictionLaw("static-dynamic") && stuck && status == PointStatus::slip;
        EXPECT_EQ(law_of(friction_of(word)).lose_static_limit(status, memory), loses);
        EXPECT_EQ(memory.stuck, stuck && !loses);
        EXPECT_EQ(memory.slipped, 2e-7);
        EXPECT_FALSE(law_of(friction_of(word)).lose_static_limit(status, memory)) << "twice";
      }
}

TEST(FrictionMemory, IsSettledAtOnceWhereTheCoefficientDoesNotDependOnIt)
{
  for (const FrictionLaw word : {FrictionLaw("coulomb"), FrictionLaw("velocity")})
    for (const PointStatus status : all_status)
    {
      const Friction friction = friction_of(word);
      FrictionMemory memory{false, 1e-7};
      EXPECT_TRUE(law_of(friction).settle(friction, {true, 5e-7}, status, false, memory));
    }
}

TEST(FrictionMemory, OfTheJumpGoesByWhatSticks)
{
  struct Case
  {
    bool stuck, found;
    PointStatus status;
    bool had_stuck, next;
  };
  const PointStatus open = PointStatus::open, stick = PointStatus::stick, slip = PointStatus::slip;
  for (const Case &row :
       std::vector<Case>{// It sticks, and so did the previous one: kept; if either slips: lost.
                         {true, true, stick, true, true},
                         {true, true, slip, true, false},
                         {true, false, stick, true, false},
                         {true, false, slip, true, false},
                         // Without the static coefficient the previous one counts, but only once.
                         {false, true, stick, false, true},
                         {false, true, slip, false, true},
                         {false, true, stick, true, false},
                         {false, true, slip, true, false},
                         {false, false, stick, false, false},
                         {false, false, slip, false, false},
                         // An open point bears no friction.
                         {true, false, open, true, true},
                         {false, true, open, false, false}})
  {
    bool stuck = row.stuck;
    EXPECT_EQ(settle_stuck(row.found, row.status, row.had_stuck, stuck), row.next == row.stuck);
    EXPECT_EQ(stuck, row.next) << row.stuck << row.found << int(row.status) << row.had_stuck;
  }
}

TEST(FrictionMemory, OfTheJumpEndsItsSearchWhateverIsFound)
{
  // All sequences of six solutions, in each of which the previous point stuck or not.
  constexpr unsigned int n_solutions = 6, n_cases = 6 * 6 * 6 * 6 * 6 * 6;
  unsigned int most[] = {0, 0};
  for (const bool start : {false, true})
    for (unsigned int sequence = 0; sequence < n_cases; ++sequence)
    {
      bool stuck = start, had_stuck = start;
      unsigned int n_changes = 0;
      for (unsigned int k = 0, rest = sequence; k < n_solutions; ++k, rest /= 6)
      {
        n_changes += !settle_stuck(rest % 2 == 1, all_status[rest % 6 / 2], had_stuck, stuck);
        had_stuck = had_stuck || stuck;
      }
      most[start] = std::max(most[start], n_changes);
    }
  EXPECT_EQ(most[false], 2u); // gets it and loses it
  EXPECT_EQ(most[true], 1u);  // loses it
}

TEST(FrictionMemory, OfTheDistanceSlippedSettlesToAPartOfTheWeakeningLength)
{
  Friction friction         = friction_of(FrictionLaw("slip-weakening"));
  friction.weakening_length = 4e-6; // of which 1e-9 is 4e-15 m
  for (const PointStatus status : all_status)
    for (const double change : {-5e-15, -3e-15, 0., 3e-15, 5e-15, 1e-7})
    {
      FrictionMemory memory{true, 1e-6};
      const FrictionMemory found{false, 1e-6 + change};
      EXPECT_EQ(law_of(friction).settle(friction, found, status, false, memory),
                std::abs(change) < 4e-15)
          << change;
      EXPECT_EQ(memory.slipped, found.slipped);
      EXPECT_FALSE(memory.stuck);
    }
}

TEST(FrictionLaws, ThatDependOnTheDistanceSlippedStartFromGivenCoefficients)
{
  for (const FrictionLaw word : all_words)
    EXPECT_EQ(law_of(friction_of(word)).starts_from_given_coefficients(),
              word == FrictionLaw("slip-weakening"));
}

TEST(FrictionLaws, AdviseEntriesThatThereAre)
{
  // Laws with slip weakening may have no steady state; the others always have one.
  Parameters parameters = paper_motor();
  dealii::ParameterHandler prm;
  parameters.declare(prm);
  const DeclaredEntries entries(prm);
  const std::regex path("[A-Z][a-z]+/[A-Z][a-z]+( velocity)?");
  for (const FrictionLaw word : all_words)
  {
    const std::string remedy = law_of(friction_of(word)).remedy();
    std::set<std::string> named;
    for (std::sregex_iterator found(remedy.begin(), remedy.end(), path), end; found != end; ++found)
    {
      named.insert(found->str());
      EXPECT_NE(entries.find(found->str()), nullptr) << found->str();
    }
    const bool falls = word == FrictionLaw("velocity") || word == FrictionLaw("slip-weakening");
    EXPECT_EQ(named.count("Time/Scheme"), falls ? 1u : 0u) << remedy;
    EXPECT_EQ(named.count("Friction/Decay velocity"), word == FrictionLaw("velocity") ? 1u : 0u);
    EXPECT_EQ(remedy.rfind("; ", 0) == 0, falls) << "it goes on where a message ends";
  }
}
