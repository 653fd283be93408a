// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "front.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sweepkit::report {
namespace {

TEST(Front, HoldsWhatNoOtherPointBeatsInBoth) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> digit(0, 30);  // so that many are equal in one
  for (int round = 0; round < 200; ++round) {
    std::vector<PlotPoint> points(40);
    for (PlotPoint& point : points)
      point = {static_cast<double>(digit(random)), static_cast<double>(digit(random))};
    const std::vector<PlotPoint> front = front_of(points);
    for (const PlotPoint& point : points) {
      // Something of the front is as good in both, and nothing is better than it in both.
      EXPECT_TRUE(std::any_of(front.begin(), front.end(),
                              [&](const PlotPoint& best) { return best.x <= point.x && best.y <= point.y; }));
      for (const PlotPoint& best : front) EXPECT_FALSE(point.x < best.x && point.y < best.y);
    }
    for (std::size_t i = 1; i < front.size(); ++i) {
      EXPECT_LT(front[i - 1].x, front[i].x);
      EXPECT_GT(front[i - 1].y, front[i].y);
    }
  }
}

TEST(Front, LeavesOutWhatFailed) {
  const double nan = std::nan("");
  const std::vector<PlotPoint> front = front_of({{nan, 0}, {1, 2}, {0, nan}});
  ASSERT_EQ(front.size(), 1u);
  EXPECT_EQ(front[0].y, 2);
  EXPECT_TRUE(front_of({}).empty());
}

}  // namespace
}  // namespace sweepkit::report
