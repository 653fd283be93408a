// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "harness.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

namespace {

using namespace sweepkit::bench;

TEST(Harness, TakesTheMiddleRunForTheMedian) {
  const Spread odd = spread({5, 1, 3});
  EXPECT_EQ(odd.median, 3);
  EXPECT_EQ(odd.min, 1);
  EXPECT_EQ(odd.max, 5);
  EXPECT_EQ(spread({4, 1, 2, 100}).median, 3);
}

TEST(Harness, RunsContendersInTurnAndEachRoundInTheOppositeOrder) {
  std::string order;
  const std::vector<Contender> contenders = {{"a", [&] { order += 'a'; }, {}, {}},
                                             {"b", [&] { order += 'b'; }, {}, {}}};
  compare("order", contenders, 3);
  EXPECT_EQ(order,
            "ab"
            "ab"
            "ba"
            "ab");  // the first pair warms up
}

TEST(Harness, PreparesAndChecksEveryRunOutsideOfTheClock) {
  int prepared = 0;
  int checked = 0;
  const auto slow = [](int& count) {
    ++count;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  };
  const Comparison comparison = compare("idle",
                                        {{"nothing", [] {},
                                          [&] {
                                            slow(checked);
                                            return std::string();
                                          },
                                          [&] { slow(prepared); }}},
                                        3);
  EXPECT_EQ(prepared, 4);
  EXPECT_EQ(checked, 4);
  // Nothing takes far less than the 5 ms that stand outside; a busy machine may add a pause to one run, not
  // to the median.
  EXPECT_LT(comparison.results[0].seconds.median, 2e-3);
}

TEST(Harness, RefusesToTimeAWrongResult) {
  const std::vector<Contender> contenders = {
      {"liar", [] {}, [] { return std::string("is off by one"); }, {}}};
  try {
    compare("lies", contenders, 1);
    FAIL() << "the wrong result was taken";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "liar: is off by one");
  }
}

TEST(Harness, TellsTimesForOneCallAndRatiosToTheFirst) {
  const auto sleep = [](int ms) {
    return [ms] { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); };
  };
  const auto start = std::chrono::steady_clock::now();
  const Comparison comparison =
      compare("sleep", {{"short", sleep(2), {}, {}, 3}, {"long", sleep(20), {}, {}}}, 3);
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const Result& shorter = comparison.results[0];
  const Result& longer = comparison.results[1];
  EXPECT_EQ(shorter.ratio.median, 1);
  EXPECT_GE(shorter.seconds.min, 2e-3);  // a sleep is never shorter than asked for
  EXPECT_LT(shorter.seconds.min, 6e-3);  // but three of them together are at least 6 ms
  EXPECT_GE(longer.seconds.min, 20e-3);
  EXPECT_GT(longer.ratio.median, 2);  // 10 on an idle machine
  // However busy the machine is, nine short ones and three long ones fit into the whole.
  EXPECT_LE(9 * shorter.seconds.min + 3 * longer.seconds.min, elapsed);
  const Comparison once = compare("sleep", {{"short", sleep(2), {}, {}, 3}, {"long", sleep(20), {}, {}}}, 1);
  EXPECT_DOUBLE_EQ(once.results[1].ratio.median,
                   once.results[1].seconds.median / once.results[0].seconds.median);
}

TEST(Harness, WritesOneRowAContender) {
  const Comparison comparison{
      "sort", 9, {{"std", {1, 0.5, 2}, {1, 1, 1}}, {"ours", {0.25, 0.125, 0.5}, {0.25, 0.2, 0.3}}}};
  EXPECT_EQ(
      to_csv({comparison}),
      "comparison,contender,rounds,seconds_median,seconds_min,seconds_max,ratio_median,ratio_min,ratio_max\n"
      "sort,std,9,1,0.5,2,1,1,1\n"
      "sort,ours,9,0.25,0.125,0.5,0.25,0.2,0.3\n");
  EXPECT_NE(to_table(comparison).find("ours"), std::string::npos);
  EXPECT_NE(to_table(comparison).find("250 ms"), std::string::npos);
}

}  // namespace
