// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A joint is made in the trajectory, before anything is swept: so the section is kept on both legs and (u,v)
// go on by arc length. With d the turn of the corner and r the section's reach, a leg gives up
//   round  (2 r) tan(d/2): an arc of radius 2 r touches both legs, the section's inner side bends with r;
//   bevel  the chord between points e from the corner is 2 e cos(d/2) long, and mitres of d/2 at its ends
//   take
//          2 r tan(d/4) of that on the inner side. A tenth of r is left there:
//          e = r (tan(d/4) + 0.05) / cos(d/2).

#include "joints.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "number_text.hpp"
#include "rotation_minimizing_frames.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

constexpr double kRoundReaches = 2;
constexpr double kBevelRest = 0.05;
// A round joint's cells turn by no more than this.
constexpr double kTurnPerCell = std::numbers::pi / 12;
// Of a leg between two corners each may take a little less than half, or nothing of it would be left.
constexpr double kShareOfLeg = 0.49;

// The stretch of a Bezier segment from t = from to t = to, by de Casteljau's subdivision at both.
BezierSegment<3> cut(const BezierSegment<3>& segment, double from, double to) {
  std::vector<glm::dvec3> control = segment.control;
  const std::size_t degree = control.size() - 1;
  if (to < 1) {
    // The left part: control[i] after i rounds.
    for (std::size_t round = 1; round <= degree; ++round) {
      for (std::size_t i = degree; i >= round; --i) control[i] = (1 - to) * control[i - 1] + to * control[i];
    }
  }
  const double t = to > 0 ? from / to : 0;
  if (t > 0) {
    for (std::size_t round = 1; round <= degree; ++round) {
      for (std::size_t i = 0; i + round <= degree; ++i)
        control[i] = (1 - t) * control[i] + t * control[i + 1];
    }
  }
  return {std::move(control)};
}

ArcSegment<3> cut(const ArcSegment<3>& segment, double from, double to) {
  ArcSegment<3> part = segment;
  const double turn = segment.to_deg - segment.from_deg;
  part.center = segment.center + from * segment.rise;
  part.rise = (to - from) * segment.rise;
  part.from_deg = from == 0 ? segment.from_deg : segment.from_deg + from * turn;
  part.to_deg = to == 1 ? segment.to_deg : segment.from_deg + to * turn;
  return part;
}

// A torus knot has no corners, so nothing of it is ever cut.
TorusKnotSegment cut(const TorusKnotSegment& segment, double, double) {
  return segment;
}

bool is_straight(const Segment<3>& segment) {
  const auto* bezier = std::get_if<BezierSegment<3>>(&segment);
  return bezier != nullptr && bezier->control.size() == 2;
}

struct Corner {
  double length;        // from the trajectory's start
  double turn;          // radians
  bool is_cut = false;  // or mitred
  double setback = 0;   // what it takes of each leg
};

double turn_at(const Curve3& trajectory, CurveLocation in, CurveLocation out) {
  const glm::dvec3 before = trajectory.tangent(in);
  const glm::dvec3 after = trajectory.tangent(out);
  return std::atan2(glm::length(glm::cross(before, after)), glm::dot(before, after));
}

// The corner at the start of a segment, and how it is to be made.
Corner make_corner(const Curve3& trajectory, std::size_t segment, Joints joints, double miter_limit,
                   const std::function<double(double)>& reach) {
  const std::size_t count = trajectory.segments().size();
  const std::size_t before = segment == 0 ? count - 1 : segment - 1;
  Corner corner{segment == 0 ? 0 : trajectory.end_lengths()[before],
                turn_at(trajectory, {before, 1}, {segment, 0})};
  const double half = std::cos(corner.turn / 2);
  corner.is_cut = joints == Joints::kRound || joints == Joints::kBevel || half * miter_limit < 1;
  if (!corner.is_cut) return corner;
  // Past this a joint would need legs a thousand times as long as the section reaches.
  if (half < 1e-3) {
    throw InputError("trajectory turns back on itself at " + number_text(corner.length) +
                     " m along it; no joint bends that sharply: lead it round");
  }
  const double r = reach(corner.length);
  corner.setback = joints == Joints::kRound ? kRoundReaches * r * std::tan(corner.turn / 2)
                                            : r * (std::tan(corner.turn / 4) + kBevelRest) / half;
  return corner;
}

