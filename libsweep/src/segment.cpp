// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Points, derivatives and directions of one segment.
// Bezier segments by de Casteljau's corner cutting: only convex combinations, so the error stays at a few
// units in the last place times the condition number at any degree. Its last four levels give the
// derivatives.
// The direction at a point where the speed is 0: near t + h the curve moves along h S'', so S'' leads on from
// there and -S'' led to it; where S'' is 0 as well, a short chord stands in.

#include "segment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "whole_angle.hpp"

namespace sweepkit::sweep {
namespace {

template <int D>
CurvePoint<D> evaluate_segment(const BezierSegment<D>& segment, double t) {
  // Degrees in common use need no memory of their own: curves are measured by evaluating them often.
  constexpr std::size_t kCommonSize = 16;
  const std::size_t degree = segment.control.size() - 1;
  std::array<Vector<D>, kCommonSize> common;
  std::vector<Vector<D>> large(degree < kCommonSize ? 0 : degree + 1);
  Vector<D>* level = degree < kCommonSize ? common.data() : large.data();
  std::copy(segment.control.begin(), segment.control.end(), level);
  const auto n = static_cast<double>(degree);
  CurvePoint<D> point{Vector<D>(0.0), Vector<D>(0.0), Vector<D>(0.0), Vector<D>(0.0)};
  for (std::size_t left = degree; left > 0; --left) {
    if (left == 3) {
      const Vector<D> middle = level[2] - level[1];
      point.third =
          n * (n - 1) * (n - 2) * (((level[3] - level[2]) - middle) - (middle - (level[1] - level[0])));
    }
    if (left == 2) point.second = n * (n - 1) * ((level[2] - level[1]) - (level[1] - level[0]));
    if (left == 1) point.first = n * (level[1] - level[0]);
    for (std::size_t i = 0; i < left; ++i) level[i] = (1 - t) * level[i] + t * level[i + 1];
  }
  point.position = level[0];
  return point;
}

template <int D>
CurvePoint<D> evaluate_segment(const ArcSegment<D>& segment, double t) {
  const double sweep_deg = segment.to_deg - segment.from_deg;
  const double rate = sweep_deg * (std::numbers::pi / 180.0);
  const auto [c, s] = cos_sin_deg(t == 1 ? segment.to_deg : segment.from_deg + t * sweep_deg);
  const Vector<D> radial = c * segment.x_axis + s * segment.y_axis;
  const Vector<D> around = rate * (c * segment.y_axis - s * segment.x_axis);
  return {segment.center + radial + t * segment.rise, around + segment.rise, -rate * rate * radial,
          -rate * rate * around};
}

template <int D>
CurvePoint<D> evaluate_segment(const TorusKnotSegment& knot, double t) {
  // w is the distance from the axis, its derivatives by s after it; (c, s) the angle about the axis.
  const double p = knot.p;
  const double q = knot.q;
  const auto [c, s] = cos_sin_deg(360 * p * t);
  const auto [c_tube, s_tube] = cos_sin_deg(360 * q * t);
  const double r = knot.tube;
  const double w = knot.radius + r * c_tube;
  const double w1 = -q * r * s_tube;
  const double w2 = -q * q * r * c_tube;
  const double w3 = q * q * q * r * s_tube;
  constexpr double kTurn = 2 * std::numbers::pi;
  return {
      {w * c, r * s_tube, -w * s},
      kTurn * Vector<D>(w1 * c - p * w * s, q * r * c_tube, -(w1 * s + p * w * c)),
      kTurn * kTurn *
          Vector<D>(w2 * c - 2 * p * w1 * s - p * p * w * c, -q * q * r * s_tube,
                    -(w2 * s + 2 * p * w1 * c - p * p * w * s)),
      kTurn * kTurn * kTurn *
          Vector<D>(w3 * c - 3 * p * w2 * s - 3 * p * p * w1 * c + p * p * p * w * s, -q * q * q * r * c_tube,
                    -(w3 * s + 3 * p * w2 * c - 3 * p * p * w1 * s - p * p * p * w * c))};
}

template <int D>
Vector<D> far_end(const Segment<D>& segment, double t) {
  if (const auto* bezier = std::get_if<BezierSegment<D>>(&segment))
    return t < 0.5 ? bezier->control.back() : bezier->control.front();
  return evaluate<D>(segment, t < 0.5 ? 1.0 : 0.0).position;
}

}  // namespace

template <int D>
CurvePoint<D> evaluate(const Segment<D>& segment, double t) {
  return std::visit([t](const auto& kind) { return evaluate_segment<D>(kind, t); }, segment);
}

template <int D>
Vector<D> tangent(const Segment<D>& segment, double t) {
  return tangent_of<D>(segment, t, evaluate<D>(segment, t));
}

template <int D>
Vector<D> tangent_of(const Segment<D>& segment, double t, const CurvePoint<D>& here) {
  const double scale = glm::length(here.second) + glm::length(far_end<D>(segment, t) - here.position);
  // The derivative is off by a few units in the last place of the control points: below a 1e-11 share of
  // their size it may have turned by more than find_corners() in curve.cpp takes for smooth.
  const double speed = glm::length(here.first);
  if (speed > 1e-11 * (scale + glm::length(here.position))) return here.first / speed;
  // Still slowing down: the point of rest is ahead.
  const bool is_backward = t == 1 || glm::dot(here.first, here.second) < 0;
  const double bend = glm::length(here.second);
  if (bend > 1e-6 * scale) return (is_backward ? -here.second : here.second) / bend;
  if (const auto* bezier = std::get_if<BezierSegment<D>>(&segment); bezier && (t == 0 || t == 1)) {
    // Where control points are repeated the limit is towards the first that is not.
    const std::size_t last = bezier->control.size() - 1;
    for (std::size_t k = 1; k <= last; ++k) {
      const Vector<D> chord = t == 0 ? bezier->control[k] - bezier->control[0]
                                     : bezier->control[last] - bezier->control[last - k];
      const double length = glm::length(chord);
      if (length > 1e-12 * scale) return chord / length;
    }
  }
  double step = 1e-5;
  for (int tries = 0; tries < 9; ++tries, step *= 4) {  // up to 0.66
    const double other = is_backward ? std::max(0.0, t - step) : std::min(1.0, t + step);
    Vector<D> chord = evaluate<D>(segment, other).position - here.position;
    if (is_backward) chord = -chord;
    const double length = glm::length(chord);
    if (length > 1e-12 * scale) return chord / length;
  }
  const Vector<D> chord = evaluate<D>(segment, 1.0).position - evaluate<D>(segment, 0.0).position;
  const double length = glm::length(chord);
  Vector<D> fallback{0.0};
  fallback[0] = 1;
  return length > 0 ? chord / length : fallback;
}

template CurvePoint<2> evaluate<2>(const Segment<2>&, double);
template CurvePoint<3> evaluate<3>(const Segment<3>&, double);
template Vector<2> tangent<2>(const Segment<2>&, double);
template Vector<3> tangent<3>(const Segment<3>&, double);
template Vector<2> tangent_of<2>(const Segment<2>&, double, const CurvePoint<2>&);
template Vector<3> tangent_of<3>(const Segment<3>&, double, const CurvePoint<3>&);

}  // namespace sweepkit::sweep
