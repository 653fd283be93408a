// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Every orientation is a rotation-minimizing frame turned about T by an angle:
//   angle = direction (Frenet's, an up vector's, a guide's) + twist + what closes a loop.
// So where a direction has none - on a straight stretch, along `up`, through the guide - the frame goes on
// without a turn from where it had one, and comes back without a jump of the curve's own making.
//
// The rates by arc length, with dT/ds = kN N + kB B:
//   Frenet    the torsion
//   fixed up  p = up - (up.T) T, B = p/|p|:               (up.T) kN / |p|
//   guide     g = G - c, q = g - (g.T) T, N = q/|q|:      (G'.B - (g.T) kB) / |q|

#include "orientation.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "rotation_minimizing_frames.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

constexpr double kPi = std::numbers::pi;

// A direction this near the tangent is mostly rounding.
constexpr double kLeastSine = 1e-9;
// A curve that bends by less than this (radians) over the length of the whole trajectory is straight.
constexpr double kLeastBend = 1e-9;
// A loop in a plane, or any other that mirrors itself, comes home as it left: an angle below this is
// rounding.
constexpr double kLeastLeftover = 1e-10;

// Where a section's x points, and how fast that turns about T against a rotation-minimizing frame.
struct Direction {
  glm::dvec3 x;
  double rate;
};

class Pointer {
 public:
  Pointer(const Curve3& trajectory, const Orientation& orientation)
      : trajectory_(trajectory), orientation_(orientation), up_(glm::normalize(orientation.up)) {}

  bool is_needed() const {
    return orientation_.guide.has_value() || orientation_.frames != Frames::kRotationMinimizing;
  }
  std::optional<Direction> at(const CurveLocation& location, double length, const glm::dvec3& tangent) const {
    const CurvePoint<3> point = trajectory_.evaluate(location);
    if (orientation_.guide) return towards_guide(point, length, tangent);
    return orientation_.frames == Frames::kFrenet ? principal_normal(point, tangent) : level(point, tangent);
  }
  /// Frenet's normal turns right round at an inflection; its line does not.
  bool is_line() const { return !orientation_.guide && orientation_.frames == Frames::kFrenet; }

 private:
  // dT/ds; 0 at a cusp.
  static glm::dvec3 curvature(const CurvePoint<3>& point, const glm::dvec3& tangent) {
    const double speed_squared = glm::dot(point.first, point.first);
    if (!(speed_squared > 0)) return glm::dvec3(0.0);
    const glm::dvec3 k = (point.second - glm::dot(point.second, tangent) * tangent) / speed_squared;
    return std::isfinite(k.x + k.y + k.z) ? k : glm::dvec3(0.0);
  }

  std::optional<Direction> principal_normal(const CurvePoint<3>& point, const glm::dvec3& tangent) const {
    const glm::dvec3 k = curvature(point, tangent);
    if (!(glm::length(k) * trajectory_.length() > kLeastBend)) return std::nullopt;
    const glm::dvec3 binormal = glm::cross(point.first, point.second);
    const double torsion = glm::dot(binormal, point.third) / glm::dot(binormal, binormal);
    return Direction{glm::normalize(k), std::isfinite(torsion) ? torsion : 0};
  }

  std::optional<Direction> level(const CurvePoint<3>& point, const glm::dvec3& tangent) const {
    const double along = glm::dot(up_, tangent);
    const glm::dvec3 p = up_ - along * tangent;
    const double length = glm::length(p);
    if (!(length > kLeastSine)) return std::nullopt;
    const glm::dvec3 normal = glm::cross(p / length, tangent);
    return Direction{normal, along * glm::dot(curvature(point, tangent), normal) / length};
  }

  std::optional<Direction> towards_guide(const CurvePoint<3>& point, double length,
                                         const glm::dvec3& tangent) const {
    const Curve3& guide = *orientation_.guide;
    const double scale = guide.length() / trajectory_.length();
    const CurveLocation there = guide.locate(length * scale);
    const glm::dvec3 g = guide.evaluate(there).position - point.position;
    const double along = glm::dot(g, tangent);
    const glm::dvec3 q = g - along * tangent;
    const double distance = glm::length(q);
    if (!(distance > kLeastSine * glm::length(g))) return std::nullopt;
    const glm::dvec3 binormal = glm::cross(tangent, q / distance);
    const double rate = glm::dot(scale * guide.tangent(there), binormal) -
                        along * glm::dot(curvature(point, tangent), binormal);
    return Direction{q / distance, rate / distance};
  }

