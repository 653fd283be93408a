// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Every case of the catalogue of stiff and extreme input, twice: against its bound, and with floating-point
// traps, which end the program where a NaN or an infinity is made on the way.

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <set>

#include "stability/stability_case.hpp"

namespace sweepkit::report {
namespace {

constexpr int kTraps = FE_INVALID | FE_DIVBYZERO;

class StiffCase : public testing::TestWithParam<StabilityCase> {};

TEST_P(StiffCase, KeepsItsBoundOrHasAReasonWhyNot) {
  const StabilityCase& one = GetParam();
  const Reached reached = one.run();
  EXPECT_FALSE(std::isnan(reached.error)) << one.input;
  EXPECT_TRUE(std::isfinite(reached.bound) && reached.bound >= 0);
  EXPECT_NE(verdict_of(one, reached), Verdict::kFail)
      << one.input << ": reached " << reached.error << " " << one.unit << ", bound " << reached.bound;
}

TEST_P(StiffCase, MakesNoNaNOrInfinityOnTheWayOrHasAReasonWhy) {
  const StabilityCase& one = GetParam();
  std::feclearexcept(FE_ALL_EXCEPT);
  if (one.raises.empty()) feenableexcept(kTraps);
  one.run();
  fedisableexcept(kTraps);
  if (!one.raises.empty()) {
    EXPECT_NE(std::fetestexcept(kTraps), 0) << "it raises none: the reason has gone";
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, StiffCase, testing::ValuesIn(stability_cases()),
                         [](const auto& one) { return one.param.name; });

TEST(StabilityCatalogue, HasSixtyCasesOfDifferentNamesOverEveryStage) {
  std::set<std::string> names;
  std::set<std::string> stages;
  for (const StabilityCase& one : stability_cases()) {
    names.insert(one.name);
    stages.insert(one.stage);
    EXPECT_TRUE(one.hardness > 0 && std::isfinite(one.hardness)) << one.name;
    EXPECT_FALSE(one.input.empty() || one.hardness_is.empty() || one.promise.empty() || one.unit.empty())
        << one.name;
  }
  EXPECT_GE(names.size(), 60U);
  EXPECT_EQ(names.size(), stability_cases().size());
  EXPECT_EQ(stages.size(), 12U);
}

TEST(StabilityCatalogue, CallsABrokenBoundAFailureAndAKeptLimitToo) {
  StabilityCase one;
  EXPECT_EQ(verdict_of(one, {.error = 1, .bound = 1}), Verdict::kPass);
  EXPECT_EQ(verdict_of(one, {.error = 2, .bound = 1}), Verdict::kFail);
  EXPECT_EQ(verdict_of(one, {.error = NAN, .bound = 1}), Verdict::kFail);
  one.limit = "float32";
  EXPECT_EQ(verdict_of(one, {.error = 2, .bound = 1}), Verdict::kKnownLimit);
  EXPECT_EQ(verdict_of(one, {.error = 1, .bound = 1}), Verdict::kFail);
}

TEST(StabilityCatalogue, ComparesWithABoundOfNothingToo) {
  EXPECT_EQ(over_bound({.error = 1, .bound = 4}), 0.25);
  EXPECT_EQ(over_bound({.error = 0, .bound = 0}), 0);
  EXPECT_EQ(over_bound({.error = 1, .bound = 0}), INFINITY);
  EXPECT_TRUE(std::isnan(over_bound({.error = NAN, .bound = 0})));
}

}  // namespace
}  // namespace sweepkit::report
