// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Where the section stands along a trajectory, and how its axes change. With the profile p, q and the frame
// (N, B, T) that orient() gives, X = p N and Y = q B. With the curvature vector dT/dt = kN N + kB B and the
// frame's own rate of turn w (radians a metre about T)
//   N' = w B - kN T,   B' = -w N - kB T,   X' = p' N + p N',   Y' = q' B + q B'.
// At a corner the ring lies in the plane that halves it (a mitre): every point r of the section slides along
// T by g(r) = -(r.m)/(T.m), m the plane's normal. That is linear in (x, y), so it is folded into the axes: N
// + g(N) T in the place of N, B + g(B) T in that of B. Along a straight piece g runs evenly from the mitre at
// one end to that at the other, so no ring of it crosses the mitre however close it stands.

#include "rows.hpp"

#include <algorithm>
#include <cmath>

#include "number_text.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

// How far along T the section's N and B slide, and how fast that changes.
struct Slide {
  glm::dvec2 length{0.0};
  glm::dvec2 rate{0.0};
};

glm::dvec2 curvature(const CurvePoint<3>& point, const Frame& frame) {
  const double speed_squared = glm::dot(point.first, point.first);
  // At a cusp the curvature is not finite; the section's own normal stands in.
  if (!(speed_squared > 0)) return glm::dvec2(0.0);
  const glm::dvec2 k =
      glm::dvec2(glm::dot(point.second, frame.normal), glm::dot(point.second, frame.binormal)) /
      speed_squared;
  return std::isfinite(k.x) && std::isfinite(k.y) ? k : glm::dvec2(0.0);
}

glm::dvec2 mitre_slide(const Frame& frame, const glm::dvec3& plane) {
  const double along = glm::dot(frame.tangent, plane);
  return glm::dvec2(-glm::dot(frame.normal, plane), -glm::dot(frame.binormal, plane)) / along;
}

bool is_straight(const Segment<3>& segment) {
  const auto* bezier = std::get_if<BezierSegment<3>>(&segment);
  return bezier != nullptr && bezier->control.size() == 2;
}

// The normals of the mitre planes; 0 where there is no corner.
std::vector<glm::dvec3> mitre_planes(const std::vector<Station>& stations,
                                     const std::vector<StationFrames>& frames) {
  std::vector<glm::dvec3> planes(stations.size(), glm::dvec3(0.0));
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (!stations[i].is_corner) continue;
    // join_corners() has left no reversal, so the sum has a direction.
    planes[i] = glm::normalize(frames[i].in.frame.tangent + frames[i].out.frame.tangent);
  }
  return planes;
}

// The slides where the curve arrives at and leaves each station. Only a straight piece is ruled, so only
// there the rings between the mitres move.
struct StationSlides {
  Slide in, out;
};
std::vector<StationSlides> make_slides(const Curve3& trajectory, const std::vector<Station>& stations,
                                       const std::vector<StationFrames>& frames) {
  const std::vector<glm::dvec3> planes = mitre_planes(stations, frames);
  std::vector<StationSlides> slides(stations.size());
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (!stations[i].is_corner) continue;
    slides[i].in.length = mitre_slide(frames[i].in.frame, planes[i]);
    slides[i].out.length = mitre_slide(frames[i].out.frame, planes[i]);
  }
  const auto slide_between = [&](std::size_t first, std::size_t last) {
    if (!stations[first].is_corner && !stations[last].is_corner) return;
    for (std::size_t segment = stations[first].out.segment; segment <= stations[last].in.segment; ++segment) {
      if (!is_straight(trajectory.segments()[segment])) return;
    }
    const double length = stations[last].length - stations[first].length;
    for (std::size_t i = first; i <= last; ++i) {
      const TurningFrame& side = i == first ? frames[i].out : frames[i].in;
      const glm::dvec2 none(0.0);
      const glm::dvec2 at_first = stations[first].is_corner ? mitre_slide(side.frame, planes[first]) : none;
      const glm::dvec2 at_last = stations[last].is_corner ? mitre_slide(side.frame, planes[last]) : none;
      Slide slide;
      slide.length = glm::mix(at_first, at_last, (stations[i].length - stations[first].length) / length);
      // g changes along the piece, and with the directions of N and B as they turn.
      slide.rate = (at_last - at_first) / length + side.rate * glm::dvec2(slide.length.y, -slide.length.x);
      if (i != first) slides[i].in = slide;
      if (i != last) slides[i].out = slide;
    }
  };
  std::size_t piece_start = 0;
  for (std::size_t i = 1; i < stations.size(); ++i) {
    if (!stations[i].is_corner && i + 1 < stations.size()) continue;
    slide_between(piece_start, i);
    piece_start = i;
  }
  return slides;
}

