// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "leaving_out_experiment.hpp"

#include <gtest/gtest.h>

#include "sweepkit/error.hpp"
#include "sweepkit/scene/plan.hpp"

namespace sweepkit::report {
namespace {

// A scene of one object has no tree over objects, and none of what glass needs, but with everything on it
// has.
TEST(LeavingOut, IsMeasuredPartByPartForTheSamePicture) {
  const Experiment experiment = measure_leaving_out({.is_quick = true, .samples = SWEEPKIT_SAMPLES});
  const Table& table = experiment.table;
  ASSERT_EQ(table.rows.size(), 2U * 4);
  for (std::size_t i = 0; i < table.rows.size(); i += 2) {
    const auto number = [&](std::size_t row, const char* column) {
      return std::get<double>(table.rows[row][table.column(column)]);
    };
    ASSERT_EQ(table.rows[i].size(), table.columns.size());
    EXPECT_EQ(std::get<std::string>(table.rows[i][table.column("same_picture")]), "yes");
    EXPECT_LT(number(i, "parts"), number(i + 1, "parts"));
    EXPECT_LT(number(i, "bytes"), number(i + 1, "bytes"));
    EXPECT_EQ(number(i + 1, "time_share"), 1);
    EXPECT_GE(number(i, "runs"), 5);
  }
  ASSERT_EQ(experiment.derived.size(), 1U);
  const Table& parts = experiment.derived[0].table;
  ASSERT_EQ(parts.rows.size(), 4U * scene::kPartCount);
  double saved = 0;
  for (const std::vector<Cell>& row : parts.rows) {
    ASSERT_EQ(row.size(), parts.columns.size());
    EXPECT_FALSE(std::get<std::string>(row[parts.column("why")]).empty());
    if (std::get<std::string>(row[parts.column("needed")]) == "yes") continue;
    EXPECT_EQ(std::get<double>(row[parts.column("bytes")]), 0) << std::get<std::string>(row[1]);
    EXPECT_EQ(std::get<double>(row[parts.column("calls")]), 0) << std::get<std::string>(row[1]);
    saved += std::get<double>(row[parts.column("bytes_if_on")]);
  }
  EXPECT_GT(saved, 0);
}

TEST(LeavingOut, EndsWithTheErrorOfASceneThatCannotBeRead) {
  EXPECT_THROW(measure_leaving_out({.is_quick = true, .scene = "no/such/scene.json"}), InputError);
}

}  // namespace
}  // namespace sweepkit::report
