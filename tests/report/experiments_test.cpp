// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sweepkit/report/report.hpp"

namespace sweepkit::report {
namespace {

class QuickRun : public testing::TestWithParam<std::string> {
 protected:
  static Experiment run() {
    for (const Runnable& one : runnables()) {
      if (one.name == GetParam()) return one.run({.is_quick = true});
    }
    ADD_FAILURE() << "no such experiment";
    return {};
  }
};

std::string text_of(const Cell& cell) {
  const auto* text = std::get_if<std::string>(&cell);
  return text != nullptr ? *text : std::to_string(std::get<double>(cell));
}

TEST_P(QuickRun, HasFullRowsAndPlotsOfAtLeastTwoMethodsAndFourPoints) {
  const Experiment experiment = run();
  EXPECT_EQ(experiment.name, GetParam());
  EXPECT_FALSE(experiment.what.empty());
  EXPECT_FALSE(experiment.how.empty());
  EXPECT_FALSE(experiment.plots.empty());
  const Table& table = experiment.table;
  for (const std::vector<Cell>& row : table.rows) ASSERT_EQ(row.size(), table.columns.size());
  for (const Plot& plot : experiment.plots) {
    std::set<std::string> methods;
    std::size_t points = 0;
    for (const std::vector<Cell>& row : table.rows) {
      if (!plot.only.empty() && text_of(row[table.column(plot.only)]) != plot.only_is) continue;
      methods.insert(text_of(row[table.column(plot.by)]));
      ++points;
    }
    EXPECT_GE(methods.size(), 2u) << plot.name;
    EXPECT_GE(points, 4u) << plot.name;
  }
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Runnable& one : runnables()) all.push_back(one.name);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Experiments, QuickRun, testing::ValuesIn(names()),
                         [](const auto& test) { return test.param; });

TEST(Runnables, HaveNamesOfTheirOwn) {
  const std::vector<std::string> all = names();
  EXPECT_EQ(std::set(all.begin(), all.end()).size(), all.size());
}

}  // namespace
}  // namespace sweepkit::report
