// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "stability_experiment.hpp"

#include <gtest/gtest.h>

#include <set>

#include "stability/stability_case.hpp"
#include "sweepkit/report/report.hpp"

namespace sweepkit::report {
namespace {

TEST(StabilityExperiment, HasARowForEveryCaseAndTheColumnsThatItsPlotNames) {
  const Experiment experiment = measure_stability({.is_quick = true});
  const Table& table = experiment.table;
  ASSERT_EQ(table.rows.size(), stability_cases().size());
  std::set<std::string> columns;
  for (const Column& column : table.columns) columns.insert(column.name);
  ASSERT_EQ(experiment.plots.size(), 2U);
  for (const Plot& plot : experiment.plots) {
    for (const std::string& name : {plot.x, plot.y, plot.by, plot.only, plot.label})
      EXPECT_TRUE(columns.contains(name)) << name;
    std::set<std::string> stages;
    for (const std::vector<Cell>& row : table.rows) {
      if (std::get<std::string>(row[table.column(plot.only)]) == plot.only_is)
        stages.insert(std::get<std::string>(row[table.column(plot.by)]));
    }
    EXPECT_EQ(stages.size(), 6U) << plot.name;
  }
  for (const std::vector<Cell>& row : table.rows) {
    ASSERT_EQ(row.size(), table.columns.size());
    EXPECT_GT(std::get<double>(row[table.column("over_bound_drawn")]), 0);
    const std::string& verdict = std::get<std::string>(row[table.column("verdict")]);
    EXPECT_TRUE(verdict == "pass" || verdict == "known limit") << std::get<std::string>(row[0]);
    EXPECT_EQ(verdict == "known limit", !std::get<std::string>(row[table.column("reason")]).empty());
  }
}

TEST(StabilityExperiment, IsAmongThoseThatCanBeRun) {
  std::set<std::string> names;
  for (const Runnable& one : runnables()) names.insert(one.name);
  EXPECT_TRUE(names.contains("stability"));
}

}  // namespace
}  // namespace sweepkit::report