  const Curve3& trajectory_;
  const Orientation& orientation_;
  glm::dvec3 up_;
};

void turn(TurningFrame& side, double angle, double rate) {
  side.frame = turned(side.frame, angle);
  side.rate += rate;
}

// Turns rotation-minimizing frames to where `pointer` points.
void point(std::vector<StationFrames>& frames, std::span<const Station> stations, const Pointer& pointer) {
  struct Turn {
    double angle = 0;
    double rate = 0;
  };
  // What comes before the first direction is turned as that one is.
  std::optional<double> angle;
  for (std::size_t i = 0; i < frames.size() && !angle; ++i) {
    const Frame& frame = frames[i].out.frame;
    if (const auto direction = pointer.at(stations[i].out, stations[i].length, frame.tangent))
      angle = angle_to(frame, direction->x);
  }
  if (!angle) return;
  const auto turn_at = [&](const CurveLocation& location, double length, const Frame& frame) {
    const std::optional<Direction> direction = pointer.at(location, length, frame.tangent);
    if (!direction) return Turn{*angle, 0};
    // Of the angles that mean the same the one nearest to the last.
    const double same = pointer.is_line() ? kPi : 2 * kPi;
    const double next = angle_to(frame, direction->x);
    angle = next + same * std::round((*angle - next) / same);
    return Turn{*angle, direction->rate};
  };
  std::vector<Turn> in(frames.size());
  std::vector<Turn> out(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    in[i] = i == 0 ? turn_at(stations[i].out, stations[i].length, frames[i].out.frame)
                   : turn_at(stations[i].in, stations[i].length, frames[i].in.frame);
    out[i] = in[i];
    if (!stations[i].is_corner || i == 0 || i + 1 == frames.size()) continue;
    out[i] = turn_at(stations[i].out, stations[i].length, frames[i].out.frame);
    // Both sides of a corner share a ring: each gives in by half.
    in[i].angle = out[i].angle = 0.5 * (in[i].angle + out[i].angle);
  }
  for (std::size_t i = 0; i < frames.size(); ++i) {
    turn(frames[i].in, in[i].angle, in[i].rate);
    turn(frames[i].out, out[i].angle, out[i].rate);
  }
}

}  // namespace

Oriented orient(const Curve3& trajectory, std::span<const Station> stations, const Orientation& orientation,
                const Law& twist_deg, int symmetry) {
  if (!(glm::length(orientation.up) > 0) || !std::isfinite(glm::length(orientation.up))) {
    throw InputError("up needs to be a direction, got one of no length");
  }
  Oriented oriented{rotation_minimizing_frames(trajectory, stations, orientation.up)};
  std::vector<StationFrames>& frames = oriented.frames;
  const Pointer pointer(trajectory, orientation);
  if (pointer.is_needed()) point(frames, stations, pointer);

  const std::size_t last = frames.size() - 1;
  if (!(twist_deg.is_constant() && twist_deg.at(0).value == 0)) {
    for (std::size_t i = 0; i <= last; ++i) {
      const Law::Value twist = twist_deg.at(stations[i].length / trajectory.length());
      const double radians = kPi / 180;
      // Whole turns are taken off in degrees, where that is exact.
      const double angle = radians * std::remainder(twist.value, 360.0);
      turn(frames[i].in, angle, radians * twist.rate / trajectory.length());
      turn(frames[i].out, angle, radians * twist.rate / trajectory.length());
    }
  }
  if (!trajectory.is_closed()) return oriented;

  const Frame& start = frames.front().out.frame;
  const Frame& end = frames.back().in.frame;
  const double leftover = angle_to(start, turn_normal(end.normal, end.tangent, start.tangent));
  const double step = 2 * kPi / symmetry;
  oriented.closing_steps = static_cast<int>(std::round(leftover / step));
  double rest = leftover - step * oriented.closing_steps;
  if (std::abs(rest) <= kLeastLeftover) rest = 0;
  const double rate = -rest / trajectory.length();
  for (std::size_t i = 0; i <= last; ++i) {
    turn(frames[i].in, rate * stations[i].length, rate);
    turn(frames[i].out, rate * stations[i].length, rate);
  }
  // First and last are one place: the same bits.
  if (stations.front().is_corner) {
    frames.front().in = frames.back().in;
    turn(frames.front().in, -step * oriented.closing_steps, 0);
  } else {
    frames.front().in = frames.front().out;
  }
  frames.back() = frames.front();
  return oriented;
}

}  // namespace sweepkit::sweep
