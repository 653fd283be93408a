// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on SVG 2, B.2 "Elliptical arc implementation notes". Departs from it: everything happens on the unit
// circle that the ellipse is the image of, and angles come from the half chord and its distance from the
// centre, not from the arc cosine, which loses half the digits near 0 and 180 degrees.
//
//   half    half the chord, from the middle to the start, on the unit circle
//   center  of the circle, from the chord's middle; perpendicular to `half`, |half|^2 + |center|^2 = 1
//   u0, u1  the arc's start and end, from the centre
#include "elliptical_arc.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "cos_sin_deg.hpp"

namespace sweepkit::scene {
namespace {

// An arc that turns by less is a cubic Bezier segment: it departs from the arc by a 2e-5 theta^6 share of the
// radius (2.7e-4 for a quarter, falling by the sixth power), here 2e-17, while the sum of a centre and a
// radius rounds by 1e-16 of that radius - far more than the gaps between segments may be when the arc is
// short and its centre far.
constexpr double kFlatTurn = 0.01;

// Rounding leaves a turn up to some 1e-14 degrees from the multiple of a quarter that was meant.
constexpr double kQuarterRounding = 1e-12;

glm::dvec2 turned(const glm::dvec2& v) {
  return {-v.y, v.x};
}

}  // namespace

sweep::Segment<2> elliptical_arc(const glm::dvec2& from, const OutlineBuilder::Arc& arc,
                                 const glm::dvec2& to) {
  const sweep::BezierSegment<2> line{{from, to}};
  const glm::dvec2 radii = glm::abs(arc.radii);
  if (!(radii.x > 0 && radii.y > 0)) return line;
  const glm::dvec2 axis = cos_sin_deg(arc.x_axis_deg);
  const glm::dvec2 chord = 0.5 * (from - to);
  glm::dmat2 ellipse_from_circle(radii.x * axis, radii.y * turned(axis));
  glm::dvec2 half = glm::dvec2(glm::dot(chord, axis), glm::dot(chord, turned(axis))) / radii;

  const double length = std::hypot(half.x, half.y);
  // Radii so large that nothing bends, or so small that they count as 0.
  if (!(length > 0 && length < std::numeric_limits<double>::infinity())) return line;
  const glm::dvec2 along = half / length;
  double center_distance = 0;
  if (length >= 1) {
    half = along;
    ellipse_from_circle *= length;
  } else {
    center_distance = std::sqrt((1 - length) * (1 + length));
  }
  const double side = arc.is_large == arc.is_positive ? -1 : 1;
  const glm::dvec2 center = -side * center_distance * turned(along);
  const glm::dvec2 u0 = glm::normalize(half - center);
  const glm::dvec2 u1 = glm::normalize(-half - center);

  const double shorter = 2 * std::atan2(std::min(length, 1.0), center_distance);
  const double turn = arc.is_large ? 2 * std::numbers::pi - shorter : shorter;
  const double sign = arc.is_positive ? 1 : -1;
  if (turn < kFlatTurn) {
    const double reach = sign * 4.0 / 3 * std::tan(turn / 4);
    return sweep::BezierSegment<2>{{from, from + reach * (ellipse_from_circle * turned(u0)),
                                    to - reach * (ellipse_from_circle * turned(u1)), to}};
  }
  double turn_deg = turn * (180 / std::numbers::pi);
  const double quarters = 90 * std::nearbyint(turn_deg / 90);
  if (std::abs(turn_deg - quarters) < kQuarterRounding) turn_deg = quarters;
  return sweep::ArcSegment<2>{0.5 * (from + to) + ellipse_from_circle * center, ellipse_from_circle * u0,
                              ellipse_from_circle * turned(u0), 0, sign * turn_deg};
}

}  // namespace sweepkit::scene
