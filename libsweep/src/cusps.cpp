// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The derivative of a Bezier segment is one of a degree less and lies in the box about its control points.
// Parts whose box leaves out the origin do not rest; the others are halved [the subdivision that Sederberg
// and Nishita (1990) clip curves by], and Newton's method on the squared speed ends it.

#include "cusps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sweepkit::sweep {
namespace {

using Control = std::vector<glm::dvec2>;

// A speed below this share of the largest is rest: the way on which the direction turns is its square, and so
// below the rounding of the coordinates.
constexpr double kRest = 1e-9;
// Parts this short (2^-30) hold one rest.
constexpr int kHalvings = 30;
// A segment that rests in more parts than this is slow over a whole stretch - many control points in one
// place - and not at a cusp.
constexpr std::size_t kMostParts = 64;
// Nearer to an end than this it is the end that rests, which tangent() knows of.
constexpr double kEnd = 1e-6;

// de Casteljau's corner cutting: the control points up to t, and those from t on.
std::pair<Control, Control> cut(Control control, double t) {
  const std::size_t count = control.size();
  Control left;
  Control right(count);
  left.reserve(count);
  for (std::size_t used = count; used > 0; --used) {
    left.push_back(control[0]);
    right[used - 1] = control[used - 1];
    for (std::size_t i = 0; i + 1 < used; ++i) control[i] = (1 - t) * control[i] + t * control[i + 1];
  }
  return {std::move(left), std::move(right)};
}

struct Part {
  double from;
  double to;
  Control derivative;
};

bool may_rest(const Control& derivative, double slack) {
  glm::dvec2 low = derivative.front();
  glm::dvec2 high = low;
  for (const glm::dvec2& d : derivative) {
    low = glm::min(low, d);
    high = glm::max(high, d);
  }
  return low.x <= slack && low.y <= slack && high.x >= -slack && high.y >= -slack;
}

// Where the speed is least, from a place near to it.
double slowest_near(const Segment<2>& segment, double t) {
  for (int step = 0; step < 8; ++step) {
    const CurvePoint<2> here = evaluate<2>(segment, t);
    const double slope = glm::dot(here.first, here.second);
    const double bend = glm::dot(here.second, here.second) + glm::dot(here.first, here.third);
    if (!(bend > 0)) break;
    t = std::clamp(t - slope / bend, 0.0, 1.0);
  }
  return t;
}

std::vector<double> rests_of(const BezierSegment<2>& bezier) {
  const std::size_t degree = bezier.control.size() - 1;
  if (degree < 2) return {};
  Control derivative(degree);
  double fastest = 0;
  for (std::size_t i = 0; i < degree; ++i) {
    derivative[i] = static_cast<double>(degree) * (bezier.control[i + 1] - bezier.control[i]);
    fastest = std::max(fastest, glm::length(derivative[i]));
  }
  const double slack = kRest * fastest;
  if (!may_rest(derivative, slack)) return {};
  std::vector<Part> parts = {{0, 1, std::move(derivative)}};
  for (int halving = 0; halving < kHalvings && !parts.empty() && parts.size() <= kMostParts; ++halving) {
    std::vector<Part> halves;
    for (Part& part : parts) {
      const double middle = 0.5 * (part.from + part.to);
      auto [left, right] = cut(std::move(part.derivative), 0.5);
      if (may_rest(left, slack)) halves.push_back({part.from, middle, std::move(left)});
      if (may_rest(right, slack)) halves.push_back({middle, part.to, std::move(right)});
    }
    parts = std::move(halves);
  }
  if (parts.size() > kMostParts) return {};
  std::vector<double> rests;
  const Segment<2> segment = bezier;
  for (const Part& part : parts) {
    const double t = slowest_near(segment, 0.5 * (part.from + part.to));
    // Neighbouring parts end in the same place.
    if (t < (rests.empty() ? 0 : rests.back()) + kEnd || t > 1 - kEnd) continue;
    if (glm::length(evaluate<2>(segment, t).first) <= slack) rests.push_back(t);
  }
  return rests;
}

}  // namespace

std::vector<Segment<2>> split_at_cusps(std::vector<Segment<2>> segments) {
  std::vector<Segment<2>> split;
  split.reserve(segments.size());
  for (Segment<2>& segment : segments) {
    auto* bezier = std::get_if<BezierSegment<2>>(&segment);
    const std::vector<double> rests = bezier == nullptr ? std::vector<double>() : rests_of(*bezier);
    double before = 0;
    for (const double t : rests) {
      auto [left, right] = cut(std::move(bezier->control), (t - before) / (1 - before));
      // Rest to the bit: what is left of the speed is rounding, and tells no direction.
      left[left.size() - 2] = left.back();
      right[1] = right.front();
      split.emplace_back(BezierSegment<2>{std::move(left)});
      bezier->control = std::move(right);
      before = t;
    }
    split.push_back(std::move(segment));
  }
  return split;
}

}  // namespace sweepkit::sweep
