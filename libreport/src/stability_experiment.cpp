// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "stability_experiment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "stability/stability_case.hpp"

namespace sweepkit::report {
namespace {

// Hardness without end (NaN, infinity, exactly on the edge) is drawn here.
constexpr double kHardestDrawn = 1e20;
// An error of 0 has no place on a logarithmic axis.
constexpr double kLeastDrawn = 1e-6;

Cell cell(const std::optional<double>& value) {
  return value ? Cell(*value) : Cell("");
}

std::string verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return "pass";
    case Verdict::kFail:
      return "fail";
    case Verdict::kKnownLimit:
      break;
  }
  return "known limit";
}

// The stages of a shape and of a picture are drawn apart: twelve curves in one plot cannot be told from each
// other.
constexpr const char* kShapes = "shapes";
constexpr const char* kPictures = "pictures";
constexpr std::array<std::string_view, 6> kShapeStages = {"curves", "lengths",       "frames",
                                                          "sweeps", "triangle maps", "export"};

const char* part_of(const std::string& stage) {
  return std::ranges::find(kShapeStages, stage) != kShapeStages.end() ? kShapes : kPictures;
}

// Stage by stage, the hardest last, so that a curve goes to the right.
std::vector<StabilityCase> in_order() {
  std::vector<StabilityCase> cases = stability_cases();
  for (auto from = cases.begin(); from != cases.end();) {
    const auto to = std::find_if(from, cases.end(),
                                 [stage = from->stage](const auto& one) { return one.stage != stage; });
    std::stable_sort(from, to, [](const auto& a, const auto& b) { return a.hardness < b.hardness; });
    from = to;
  }
  return cases;
}

}  // namespace

Experiment measure_stability(const Effort& effort) {
  Experiment experiment{
      .name = "stability",
      .title = "Stiff and extreme cases",
      .what =
          "What each case of a catalogue reached, and the bound that the promise it belongs to gives for its "
          "input. References are closed forms, quadruple precision or invariants.",
      .how =
          "One run a case, double precision but where a column says float32, one thread. Reached over bound "
          "below 1 keeps the promise; drawn at 1e-6 where it is less. A bound of 0 asks for the same bits."};
  Table& table = experiment.table;
  table.columns = {{"case", "case"},
                   {"stage", "stage"},
                   {"part", "part"},
                   {"input", "input"},
                   {"hardness", "how hard"},
                   {"hardness_drawn", "how hard (1e20 where more)"},
                   {"hardness_is", "what that is"},
                   {"promise", "promise"},
                   {"unit", "unit of reached and bound"},
                   {"reached", "reached"},
                   {"bound", "bound"},
                   {"over_bound", "reached over bound"},
                   {"over_bound_drawn", "reached over bound (1e-6 where less)"},
                   {"reached_float", "reached in float32"},
                   {"reached_double", "reached by the textbook in double"},
                   {"verdict", "verdict"},
                   {"reason", "reason of a known limit"}};
  const std::vector<StabilityCase> cases = in_order();
  double done = 0;
  for (const StabilityCase& one : cases) {
    effort.tell(done++ / static_cast<double>(cases.size()));
    const Reached reached = one.run();
    const double over = over_bound(reached);
    table.rows.push_back({one.name, one.stage, part_of(one.stage), one.input, one.hardness,
                          std::min(one.hardness, kHardestDrawn), one.hardness_is, one.promise, one.unit,
                          reached.error, reached.bound, over, over < kLeastDrawn ? kLeastDrawn : over,
                          cell(reached.in_float), cell(reached.in_double),
                          verdict_name(verdict_of(one, reached)), one.limit});
  }
  for (const std::string part : {kShapes, kPictures}) {
    experiment.plots.push_back({.name = "stability_" + part,
                                .title = part + ": reached over bound against hardness; 1 is the promise",
                                .x = "hardness_drawn",
                                .y = "over_bound_drawn",
                                .by = "stage",
                                .only = "part",
                                .only_is = part,
                                .label = "case",
                                .has_lines = false});
  }
  return experiment;
}

}  // namespace sweepkit::report