// From `start`, where the trajectory goes along `before`, to `end`, where it goes along `after`.
Segment<3> round_segment(const TangentPoint& start, const TangentPoint& end, double turn,
                         bool has_straight_legs) {
  const glm::dvec3 chord = end.position - start.position;
  const double radius = glm::length(chord) / (2 * std::sin(turn / 2));
  if (has_straight_legs) {
    // Inwards is where the tangent turns to.
    const glm::dvec3 inwards =
        glm::normalize(end.tangent - glm::dot(end.tangent, start.tangent) * start.tangent);
    return ArcSegment<3>{start.position + radius * inwards, -radius * inwards, radius * start.tangent, 0,
                         turn * (180 / std::numbers::pi)};
  }
  // The cubic that is nearest to an arc.
  const double handle = 4.0 / 3 * std::tan(turn / 4) * radius;
  return BezierSegment<3>{{start.position, start.position + handle * start.tangent,
                           end.position - handle * end.tangent, end.position}};
}

}  // namespace

JoinedTrajectory join_corners(const Curve3& trajectory, Joints joints, double miter_limit,
                              const std::function<double(double length)>& reach) {
  const std::span<const Segment<3>> segments = trajectory.segments();
  const std::size_t count = segments.size();
  std::vector<std::optional<Corner>> corners(count);  // at each segment's start
  bool has_cuts = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (!trajectory.is_corner(i)) continue;
    corners[i] = make_corner(trajectory, i, joints, miter_limit, reach);
    has_cuts = has_cuts || corners[i]->is_cut;
  }
  if (!has_cuts) return {trajectory, std::vector<int>(count, 1)};

  // No corner takes more of a leg than its share.
  std::vector<std::size_t> starts;  // segments that begin a leg
  for (std::size_t i = 0; i < count; ++i) {
    if (i == 0 || corners[i]) starts.push_back(i);
  }
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const std::size_t next = k + 1 < starts.size() ? starts[k + 1] : count;
    const double from = starts[k] == 0 ? 0 : trajectory.end_lengths()[starts[k] - 1];
    const double leg = trajectory.end_lengths()[next - 1] - from;
    std::optional<Corner>& first = corners[starts[k]];
    std::optional<Corner>& last = corners[next % count];
    const double share = first && last ? kShareOfLeg : 2 * kShareOfLeg;
    if (first) first->setback = std::min(first->setback, share * leg);
    if (last) last->setback = std::min(last->setback, share * leg);
  }

  std::vector<Segment<3>> made;
  std::vector<int> least_cells;
  const auto add = [&](Segment<3> segment, int cells) {
    made.push_back(std::move(segment));
    least_cells.push_back(cells);
  };
  const auto point_at = [&](CurveLocation at) {
    return TangentPoint{trajectory.evaluate(at).position, trajectory.tangent(at)};
  };
  const auto add_joint = [&](const Corner& corner, CurveLocation from, CurveLocation to) {
    const TangentPoint start = point_at(from);
    const TangentPoint end = point_at(to);
    if (joints != Joints::kRound) {
      add(BezierSegment<3>{{start.position, end.position}}, 1);
      return;
    }
    const double turn = turn_at(trajectory, from, to);
    const bool has_straight_legs = is_straight(segments[from.segment]) && is_straight(segments[to.segment]);
    add(round_segment(start, end, turn, has_straight_legs),
        static_cast<int>(std::ceil(corner.turn / kTurnPerCell)));
  };
  CurveLocation home{0, 0};  // where a closed trajectory's first corner has been left
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const std::size_t next = k + 1 < starts.size() ? starts[k + 1] : count;
    const double from_length = starts[k] == 0 ? 0 : trajectory.end_lengths()[starts[k] - 1];
    const double to_length = trajectory.end_lengths()[next - 1];
    const std::optional<Corner>& first = corners[starts[k]];
    const std::optional<Corner>& last = corners[next % count];
    const CurveLocation from = first && first->is_cut ? trajectory.locate(from_length + first->setback)
                                                      : CurveLocation{starts[k], 0};
    const CurveLocation to =
        last && last->is_cut ? trajectory.locate(to_length - last->setback) : CurveLocation{next - 1, 1};
    if (k == 0) home = from;
    for (std::size_t i = from.segment; i <= to.segment; ++i) {
      const double t0 = i == from.segment ? from.t : 0;
      const double t1 = i == to.segment ? to.t : 1;
      if (t0 >= t1) continue;
      add(std::visit([&](const auto& kind) { return Segment<3>(cut(kind, t0, t1)); }, segments[i]), 1);
    }
    if (!last || !last->is_cut) continue;
    const double after_length = next == count ? 0 : to_length;
    add_joint(*last, to, next == count ? home : trajectory.locate(after_length + last->setback));
  }
  return {Curve3(std::move(made)), std::move(least_cells)};
}

}  // namespace sweepkit::sweep
