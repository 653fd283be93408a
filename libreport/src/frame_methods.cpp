// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on Wang, Juttler, Zheng, Liu, "Computation of rotation minimizing frames", ACM TOG 27 (2008), section
// 3, which compares the same four: projection (Klok 1986), rotation (Bloomenthal 1985), double reflection,
// and Runge-Kutta of fourth order on r' = -(x'' . r) x' / (x' . x').
//
// Symbols: x position, t unit tangent, r normal.

#include "frame_methods.hpp"

#include <cmath>

#include "rotation_minimizing_frames.hpp"

namespace sweepkit::report {
namespace {

using Points = std::span<const sweep::CurvePoint<3>>;
using Normals = std::span<glm::dvec3>;
using Evaluate = std::function<sweep::CurvePoint<3>(double)>;

// Along the chord onto the plane across the next tangent.
void project(Points points, double, double, const Evaluate&, Normals r) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const glm::dvec3 chord = points[i + 1].position - points[i].position;
    const glm::dvec3 t = points[i + 1].first;  // its length does not count
    r[i + 1] = glm::normalize(r[i] - glm::dot(r[i], t) / glm::dot(chord, t) * chord);
  }
}

// By the turn of one tangent into the next.
void rotate(Points points, double, double, const Evaluate&, Normals r) {
  glm::dvec3 from = glm::normalize(points[0].first);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const glm::dvec3 to = glm::normalize(points[i + 1].first);
    r[i + 1] = sweep::turn_normal(r[i], from, to);
    from = to;
  }
}

void reflect_twice(Points points, double, double, const Evaluate&, Normals r) {
  sweep::TangentPoint from{points[0].position, glm::normalize(points[0].first)};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const sweep::TangentPoint to{points[i + 1].position, glm::normalize(points[i + 1].first)};
    r[i + 1] = sweep::double_reflection(r[i], from, to);
    from = to;
  }
}

glm::dvec3 slope(const sweep::CurvePoint<3>& point, const glm::dvec3& r) {
  return -(glm::dot(point.second, r) / glm::dot(point.first, point.first)) * point.first;
}

void runge_kutta(Points points, double from, double step, const Evaluate& evaluate, Normals r) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const sweep::CurvePoint<3> middle = evaluate(from + (static_cast<double>(i) + 0.5) * step);
    const glm::dvec3 k1 = slope(points[i], r[i]);
    const glm::dvec3 k2 = slope(middle, r[i] + step / 2 * k1);
    const glm::dvec3 k3 = slope(middle, r[i] + step / 2 * k2);
    const glm::dvec3 k4 = slope(points[i + 1], r[i] + step * k3);
    r[i + 1] = r[i] + step / 6 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
}

}  // namespace

std::vector<FrameMethod> frame_methods() {
  return {{"chord projection", project},
          {"rotation", rotate},
          {"double reflection", reflect_twice},
          {"Runge-Kutta 4", runge_kutta}};
}

}  // namespace sweepkit::report
