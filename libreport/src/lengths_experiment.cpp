// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "curves_experiment.hpp"
#include "gauss_legendre.hpp"
#include "quad.hpp"
#include "sweepkit/sweep/curve.hpp"
#include "timing.hpp"

namespace sweepkit::report {
namespace {

struct LengthCase {
  std::string name;
  std::string title;
  sweep::Segment<2> segment;
  Quad (*speed)(Quad t);
};

constexpr double kThinness = 1.0 / 128;
constexpr double kNearCusp = 1 - 1.0 / 1024;

Quad ellipse_speed(Quad t) {
  const Quad angle = 2 * quad_pi() * t;
  const Quad x = sinq(angle);
  const Quad y = static_cast<Quad>(kThinness) * cosq(angle);
  return 2 * quad_pi() * sqrtq(x * x + y * y);
}

// (0,0), (a,1), (1-a,1), (1,0): a cusp at t = 1/2 where a = 1.
Quad near_cusp_speed(Quad t) {
  const Quad a = kNearCusp;
  const Quad s = 1 - t;
  const Quad x = 3 * (a * s * s + 2 * (1 - 2 * a) * s * t + a * t * t);
  const Quad y = 3 * (s * s - t * t);
  return sqrtq(x * x + y * y);
}

std::vector<LengthCase> length_cases() {
  return {{"thin ellipse", "ellipse, 128 times as long as wide",
           sweep::ArcSegment<2>{{0, 0}, {1, 0}, {0, kThinness}, 0, 360}, ellipse_speed},
          {"near cusp", "cubic that almost stops half way",
           sweep::BezierSegment<2>{{{0, 0}, {kNearCusp, 1}, {1 - kNearCusp, 1}, {1, 0}}}, near_cusp_speed}};
}

double speed(const sweep::Segment<2>& segment, double t) {
  return glm::length(sweep::evaluate<2>(segment, t).first);
}

double by_chords(const sweep::Segment<2>& segment, int steps) {
  double sum = 0;
  glm::dvec2 here = sweep::evaluate<2>(segment, 0).position;
  for (int i = 1; i <= steps; ++i) {
    const glm::dvec2 next = sweep::evaluate<2>(segment, static_cast<double>(i) / steps).position;
    sum += glm::distance(here, next);
    here = next;
  }
  return sum;
}

double by_simpson(const sweep::Segment<2>& segment, int steps) {
  double sum = speed(segment, 0) + speed(segment, 1);
  for (int i = 1; i < steps; ++i)
    sum += (i % 2 == 1 ? 4 : 2) * speed(segment, static_cast<double>(i) / steps);
  return sum / (3 * steps);
}

double by_gauss(const sweep::Segment<2>& segment, int steps) {
  const int panels = std::max(steps / 16, 1);
  double sum = 0;
  for (int i = 0; i < panels; ++i) {
    sum += sweep::gauss_legendre_16(static_cast<double>(i) / panels, static_cast<double>(i + 1) / panels,
                                    [&](double t) { return speed(segment, t); });
  }
  return sum;
}

double by_curve(const sweep::Segment<2>& segment, int) {
  return sweep::Curve2({segment}).length();
}

struct LengthMethod {
  std::string name;
  double (*length)(const sweep::Segment<2>& segment, int steps);
  bool has_steps = true;
};

const std::array<LengthMethod, 4> kMethods = {{{"chords", by_chords},
                                               {"Simpson", by_simpson},
                                               {"Gauss-Legendre, even panels", by_gauss},
                                               {"Gauss-Legendre, adaptive", by_curve, false}}};

}  // namespace

Experiment measure_lengths(const Effort& effort) {
  Experiment experiment{
      .name = "lengths",
      .title = "Arc length",
      .what =
          "The relative error of a curve's length, against 81,920 Gauss-Legendre nodes in quadruple "
          "precision.",
      .how =
          "By the number of points at which the curve is evaluated. The adaptive rule is libsweep's: it has "
          "no knob, "
          "promises 1e-9, and its time is that of making the whole curve. Double precision, one thread."};
  Table& table = experiment.table;
  table.columns = {{"case", "case"}, {"method", "method"}, {"points", "points"}, {"error", "relative error"}};
  for (Column& column : timing_columns("one length")) table.columns.push_back(std::move(column));
  const std::vector<LengthCase> cases = length_cases();
  double done = 0;
  for (const LengthCase& one : cases) {
    effort.tell(done++ / static_cast<double>(cases.size()));
    const Quad exact = integrate(0, 1, 4096, one.speed);
    for (const LengthMethod& method : kMethods) {
      for (int steps = 16; steps <= (method.has_steps ? 16384 : 16); steps *= 2) {
        double length = 0;
        const Timing timing = time_calls(
            [&] {
              length = method.length(one.segment, steps);
              keep(length);
            },
            effort);
        std::vector<Cell> row{one.name, method.name,
                              method.has_steps ? Cell(static_cast<double>(steps)) : Cell("adaptive"),
                              static_cast<double>(magnitude(length - exact) / exact)};
        add_timing(row, timing);
        table.rows.push_back(std::move(row));
      }
    }
    experiment.plots.push_back(
        {.name = "lengths_" + std::string(one.name == "near cusp" ? "near_cusp" : "thin_ellipse"),
         .title = one.title,
         .x = "seconds",
         .y = "error",
         .by = "method",
         .only = "case",
         .only_is = one.name,
         .label = "points",
         .has_front = true});
  }
  return experiment;
}

}  // namespace sweepkit::report
