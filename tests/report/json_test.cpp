// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "sweepkit/report/report.hpp"

namespace sweepkit::report {
namespace {

using nlohmann::json;

Experiment small_experiment() {
  return {.name = "e",
          .title = "E",
          .what = "what",
          .how = "how",
          .table = {{{"case", "case"},
                     {"method", "method"},
                     {"n", "knob"},
                     {"seconds", "time (s)"},
                     {"error", "error"}},
                    {{"one", "a", 1.0, 2.0, 0.5},
                     {"two", "a", 1.0, 1.0, 0.1},
                     {"one", "b", 1.0, 1.0, std::nan("")},
                     {"one", "a", 2.0, 4.0, 0.25},
                     {"one", "b", 2.0, 3.0, 0.5}}},
          .plots = {{.name = "e_one",
                     .title = "One",
                     .x = "seconds",
                     .y = "error",
                     .by = "method",
                     .only = "case",
                     .only_is = "one",
                     .label = "n",
                     .has_front = true}}};
}

TEST(PlotJson, HasACurveForEachMethodAndTellsTheRowOfEveryPoint) {
  const Experiment experiment = small_experiment();
  const json plot = json::parse(plot_json(experiment, experiment.plots[0]));
  EXPECT_EQ(plot["curves"],
            json::parse(R"([{"name": "a", "points": [[2.0, 0.5, "1.0", 0], [4.0, 0.25, "2.0", 3]]},
                                            {"name": "b", "points": [[1.0, null, "1.0", 2], [3.0, 0.5, "2.0", 4]]}])"))
      << "a failure is kept, as null";
  EXPECT_EQ(plot["front"], json::parse("[[2.0, 0.5], [4.0, 0.25]]"));
  EXPECT_EQ(plot["x"]["title"], "time (s)");
  EXPECT_EQ(plot["y"]["log"], true);
}

TEST(ReportJson, HoldsEveryRowAndTheMachine) {
  const Report report{.version = "1",
                      .date = "d",
                      .is_quick = true,
                      .machine = this_machine(),
                      .experiments = {small_experiment()}};
  const json all = json::parse(to_json(report));
  EXPECT_EQ(all["experiments"][0]["rows"].size(), 5u);
  EXPECT_TRUE(all["experiments"][0]["rows"][2][4].is_null());
  EXPECT_FALSE(all["experiments"][0]["plots"][0].contains("curves"));
  EXPECT_TRUE(json::parse(to_json(report, true))["experiments"][0]["plots"][0].contains("curves"));
  EXPECT_FALSE(all["machine"]["processor"].get<std::string>().empty());
  EXPECT_GE(all["machine"]["threads"], 1);
}

}  // namespace
}  // namespace sweepkit::report
