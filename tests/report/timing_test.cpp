// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "timing.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace sweepkit::report {
namespace {

TEST(Timing, IsOfOneCallFromAtLeastFiveRuns) {
  using namespace std::chrono_literals;
  const Timing timing = time_calls([] { std::this_thread::sleep_for(2ms); }, {.is_quick = true});
  EXPECT_GE(timing.runs, 5);
  EXPECT_GE(timing.least, 2e-3);
  EXPECT_LE(timing.least, timing.median);
  EXPECT_LE(timing.median, timing.most);
  EXPECT_EQ(timing.of_each(4).median, timing.median / 4);
}

TEST(Timing, OfShortCallsIsThatOfManyOver) {
  int count = 0;
  const Timing timing = time_calls([&] { keep(++count); }, {.is_quick = true});
  EXPECT_LT(timing.median, 1e-6);
  EXPECT_GT(timing.median, 0);
  EXPECT_GT(count, 1000);
}

}  // namespace
}  // namespace sweepkit::report
