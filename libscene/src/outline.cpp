// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "outline.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "elliptical_arc.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

// A step below this share of the outline's size is left over from rounding ("z" after relative steps that
// came back to the start but for the last digits): its direction is noise, and would be a corner. Curves
// count such ends as meeting.
constexpr double kNoStep = 1e-9;

// Squares of coordinates up to here stay finite, before a transform makes them metres.
constexpr double kFarthestDrawn = 1e100;

glm::dvec2 end_of(const sweep::Segment<2>& segment, double t) {
  return sweep::evaluate<2>(segment, t).position;
}

// The farthest that the ends and the middles of segments are from the start.
double size_of(const std::vector<sweep::Segment<2>>& segments) {
  const glm::dvec2 start = end_of(segments.front(), 0);
  double size = 0;
  for (const sweep::Segment<2>& segment : segments) {
    size = std::max(
        {size, glm::distance(end_of(segment, 0.5), start), glm::distance(end_of(segment, 1), start)});
  }
  return size;
}

}  // namespace

void close(Outline& outline) {
  if (outline.is_closed) return;
  const glm::dvec2 start = end_of(outline.segments.front(), 0);
  const glm::dvec2 end = end_of(outline.segments.back(), 1);
  if (glm::distance(start, end) > kNoStep * size_of(outline.segments)) {
    outline.segments.emplace_back(sweep::BezierSegment<2>{{end, start}});
  }
  outline.is_closed = true;
}

void transform(Outline& outline, const glm::dmat3& map) {
  const auto point = [&](const glm::dvec2& p) { return glm::dvec2(map * glm::dvec3(p, 1)); };
  const auto vector = [&](const glm::dvec2& v) { return glm::dvec2(map * glm::dvec3(v, 0)); };
  for (sweep::Segment<2>& segment : outline.segments) {
    if (auto* bezier = std::get_if<sweep::BezierSegment<2>>(&segment)) {
      for (glm::dvec2& control : bezier->control) control = point(control);
    } else {
      auto& arc = std::get<sweep::ArcSegment<2>>(segment);
      arc.center = point(arc.center);
      arc.x_axis = vector(arc.x_axis);
      arc.y_axis = vector(arc.y_axis);
    }
  }
}

Outline reversed(const sweep::Curve2& curve) {
  Outline turned{.segments = {curve.segments().rbegin(), curve.segments().rend()},
                 .is_closed = curve.is_closed()};
  for (sweep::Segment<2>& segment : turned.segments) {
    if (auto* bezier = std::get_if<sweep::BezierSegment<2>>(&segment)) {
      std::reverse(bezier->control.begin(), bezier->control.end());
    } else {
      auto& arc = std::get<sweep::ArcSegment<2>>(segment);
      arc.center += arc.rise;
      arc.rise = -arc.rise;
      std::swap(arc.from_deg, arc.to_deg);
    }
  }
  return turned;
}

void OutlineBuilder::check(std::initializer_list<glm::dvec2> points) {
  for (const glm::dvec2& p : points) {
    if (!(std::abs(p.x) <= kFarthestDrawn && std::abs(p.y) <= kFarthestDrawn)) {
      throw InputError("has a coordinate beyond 1e100; draw smaller");
    }
  }
}

void OutlineBuilder::add(sweep::Segment<2> segment, const glm::dvec2& to) {
  if (++segments_ > kMostSegments) {
    throw InputError("has more than " + std::to_string(kMostSegments) + " segments; simplify it");
  }
  if (open_.segments.empty()) start_ = at_;
  open_.segments.push_back(std::move(segment));
  at_ = to;
}

void OutlineBuilder::finish() {
  Outline outline = std::move(open_);
  open_ = {};
  if (outline.segments.empty()) return;
  const double size = size_of(outline.segments);
  if (!(size > 0)) return;  // a point
  // Each step is measured from the last end that was kept, so that many small ones still add up.
  std::vector<sweep::Segment<2>> kept;
  kept.reserve(outline.segments.size());
  glm::dvec2 at = end_of(outline.segments.front(), 0);
  for (sweep::Segment<2>& segment : outline.segments) {
    const double reach =
        std::max(glm::distance(end_of(segment, 0.5), at), glm::distance(end_of(segment, 1), at));
    if (reach <= kNoStep * size) continue;
    at = end_of(segment, 1);
    kept.push_back(std::move(segment));
  }
  outline.segments = std::move(kept);
  if (outline.is_closed || glm::distance(at, end_of(outline.segments.front(), 0)) <= kNoStep * size) {
    outline.is_closed = false;
    close(outline);
  }
  outlines_.push_back(std::move(outline));
}

void OutlineBuilder::move_to(const glm::dvec2& to) {
  check({to});
  finish();
  start_ = at_ = to;
}

void OutlineBuilder::line_to(const glm::dvec2& to) {
  check({to});
  if (to != at_) add(sweep::BezierSegment<2>{{at_, to}}, to);
}

void OutlineBuilder::quadratic_to(const glm::dvec2& control, const glm::dvec2& to) {
  check({control, to});
  if (to != at_ || control != at_) add(sweep::BezierSegment<2>{{at_, control, to}}, to);
}

void OutlineBuilder::cubic_to(const glm::dvec2& first, const glm::dvec2& second, const glm::dvec2& to) {
  check({first, second, to});
  if (to != at_ || first != at_ || second != at_) {
    add(sweep::BezierSegment<2>{{at_, first, second, to}}, to);
  }
}

void OutlineBuilder::arc_to(const Arc& arc, const glm::dvec2& to) {
  check({arc.radii, to});
  if (to != at_) add(elliptical_arc(at_, arc, to), to);
}

void OutlineBuilder::close_subpath() {
  open_.is_closed = !open_.segments.empty();
  const glm::dvec2 start = start_;
  finish();
  at_ = start;
}

void OutlineBuilder::ellipse(const glm::dvec2& center, const glm::dvec2& radii) {
  check({center, radii});
  move_to(center + glm::dvec2(radii.x, 0));
  add(sweep::ArcSegment<2>{center, {radii.x, 0}, {0, radii.y}, 0, 360}, at_);
  close_subpath();
}

std::vector<Outline> OutlineBuilder::take() {
  finish();
  return std::move(outlines_);
}

}  // namespace sweepkit::scene
