// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "triangle_maps_experiment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include "triangle_map_costs.hpp"
#include "triangle_map_errors.hpp"

namespace sweepkit::report {
namespace {

using texmap::Hardness;

// What the paper says a method takes for a hit - multiplications, divisions and square roots - and keeps for
// a triangle in double; "" where it gives no number [Akdemir98, sections 2.1 to 2.3 and 3.1].
struct PaperCost {
  Cell operations, bytes;
};
const std::array<PaperCost, kMapNames.size()> kPaper = {
    {{"", ""}, {36.0, 17 * 8.0}, {"", 9 * 8.0}, {16.0, 0.0}, {"", ""}, {"", ""}}};

struct Case {
  std::string name;
  Cell b_most;  // "" where it is not what is varied
};

Cell failing(double value, double failed, double most) {
  return failed > most ? std::numeric_limits<double>::quiet_NaN() : value;
}

double operations(const texmap::OperationCounts& counts) {
  return counts.multiplications + counts.divisions + counts.square_roots;
}

template <class Real>
void measure_case(const Case& one, const CaseMaker<Real>& make, const Effort& effort, Table& table) {
  constexpr bool kIsFloat = std::is_same_v<Real, float>;
  const std::uint64_t pairs = effort.is_quick ? 4'000 : 200'000;
  const KindRecord record =
      measure_map_errors<Real>(make, pairs, std::max(1u, std::thread::hardware_concurrency()));
  const MapTimings timings = time_maps<Real>(make, effort);
  const auto costs = map_costs();
  for (std::size_t row = 0; row < kMapNames.size(); ++row) {
    const MapRecord& map = record.maps[row];
    const double failed = static_cast<double>(map.not_finite) / static_cast<double>(map.pairs);
    std::vector<Cell> cells{one.name,
                            one.b_most,
                            kIsFloat ? "float" : "double",
                            std::string(kMapNames[row]),
                            static_cast<double>(map.pairs),
                            failing(map.median, failed, 0.5),
                            failing(map.percentile99, failed, 0.01),
                            failing(map.largest, failed, 0),
                            failed,
                            failed + static_cast<double>(map.wrong) / static_cast<double>(map.pairs),
                            static_cast<double>(costs[row].hit.multiplications),
                            static_cast<double>(costs[row].hit.divisions),
                            static_cast<double>(costs[row].hit.square_roots),
                            operations(costs[row].hit),
                            operations(costs[row].prepare),
                            static_cast<double>(kIsFloat ? costs[row].float_bytes : costs[row].double_bytes),
                            kPaper[row].operations,
                            kPaper[row].bytes,
                            timings.prepare[row].median};
    add_timing(cells, timings.hit[row]);
    table.rows.push_back(std::move(cells));
  }
}

void add_plots(Experiment& experiment) {
  struct Shown {
    Hardness kind;
    const char* file;
  };
  for (const Shown& shown : {Shown{Hardness::kNone, "ordinary"},
                             {Hardness::kHypotenuse, "hypotenuse"},
                             {Hardness::kSliver, "slivers"},
                             {Hardness::kOrigin, "origin"},
                             {Hardness::kDiagonal, "diagonal"},
                             {Hardness::kAll, "all"}}) {
    const std::string name(texmap::kHardnessNames[static_cast<std::size_t>(shown.kind)]);
    experiment.plots.push_back({.name = std::string("triangle_maps_") + shown.file,
                                .title = "Triangles and hits: " + name,
                                .x = "seconds",
                                .y = "error_99",
                                .by = "method",
                                .only = "case",
                                .only_is = name,
                                .label = "number",
                                .has_front = true});
  }
  for (const char* number : {"float", "double"}) {
    const std::string only = std::string("by b, ") + number;
    for (const char* y : {"error_99", "wrong"}) {
      experiment.plots.push_back({.name = std::string("triangle_maps_by_b_") + number + "_" + y,
                                  .title = std::string("Hits near the hypotenuse, ") + number,
                                  .x = "b_most",
                                  .y = y,
                                  .by = "method",
                                  .only = "case",
                                  .only_is = only,
                                  .label = "number"});
    }
  }
  for (const char* x : {"operations", "bytes"}) {
    experiment.plots.push_back({.name = std::string("triangle_maps_by_") + x,
                                .title = "What the methods take: ordinary triangles",
                                .x = x,
                                .y = "seconds",
                                .by = "method",
                                .only = "case",
                                .only_is = "ordinary",
                                .label = "number",
                                .is_x_log = false,
                                .is_y_log = false,
                                .has_front = true});
  }
}

}  // namespace

Experiment measure_triangle_maps(const Effort& effort) {
  Experiment experiment{
      .name = "triangle_maps",
      .title = "From a hit on a triangle to its texture coordinates",
      .what =
          "The five methods that the paper compares, and the default with nothing prepared. The error is "
          "that "
          "of (u,v), the legs being 1, against the exact map of the same numbers in quadruple precision: the "
          "median, the 99th percentile and the largest, the first two within a quarter (they come from "
          "bins). A "
          "result that is NaN or infinite is a failure; where more than half, a hundredth or any fail, there "
          "is "
          "no such number. Wrong is what fails, and what is past 8 steps of the conditioning. b is the right "
          "angle's barycentric coordinate, evenly from 0 to the number given: 0 is the hypotenuse, the "
          "diagonal "
          "of every cell of a sweep. paper_operations and paper_bytes are what the paper states.",
      .how =
          "The time is that of one hit with what was prepared for its triangle, out of 1,024 in a row, on "
          "one "
          "thread; preparing is timed apart. Operations are counted by a number type that counts: "
          "multiplications, divisions and square roots."};
  Table& table = experiment.table;
  table.columns = {{"case", "triangles and hits"},
                   {"b_most", "largest b"},
                   {"number", "number type"},
                   {"method", "method"},
                   {"pairs", "hits"},
                   {"error_median", "error, median"},
                   {"error_99", "error, 99th percentile (legs are 1)"},
                   {"error_largest", "error, largest"},
                   {"not_finite", "share that is NaN or infinite"},
                   {"wrong", "share that is wrong"},
                   {"multiplications", "multiplications for a hit"},
                   {"divisions", "divisions for a hit"},
                   {"square_roots", "square roots for a hit"},
                   {"operations", "multiplications, divisions and square roots for a hit"},
                   {"operations_once", "the same for a triangle"},
                   {"bytes", "bytes kept for a triangle"},
                   {"paper_operations", "the paper: operations for a hit"},
                   {"paper_bytes", "the paper: bytes kept for a triangle, double"},
                   {"seconds_prepare", "time to prepare a triangle (s)"}};
  for (Column& column : timing_columns("one hit")) table.columns.push_back(std::move(column));

  constexpr int kDecades = 9;
  const double steps = static_cast<double>(texmap::kHardnessNames.size()) + kDecades;
  double done = 0;
  for (std::size_t i = 0; i < texmap::kHardnessNames.size(); ++i) {
    const auto kind = static_cast<Hardness>(i);
    const Case one{std::string(texmap::kHardnessNames[i]), ""};
    measure_case<float>(
        one, [kind](std::uint64_t n) { return texmap::make_case<float>(kind, n); }, effort, table);
    measure_case<double>(
        one, [kind](std::uint64_t n) { return texmap::make_case<double>(kind, n); }, effort, table);
    effort.tell(++done / steps);
  }
  for (int decade = 0; decade < kDecades; ++decade) {
    const double b_most = std::pow(10.0, -decade);
    measure_case<float>(
        {"by b, float", b_most}, [=](std::uint64_t n) { return case_near_hypotenuse<float>(b_most, n); },
        effort, table);
    measure_case<double>(
        {"by b, double", b_most}, [=](std::uint64_t n) { return case_near_hypotenuse<double>(b_most, n); },
        effort, table);
    effort.tell(++done / steps);
  }
  add_plots(experiment);
  return experiment;
}

}  // namespace sweepkit::report
