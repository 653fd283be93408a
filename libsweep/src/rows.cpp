// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Where the section stands along a trajectory with corners. Away from them X = N and Y = B, and with the
// curvature vector dT/dt = kN N + kB B and the closing rate w (radians a metre about T)
//   X' = w B - kN T,   Y' = -w N - kB T.
// At a corner the ring lies in the plane that halves it (a mitre): every point q of the section slides along
// T by g(q) = -(q.m)/(T.m), m the plane's normal. That is linear in (x, y), so it is folded into the row's
// own axes: X = N + g(N) T, Y = B + g(B) T. Along a straight piece g runs evenly from the mitre at one end to
// that at the other, so no ring of it crosses the mitre however close it stands.

#include "rows.hpp"

#include <cmath>

#include "number_text.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

// A mitre longer than this many times the section's size is a reversal, not a corner.
constexpr double kLongestMitre = 1000;

glm::dvec2 curvature(const CurvePoint<3>& point, const Frame& frame) {
  const double speed_squared = glm::dot(point.first, point.first);
  // At a cusp the curvature is not finite; the section's own normal stands in.
  if (!(speed_squared > 0)) return glm::dvec2(0.0);
  const glm::dvec2 k =
      glm::dvec2(glm::dot(point.second, frame.normal), glm::dot(point.second, frame.binormal)) /
      speed_squared;
  return std::isfinite(k.x) && std::isfinite(k.y) ? k : glm::dvec2(0.0);
}

RowSide make_side(const Curve3& trajectory, CurveLocation location, const Frame& frame, double closing_rate) {
  const glm::dvec2 k = curvature(trajectory.evaluate(location), frame);
  return {frame, closing_rate * frame.binormal - k.x * frame.tangent,
          -closing_rate * frame.normal - k.y * frame.tangent};
}

// How far along T the section's axes slide onto a mitre plane: g for N and for B.
glm::dvec2 mitre_slide(const Frame& frame, const glm::dvec3& plane) {
  const double along = glm::dot(frame.tangent, plane);
  return glm::dvec2(-glm::dot(frame.normal, plane), -glm::dot(frame.binormal, plane)) / along;
}

bool is_straight(const Segment<3>& segment) {
  const auto* bezier = std::get_if<BezierSegment<3>>(&segment);
  return bezier != nullptr && bezier->control.size() == 2;
}

// Slides the sections between stations `first` and `last`, the ends of a smooth piece, evenly from the mitre
// at its start to that at its end. Only a straight piece is ruled, so only there the rings between the mitres
// move.
void slide_between(std::vector<Row>& rows, const std::vector<glm::dvec3>& planes, const Curve3& trajectory,
                   const std::vector<Station>& stations, double closing_rate, std::size_t first,
                   std::size_t last) {
  for (std::size_t segment = stations[first].out.segment; segment <= stations[last].in.segment; ++segment) {
    if (!is_straight(trajectory.segments()[segment])) return;
  }
  const double length = stations[last].length - stations[first].length;
  for (std::size_t i = first; i <= last; ++i) {
    Row& row = rows[i];
    RowSide& side = i == first ? row.out : row.in;
    const Frame& frame = side.frame;
    const glm::dvec2 none(0.0);
    const glm::dvec2 at_first = rows[first].is_corner ? mitre_slide(frame, planes[first]) : none;
    const glm::dvec2 at_last = rows[last].is_corner ? mitre_slide(frame, planes[last]) : none;
    const glm::dvec2 slide =
        glm::mix(at_first, at_last, (stations[i].length - stations[first].length) / length);
    if (i != first && i != last) {
      row.x_axis += slide.x * frame.tangent;
      row.y_axis += slide.y * frame.tangent;
    }
    // g changes along the piece, and with the directions of N and B as they turn by the closing rate.
    const glm::dvec2 rate = (at_last - at_first) / length + closing_rate * glm::dvec2(slide.y, -slide.x);
    side.x_rate += rate.x * frame.tangent;
    side.y_rate += rate.y * frame.tangent;
    if (i != first && i != last) row.out = row.in;
  }
}

}  // namespace

std::vector<Row> make_rows(const Curve3& trajectory, const std::vector<Station>& stations,
                           const FramesAlong& along) {
  const std::size_t count = stations.size();
  std::vector<Row> rows(count);
  std::vector<glm::dvec3> planes(count, glm::dvec3(0.0));
  for (std::size_t i = 0; i < count; ++i) {
    Row& row = rows[i];
    row.center = trajectory.evaluate(stations[i].out).position;
    row.in = make_side(trajectory, stations[i].in, along.frames[i].in, along.closing_rate);
    row.out = make_side(trajectory, stations[i].out, along.frames[i].out, along.closing_rate);
    row.is_corner = stations[i].is_corner;
    if (!row.is_corner) {
      row.in = row.out;
      continue;
    }
    const glm::dvec3 bisector = row.in.frame.tangent + row.out.frame.tangent;
    if (!(glm::length(bisector) * kLongestMitre > 2)) {
      throw InputError("trajectory turns back on itself at " + number_text(stations[i].length) +
                       " m along it; a mitre there would be endless: round the corner off");
    }
    planes[i] = glm::normalize(bisector);
  }

  for (std::size_t i = 0; i < count; ++i) {
    Row& row = rows[i];
    const Frame& frame = row.in.frame;
    const glm::dvec2 slide = row.is_corner ? mitre_slide(frame, planes[i]) : glm::dvec2(0.0);
    row.x_axis = frame.normal + slide.x * frame.tangent;
    row.y_axis = frame.binormal + slide.y * frame.tangent;
  }
  std::size_t piece_start = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (!rows[i].is_corner && i + 1 < count) continue;
    slide_between(rows, planes, trajectory, stations, along.closing_rate, piece_start, i);
    piece_start = i;
  }
  if (trajectory.is_closed()) {
    // One place, the same bits.
    Row& first = rows.front();
    if (first.is_corner) {
      first.in = rows.back().in;
    } else {
      first.out = first.in;
    }
    rows.back() = first;
  }
  return rows;
}

}  // namespace sweepkit::sweep
