// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Experiments as `sweepkit report --quick` runs them: the tables have what the plots name, and all the rows.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "filters_experiment.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/report/report.hpp"
#include "tessellation_experiment.hpp"
#include "triangle_maps_experiment.hpp"

namespace sweepkit::report {
namespace {

std::string text_of(const Cell& cell) {
  const auto* text = std::get_if<std::string>(&cell);
  return text != nullptr ? *text : std::to_string(std::get<double>(cell));
}

std::set<std::string> values_of(const Table& table, const std::string& column) {
  std::set<std::string> values;
  for (const std::vector<Cell>& row : table.rows) values.insert(text_of(row[table.column(column)]));
  return values;
}

bool has_column(const Table& table, const std::string& name) {
  return std::any_of(table.columns.begin(), table.columns.end(),
                     [&](const Column& column) { return column.name == name; });
}

void expect_whole(const Experiment& experiment) {
  const Table& table = experiment.table;
  for (const std::vector<Cell>& row : table.rows) ASSERT_EQ(row.size(), table.columns.size());
  std::set<std::string> names;
  for (const Plot& plot : experiment.plots) {
    EXPECT_TRUE(names.insert(plot.name).second) << plot.name;
    for (const std::string& column : {plot.x, plot.y, plot.by, plot.only, plot.label})
      ASSERT_TRUE(column.empty() || has_column(table, column)) << plot.name << ' ' << column;
    std::set<std::string> methods;
    int points = 0;
    for (const std::vector<Cell>& row : table.rows) {
      if (!plot.only.empty() && text_of(row[table.column(plot.only)]) != plot.only_is) continue;
      EXPECT_TRUE(std::holds_alternative<double>(row[table.column(plot.x)])) << plot.name;
      EXPECT_TRUE(std::holds_alternative<double>(row[table.column(plot.y)])) << plot.name;
      methods.insert(text_of(row[table.column(plot.by)]));
      ++points;
    }
    EXPECT_GE(methods.size(), 2U) << plot.name;
    EXPECT_GE(points, 4) << plot.name;
  }
  for (const std::vector<Cell>& row : table.rows) {
    EXPECT_GT(std::get<double>(row[table.column("seconds_least")]), 0);
    EXPECT_GE(std::get<double>(row[table.column("runs")]), 5);
  }
}

Experiment quick_run_of(const std::string& name) {
  for (const Runnable& one : runnables()) {
    if (one.name == name) return one.run({.is_quick = true, .samples = SWEEPKIT_SAMPLES});
  }
  ADD_FAILURE() << "no such experiment: " << name;
  return {};
}

TEST(QuickRun, OfCurvesLengthsAndFramesHasFullRows) {
  for (const char* name : {"curves", "lengths", "frames"}) {
    const Experiment experiment = quick_run_of(name);
    EXPECT_EQ(experiment.name, name);
    EXPECT_FALSE(experiment.what.empty()) << name;
    EXPECT_FALSE(experiment.how.empty()) << name;
    EXPECT_FALSE(experiment.plots.empty()) << name;
    expect_whole(experiment);
  }
}

TEST(Runnables, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const Runnable& one : runnables()) EXPECT_TRUE(names.insert(one.name).second) << one.name;
}

TEST(QuickRun, OfTessellationHasEveryShapeByCountsAndByTolerance) {
  const Experiment experiment = measure_tessellation({.is_quick = true});
  expect_whole(experiment);
  EXPECT_EQ(values_of(experiment.table, "shape"),
            (std::set<std::string>{"vase", "trefoil", "spring", "spindle"}));
  EXPECT_EQ(values_of(experiment.table, "method"),
            (std::set<std::string>{"counts, equal", "counts, balanced", "tolerance"}));
  EXPECT_EQ(experiment.plots.size(), 8U);
}

TEST(QuickRun, OfTriangleMapsHasEveryKindNumberAndMethod) {
  const Experiment experiment = measure_triangle_maps({.is_quick = true});
  expect_whole(experiment);
  // 13 kinds and 9 bounds of b, of float and double, by 6 methods.
  EXPECT_EQ(experiment.table.rows.size(), (13U + 9U) * 2 * 6);
  const Table& table = experiment.table;
  for (const std::vector<Cell>& row : table.rows) {
    if (text_of(row[table.column("method")]).rfind("area-ratio", 0) != 0) continue;
    EXPECT_EQ(std::get<double>(row[table.column("wrong")]), 0) << text_of(row[0]);
  }
}

TEST(QuickRun, OfFiltersHasThePeerBesideEveryFilter) {
  const Experiment experiment = measure_filters({.is_quick = true});
  expect_whole(experiment);
  EXPECT_EQ(experiment.how.find("MISSING"), std::string::npos);
  EXPECT_EQ(values_of(experiment.table, "pixel_filter"), (std::set<std::string>{"tent", "box"}));
  EXPECT_EQ(values_of(experiment.table, "method").count("OpenImageIO smart bicubic"), 1U);
  EXPECT_EQ(values_of(experiment.table, "method").count("auto"), 1U);
}

TEST(QuickRun, OfFiltersSaysLoudlyThatThePeerIsMissing) {
  const Experiment experiment = measure_filters_beside({.is_quick = true}, nullptr, "gone fishing");
  expect_whole(experiment);
  EXPECT_NE(experiment.how.find("MISSING"), std::string::npos);
  EXPECT_NE(experiment.how.find("gone fishing"), std::string::npos);
  for (const std::string& method : values_of(experiment.table, "method"))
    EXPECT_EQ(method.find("OpenImageIO"), std::string::npos);
}

TEST(QuickRun, OfFiltersEndsWhereThePeerHasNoFolderForItsPyramid) {
  const char* const before = std::getenv("TMPDIR");
  const std::string kept = before != nullptr ? before : "";
  setenv("TMPDIR", "/no/such/folder", 1);
  EXPECT_THROW(measure_filters({.is_quick = true}), OutputError);
  before != nullptr ? setenv("TMPDIR", kept.c_str(), 1) : unsetenv("TMPDIR");
}

}  // namespace
}  // namespace sweepkit::report
