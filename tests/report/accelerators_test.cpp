// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "accelerators_experiment.hpp"

#include <gtest/gtest.h>

#include <map>

#include "sweepkit/render/render.hpp"

namespace sweepkit::report {
namespace {

TEST(Accelerators, EachIsMeasuredAtEverySizeAndOursFindTheSameHits) {
  const Experiment experiment = measure_accelerators({.is_quick = true});
  const Table& table = experiment.table;
  std::map<std::string, int> rows;
  for (const std::vector<Cell>& row : table.rows) {
    ASSERT_EQ(row.size(), table.columns.size());
    const std::string name = std::get<std::string>(row[table.column("accelerator")]);
    ++rows[name];
    EXPECT_GT(std::get<double>(row[table.column("seconds")]), 0);
    if (name != "embree") {
      EXPECT_EQ(std::get<double>(row[table.column("other_hits")]), 0) << name;
    }
  }
  // Four works at four sizes; the scan of all triangles at the two that are not over 10,000 or so.
  std::map<std::string, int> expected = {{"sweep", 16}, {"seads", 16}, {"linear", 8}};
  if (render::has_embree()) expected["embree"] = 16;
  EXPECT_EQ(rows, expected);
}

}  // namespace
}  // namespace sweepkit::report
