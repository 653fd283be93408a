// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "frames_experiment.hpp"

#include <algorithm>
#include <cmath>

#include "frame_methods.hpp"
#include "sample_curves.hpp"
#include "scene_files.hpp"
#include "test_curves.hpp"
#include "timing.hpp"

namespace sweepkit::report {
namespace {

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

double worst_angle(const std::vector<glm::dvec3>& normals, const std::vector<glm::dvec3>& exact) {
  double worst = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const double angle = angle_between(normals[i], exact[i]);
    if (!(angle <= worst)) worst = angle;  // a NaN stays
    if (std::isnan(worst)) break;
  }
  return worst;
}

void measure_curve(const TestCurve& curve, int steps, const Effort& effort, Table& table) {
  const double step = (curve.to - curve.from) / steps;
  const std::vector<glm::dvec3> exact = curve.normals(steps);
  std::vector<sweep::CurvePoint<3>> points;
  for (int i = 0; i <= steps; ++i)
    points.push_back(curve.evaluate(curve.from + (curve.to - curve.from) * i / steps));
  const std::vector<FrameMethod> methods = frame_methods();
  std::vector<std::vector<glm::dvec3>> normals(methods.size(),
                                               std::vector<glm::dvec3>(exact.size(), exact[0]));
  std::vector<std::function<void()>> calls;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    calls.emplace_back([&, m] {
      methods[m].carry(points, curve.from, step, curve.evaluate, normals[m]);
      keep(normals[m]);
    });
  }
  const std::vector<Timing> timings = time_in_turn(calls, effort);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::vector<Cell> row{curve.name, methods[m].name, static_cast<double>(steps),
                          worst_angle(normals[m], exact)};
    add_timing(row, timings[m]);
    table.rows.push_back(std::move(row));
  }
}

}  // namespace

Experiment measure_frames(const Effort& effort) {
  Experiment experiment{.name = "frames",
                        .title = "Frames along a trajectory",
                        .what =
                            "The largest angle, in radians, between the normal that a method carries along "
                            "the curve and the exact "
                            "rotation-minimizing one: Frenet's turned back by the integral of the torsion, "
                            "in quadruple precision. For trajectories of scenes it comes from Runge-Kutta's "
                            "method in 16 times finer "
                            "steps and in 65,536 at least, none across a joint of segments.",
                        .how =
                            "N even steps of the parameter, points and first derivatives given; Runge-Kutta "
                            "evaluates the curve between "
                            "them and pays for it. Double precision, one thread."};
  Table& table = experiment.table;
  table.columns = {{"curve", "curve"},
                   {"method", "method"},
                   {"steps", "steps N"},
                   {"radians", "largest angle error (rad)"}};
  for (Column& column : timing_columns("all N steps")) table.columns.push_back(std::move(column));
  std::vector<TestCurve> curves = test_curves();
  for (TestCurve& curve : sample_curves(effort)) curves.push_back(std::move(curve));
  const int most = effort.is_quick ? 4096 : 65536;
  double done = 0;
  for (const TestCurve& curve : curves) {
    for (int steps = 16; steps <= most; steps *= effort.is_quick ? 4 : 2) {
      effort.tell((done + std::log2(steps / 16.0) / std::log2(most / 8.0)) /
                  static_cast<double>(curves.size()));
      measure_curve(curve, steps, effort, table);
    }
    experiment.plots.push_back({.name = "frames_" + file_name(curve.name),
                                .title = curve.name + ": " + curve.title,
                                .x = "seconds",
                                .y = "radians",
                                .by = "method",
                                .only = "curve",
                                .only_is = curve.name,
                                .label = "steps",
                                .has_front = true});
    done += 1;
  }
  return experiment;
}

}  // namespace sweepkit::report
