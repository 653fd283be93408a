// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <charconv>
#include <limits>

#include "sweepkit/report/report.hpp"

namespace sweepkit::report {
namespace {

TEST(Csv, HasALineOfNamesAndQuotesWhatNeedsIt) {
  const Table table{{{"a", "first"}, {"b", "second"}}, {{1.5, "plain"}, {2.0, "one, \"two\"\nthree"}}};
  EXPECT_EQ(to_csv(table), "a,b\n1.5,plain\n2,\"one, \"\"two\"\"\nthree\"\n");
}

TEST(Csv, NumbersReadBackTheSameAndFailuresAreNamed) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double third = 1.0 / 3;
  const Table table{{{"x", "x"}},
                    {{third}, {std::numeric_limits<double>::quiet_NaN()}, {kInfinity}, {-kInfinity}}};
  const std::string csv = to_csv(table);
  double back = 0;
  std::from_chars(csv.data() + 2, csv.data() + csv.size(), back);
  EXPECT_EQ(back, third);
  EXPECT_TRUE(csv.ends_with("\nnan\ninf\n-inf\n")) << csv;
}

}  // namespace
}  // namespace sweepkit::report