// The profile at a station, and its rate a metre.
struct Size {
  glm::dvec2 value;
  glm::dvec2 rate;
};

Size size_at(const Profile& profile, double length, double whole) {
  const double t = length / whole;
  const Law::Value x = profile.x.at(t);
  const Law::Value y = profile.y.at(t);
  const double least = std::min(x.value, y.value);
  if (!(least >= 0)) {
    throw InputError("profile is " + number_text(least) + " at t = " + number_text(t) +
                     "; a size needs to be 0 or more");
  }
  return {{x.value, y.value}, {x.rate / whole, y.rate / whole}};
}

RowSide make_side(const CurvePoint<3>& point, const TurningFrame& turning, const Slide& slide,
                  const Size& size) {
  const Frame& f = turning.frame;
  const glm::dvec2 k = curvature(point, f);
  const double w = turning.rate;
  RowSide side{f};
  side.x_rate = size.rate.x * (f.normal + slide.length.x * f.tangent) +
                size.value.x * (w * f.binormal + (slide.rate.x - k.x) * f.tangent);
  side.y_rate = size.rate.y * (f.binormal + slide.length.y * f.tangent) +
                size.value.y * (-w * f.normal + (slide.rate.y - k.y) * f.tangent);
  side.is_plain = w == 0 && size.rate == glm::dvec2(0.0) && size.value.x == size.value.y;
  return side;
}

// The section's shape at a station: 1 for its longer axis. Where both have shrunk to nothing the rates tell.
glm::dvec2 shape_of(const Size& size) {
  glm::dvec2 shape = size.value;
  if (shape == glm::dvec2(0.0)) shape = glm::abs(size.rate);
  const double longer = std::max(shape.x, shape.y);
  return longer > 0 ? shape / longer : glm::dvec2(1.0);
}

}  // namespace

std::vector<Row> make_rows(const Curve3& trajectory, const std::vector<Station>& stations,
                           const std::vector<StationFrames>& frames, const Profile& profile) {
  const std::vector<StationSlides> slides = make_slides(trajectory, stations, frames);
  std::vector<Row> rows(stations.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row& row = rows[i];
    const Size size = size_at(profile, stations[i].length, trajectory.length());
    const CurvePoint<3> point = trajectory.evaluate(stations[i].out);
    row.center = point.position;
    row.is_corner = stations[i].is_corner;
    row.is_pole = size.value == glm::dvec2(0.0);
    row.is_pressed = (size.value.x == 0) != (size.value.y == 0);
    // Only at a corner the two sides differ; an open end has one.
    const Slide& slide = i == 0 && !row.is_corner ? slides[i].out : slides[i].in;
    row.out = make_side(point, frames[i].out, row.is_corner ? slides[i].out : slide, size);
    row.in =
        row.is_corner ? make_side(trajectory.evaluate(stations[i].in), frames[i].in, slide, size) : row.out;
    const Frame& f = row.in.frame;
    const glm::dvec2 shape = shape_of(size);
    row.x_direction = f.normal + slide.length.x * f.tangent;
    row.y_direction = f.binormal + slide.length.y * f.tangent;
    row.x_axis = size.value.x * row.x_direction;
    row.y_axis = size.value.y * row.y_direction;
    row.x_direction *= shape.x;
    row.y_direction *= shape.y;
  }
  if (trajectory.is_closed()) {
    const Size first = size_at(profile, 0, trajectory.length());
    const Size last = size_at(profile, trajectory.length(), trajectory.length());
    // A millionth is what float32 would not show.
    if (glm::length(first.value - last.value) > 1e-6 * glm::length(first.value)) {
      throw InputError("profile begins with " + number_text(first.value.x) + " and ends with " +
                       number_text(last.value.x) + ", but the trajectory is closed; let it end as it began");
    }
    rows.back() = rows.front();  // one place, the same bits
  }
  return rows;
}

}  // namespace sweepkit::sweep
