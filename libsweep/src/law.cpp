// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Points are joined by cubic Hermite pieces. Their slopes are the weighted harmonic means of Fritsch and
// Butland, "A method for constructing local monotone piecewise cubic interpolants" (1984), which are 0 at a
// turning point and keep every piece between its ends' values.

#include "sweepkit/sweep/law.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "number_text.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::sweep {
namespace {

// An upright tangent of a Bezier law is as steep as this.
constexpr double kSteepest = 1e9;

void check_points(const std::vector<glm::dvec2>& points, bool may_repeat) {
  if (points.empty()) throw InputError("needs at least 1 point [t, value], got 0");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string which = "point " + std::to_string(i);
    if (!(points[i].x >= 0 && points[i].x <= 1)) {
      throw InputError(which + " needs t from 0 to 1, the share of the length, got " +
                       number_text(points[i].x));
    }
    if (!std::isfinite(points[i].y)) throw InputError(which + " needs a finite value");
    if (i == 0) continue;
    if (points[i].x < points[i - 1].x || (points[i].x == points[i - 1].x && !may_repeat)) {
      throw InputError(which + " needs t above the point's before it, got " + number_text(points[i].x) +
                       " after " + number_text(points[i - 1].x));
    }
  }
}

// Slope at the end of a piece `h` wide and `d` steep, next to one `h_next` wide and `d_next` steep: the
// parabola's through the three points, held back where that would overshoot.
double end_slope(double h, double d, double h_next, double d_next) {
  const double slope = ((2 * h + h_next) * d - h * d_next) / (h + h_next);
  if (slope * d <= 0) return 0;
  if (d * d_next <= 0 && std::abs(slope) > 3 * std::abs(d)) return 3 * d;
  return slope;
}

}  // namespace

Law::Law(double value) {
  if (!std::isfinite(value)) throw InputError("needs a finite number");
  shape_ = std::vector<Knot>{{0, value, 0}};
}

Law Law::through(const std::vector<glm::dvec2>& points) {
  check_points(points, false);
  std::vector<Knot> knots;
  knots.reserve(points.size());
  for (const glm::dvec2& p : points) knots.push_back({p.x, p.y, 0});
  const std::size_t pieces = knots.size() - 1;
  const auto width = [&](std::size_t i) { return knots[i + 1].t - knots[i].t; };
  const auto steepness = [&](std::size_t i) { return (knots[i + 1].value - knots[i].value) / width(i); };
  if (pieces == 1) {
    knots[0].slope = knots[1].slope = steepness(0);
  } else if (pieces > 1) {
    for (std::size_t i = 1; i < pieces; ++i) {
      const double before = steepness(i - 1);
      const double after = steepness(i);
      if (before * after <= 0) continue;
      const double w1 = 2 * width(i) + width(i - 1);
      const double w2 = width(i) + 2 * width(i - 1);
      knots[i].slope = (w1 + w2) / (w1 / before + w2 / after);
    }
    knots.front().slope = end_slope(width(0), steepness(0), width(1), steepness(1));
    knots.back().slope =
        end_slope(width(pieces - 1), steepness(pieces - 1), width(pieces - 2), steepness(pieces - 2));
  }
  return Law(std::move(knots));
}

Law Law::bezier(const std::vector<glm::dvec2>& control) {
  check_points(control, true);
  if (control.size() < 2 || !(control.back().x > control.front().x)) {
    throw InputError("needs at least 2 control points [t, value] with t rising from the first to the last");
  }
  return Law(Bezier{control});
}

bool Law::is_constant() const {
  const auto* knots = std::get_if<std::vector<Knot>>(&shape_);
  return knots != nullptr && knots->size() == 1;
}

Law::Value Law::at(double t) const {
  if (const auto* bezier = std::get_if<Bezier>(&shape_)) {
    const std::vector<glm::dvec2>& control = bezier->control;
    if (t < control.front().x) return {control.front().y, 0};
    if (t > control.back().x) return {control.back().y, 0};
    // t(s) never falls, as its control points do not: halve where Newton's step leaves the bracket.
    const Segment<2> segment = BezierSegment<2>{control};
    double low = 0;
    double high = 1;
    double s = t == control.front().x ? 0 : t == control.back().x ? 1 : 0.5;
    CurvePoint<2> here = evaluate<2>(segment, s);
    while (here.position.x != t) {
      (here.position.x > t ? high : low) = s;
      double next = here.first.x > 0 ? s - (here.position.x - t) / here.first.x : low;
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      if (next == s || next == low || next == high) break;
      s = next;
      here = evaluate<2>(segment, s);
    }
    // At a resting end the second derivative has the direction.
    glm::dvec2 ahead = here.first;
    if (ahead == glm::dvec2(0.0)) ahead = s < 0.5 ? here.second : -here.second;
    if (ahead == glm::dvec2(0.0)) return {here.position.y, 0};
    const double least = std::abs(ahead.y) / kSteepest;
    return {here.position.y, ahead.y / std::max(ahead.x, least)};
  }
  const auto& knots = std::get<std::vector<Knot>>(shape_);
  if (knots.size() == 1 || t < knots.front().t) return {knots.front().value, 0};
  if (t > knots.back().t) return {knots.back().value, 0};
  auto after = std::upper_bound(knots.begin(), knots.end(), t,
                                [](double at, const Knot& knot) { return at < knot.t; });
  if (after == knots.end()) --after;
  const Knot& a = *(after - 1);
  const Knot& b = *after;
  const double h = b.t - a.t;
  const double x = (t - a.t) / h;
  const double y = 1 - x;
  // x^2 (3 - 2x) and its mirror image add up to 1 only up to rounding: the difference is what is blended.
  const double value = (x < 0.5 ? a.value + (b.value - a.value) * (x * x * (3 - 2 * x))
                                : b.value - (b.value - a.value) * (y * y * (3 - 2 * y))) +
                       h * x * y * (a.slope * y - b.slope * x);
  const double rate =
      6 * x * y * (b.value - a.value) / h + a.slope * y * (y - 2 * x) + b.slope * x * (x - 2 * y);
  return {value, rate};
}

}  // namespace sweepkit::sweep
