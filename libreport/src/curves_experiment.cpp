// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "curves_experiment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "bezier_methods.hpp"
#include "quad.hpp"
#include "timing.hpp"

namespace sweepkit::report {
namespace {

// Control points in a box, as people draw them.
std::vector<glm::dvec3> drawn_control(std::size_t degree) {
  std::mt19937_64 random(degree);
  // Not a distribution of the library's: those differ from one to another.
  const auto coordinate = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1; };
  std::vector<glm::dvec3> control(degree + 1);
  for (glm::dvec3& point : control) point = {coordinate(), coordinate(), coordinate()};
  return control;
}

// (t - 3/4)^n, whose control points cancel beside its root: b[i] = (-3/4)^(n-i) (1/4)^i, exact up to
// degree 32.
std::vector<glm::dvec3> cancelling_control(std::size_t degree) {
  std::vector<glm::dvec3> control;
  for (std::size_t i = 0; i <= degree; ++i) {
    control.emplace_back(std::pow(-0.75, static_cast<double>(degree - i)) *
                         std::pow(0.25, static_cast<double>(i)));
  }
  return control;
}

struct Case {
  std::string name;
  std::string title;
  std::vector<glm::dvec3> (*control)(std::size_t degree);
  double from, to;   // where it is evaluated
  bool is_relative;  // the error: to the value itself, else to the largest control coordinate
};

const std::array<Case, 2> kCases = {
    {{"drawn", "control points as people draw them", drawn_control, 0, 1, false},
     {"cancelling", "(t - 3/4)^n beside its root", cancelling_control, 0.5, 0.7, true}}};

using QuadPoint = std::array<Quad, 3>;

QuadPoint exact_point(const std::vector<glm::dvec3>& control, double t) {
  std::vector<QuadPoint> b;
  for (const glm::dvec3& point : control) b.push_back({point.x, point.y, point.z});
  const Quad s = 1 - static_cast<Quad>(t);
  for (std::size_t left = control.size() - 1; left > 0; --left) {
    for (std::size_t i = 0; i < left; ++i) {
      for (std::size_t k = 0; k < 3; ++k) b[i][k] = s * b[i][k] + t * b[i + 1][k];
    }
  }
  return b[0];
}

struct Exact {
  std::vector<double> parameters;
  std::vector<QuadPoint> points;
  double largest = 0;  // control coordinate
};

Exact exact_points(const Case& one, const std::vector<glm::dvec3>& control) {
  constexpr int kParameters = 256;
  Exact exact;
  for (int i = 0; i < kParameters; ++i) {
    exact.parameters.push_back(one.from + (one.to - one.from) * (i + 0.5) / kParameters);
    exact.points.push_back(exact_point(control, exact.parameters.back()));
  }
  for (const glm::dvec3& point : control) {
    for (glm::length_t k = 0; k < 3; ++k) exact.largest = std::max(exact.largest, std::abs(point[k]));
  }
  return exact;
}

double worst_error(const Case& one, const Exact& exact, const std::vector<glm::dvec3>& points) {
  double worst = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (glm::length_t k = 0; k < 3; ++k) {
      const Quad right = exact.points[i][static_cast<std::size_t>(k)];
      const Quad scale = one.is_relative ? magnitude(right) : static_cast<Quad>(exact.largest);
      worst = std::max(worst, static_cast<double>(magnitude(points[i][k] - right) / scale));
    }
  }
  return worst;
}

void measure_degree(const Case& one, std::size_t degree, const Effort& effort, Table& table) {
  const std::vector<glm::dvec3> control = one.control(degree);
  const Exact exact = exact_points(one, control);
  const std::vector<BezierMethod> methods = bezier_methods();
  std::vector<std::vector<glm::dvec3>> points(methods.size(),
                                              std::vector<glm::dvec3>(exact.parameters.size()));
  std::vector<std::function<void()>> calls;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    calls.emplace_back([&, m] {
      methods[m].evaluate(control, exact.parameters, points[m]);
      keep(points[m]);
    });
  }
  const std::vector<Timing> timings = time_in_turn(calls, effort);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::vector<Cell> row{one.name, methods[m].name, static_cast<double>(degree),
                          worst_error(one, exact, points[m])};
    add_timing(row, timings[m].of_each(exact.parameters.size()));
    table.rows.push_back(std::move(row));
  }
}

}  // namespace

Experiment measure_curves(const Effort& effort) {
  Experiment experiment{.name = "curves",
                        .title = "Points of Bezier segments",
                        .what =
                            "The largest error of a coordinate over 256 parameters, against de Casteljau's "
                            "scheme in quadruple precision. "
                            "For control points as people draw them it is relative to the largest control "
                            "coordinate; for (t - 3/4)^n "
                            "beside its root, where the control points cancel, relative to the value itself.",
                        .how =
                            "Degrees 2 to 32. The time is that of one point of three coordinates, what a "
                            "method works out once for a "
                            "segment shared among 256 points. Double precision, one thread."};
  Table& table = experiment.table;
  table.columns = {
      {"case", "case"}, {"method", "method"}, {"degree", "degree"}, {"error", "largest relative error"}};
  for (Column& column : timing_columns("one point")) table.columns.push_back(std::move(column));
  const std::array<std::size_t, 9> degrees = {2, 3, 5, 8, 12, 16, 20, 26, 32};
  double done = 0;
  for (const Case& one : kCases) {
    for (const std::size_t degree : degrees) {
      effort.tell(done++ / static_cast<double>(kCases.size() * degrees.size()));
      measure_degree(one, degree, effort, table);
    }
    const Plot plot{.name = "curves_" + one.name,
                    .title = one.title,
                    .x = "seconds",
                    .y = "error",
                    .by = "method",
                    .only = "case",
                    .only_is = one.name,
                    .label = "degree"};
    experiment.plots.push_back(plot);
    experiment.plots.push_back(plot);
    Plot& by_degree = experiment.plots.back();
    by_degree.name += "_by_degree";
    by_degree.title += ", by degree";
    by_degree.x = "degree";
    by_degree.is_x_log = false;
  }
  return experiment;
}

}  // namespace sweepkit::report
