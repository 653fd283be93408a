// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on Wang, Juttler, Zheng, Liu, "Computation of rotation minimizing frames", ACM TOG 27 (2008): the
// double reflection method, of fourth order. Departs from it in the step: between two stations the step is
// halved until the carried normal moves by less than kStepAgreement, so that the frames do not depend on how
// coarse the mesh is.
//
// Symbols: x position, t unit tangent, r normal (the paper's reference vector).

#include "rotation_minimizing_frames.hpp"

#include <cmath>

#include "segment.hpp"
#include "sweepkit/strict_math.hpp"

namespace sweepkit::sweep {
namespace {

// Of fourth order, the finer of two results is 15 times nearer the truth than they are to each other:
// thousands of segments stay below the 6e-8 of the float32 that normals are stored in.
constexpr double kStepAgreement = 1e-10;
constexpr int kMaxSubsteps = 1 << 12;

glm::dvec3 perpendicular_part(const glm::dvec3& vector, const glm::dvec3& tangent) {
  return vector - glm::dot(vector, tangent) * tangent;
}

glm::dvec3 any_perpendicular(const glm::dvec3& tangent) {
  const glm::dvec3 axis = std::abs(tangent.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(tangent, axis));
}

Frame make_frame(const glm::dvec3& normal, const glm::dvec3& tangent) {
  glm::dvec3 n = perpendicular_part(normal, tangent);
  const double length = glm::length(n);
  n = length > 1e-8 ? n / length : any_perpendicular(tangent);
  return {n, glm::cross(tangent, n), tangent};
}

TangentPoint tangent_point(const Segment<3>& segment, double t) {
  const CurvePoint<3> here = evaluate<3>(segment, t);
  return {here.position, tangent_of<3>(segment, t, here)};
}

// A normal that goes along a trajectory, and where it is.
struct Carried {
  glm::dvec3 normal;
  TangentPoint at;
};

// Along one segment from parameter `from`, where `carried` is, to `to`. The steps are even in the parameter,
// which the method does not mind and which costs no arc length.
void carry_along_segment(const Segment<3>& segment, double from, double to, Carried& carried) {
  const TangentPoint last = tangent_point(segment, to);
  glm::dvec3 previous = double_reflection(carried.normal, carried.at, last);
  for (int steps = 2; steps <= kMaxSubsteps; steps *= 2) {
    glm::dvec3 normal = carried.normal;
    TangentPoint here = carried.at;
    for (int i = 1; i <= steps; ++i) {
      const TangentPoint next = i == steps ? last : tangent_point(segment, from + (to - from) * i / steps);
      normal = double_reflection(normal, here, next);
      here = next;
    }
    const bool agrees = glm::length(normal - previous) <= kStepAgreement;
    previous = normal;
    if (agrees) break;
  }
  carried = {previous, last};
}

// From where the curve leaves one station to where it arrives at the next. Both stand in one smooth piece,
// but the curvature may jump between its segments: no step goes across such a joint, or the order would be
// lost. `carried` is at the first station.
void carry(const Curve3& trajectory, const Station& from, const Station& to, Carried& carried) {
  for (std::size_t index = from.out.segment; index <= to.in.segment; ++index) {
    const Segment<3>& segment = trajectory.segments()[index];
    const double start = index == from.out.segment ? from.out.t : 0;
    const double end = index == to.in.segment ? to.in.t : 1;
    if (index != from.out.segment) carried.at = tangent_point(segment, start);
    if (start < end) carry_along_segment(segment, start, end, carried);
  }
}

}  // namespace

glm::dvec3 double_reflection(const glm::dvec3& normal, const TangentPoint& from, const TangentPoint& to) {
  // First reflection: in the plane that halves the chord.
  const glm::dvec3 chord = to.position - from.position;
  const double chord_squared = glm::dot(chord, chord);
  glm::dvec3 r = normal;
  glm::dvec3 t = from.tangent;
  if (chord_squared > 0) {
    r -= (2 / chord_squared) * glm::dot(chord, r) * chord;
    t -= (2 / chord_squared) * glm::dot(chord, t) * chord;
  }
  // Second: in the plane that brings the reflected tangent onto the new one.
  const glm::dvec3 change = to.tangent - t;
  const double change_squared = glm::dot(change, change);
  if (change_squared > 0) r -= (2 / change_squared) * glm::dot(change, r) * change;
  return r;
}

glm::dvec3 turn_normal(const glm::dvec3& normal, const glm::dvec3& from_tangent,
                       const glm::dvec3& to_tangent) {
  // Two reflections: in the plane perpendicular to the half-way direction, then in the one perpendicular to
  // the new tangent.
  const glm::dvec3 half = from_tangent + to_tangent;
  const double half_squared = glm::dot(half, half);
  if (!(half_squared > 0)) return normal;
  const glm::dvec3 reflected = normal - (2 / half_squared) * glm::dot(half, normal) * half;
  return reflected - 2 * glm::dot(to_tangent, reflected) * to_tangent;
}

Frame first_frame(const glm::dvec3& tangent, const glm::dvec3& up) {
  glm::dvec3 binormal(0.0);
  // Within a millionth of a right angle the projection is mostly rounding.
  for (const glm::dvec3& direction : {glm::normalize(up), glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0)}) {
    binormal = perpendicular_part(direction, tangent);
    if (glm::length(binormal) >= 1e-6) break;
  }
  // What is short has lost digits against the tangent; a second projection gives them back [Giraud05].
  const bool is_short = glm::length(binormal) < 0.5;
  binormal = glm::normalize(binormal);
  if (is_short) binormal = glm::normalize(perpendicular_part(binormal, tangent));
  return {glm::cross(binormal, tangent), binormal, tangent};
}

std::vector<StationFrames> rotation_minimizing_frames(const Curve3& trajectory,
                                                      std::span<const Station> stations,
                                                      const glm::dvec3& up) {
  const std::size_t count = stations.size();
  std::vector<StationFrames> frames(count);
  const auto point = [&](const CurveLocation& at) {
    return tangent_point(trajectory.segments()[at.segment], at.t);
  };
  Carried carried{glm::dvec3(0.0), point(stations[0].out)};
  frames[0].out.frame = first_frame(carried.at.tangent, up);
  frames[0].in = frames[0].out;
  for (std::size_t i = 1; i < count; ++i) {
    carried.normal = frames[i - 1].out.frame.normal;
    carry(trajectory, stations[i - 1], stations[i], carried);
    const Station& here = stations[i];
    const Frame in = make_frame(carried.normal, carried.at.tangent);
    frames[i] = {{in}, {in}};
    if (here.out.segment != here.in.segment || here.out.t != here.in.t) carried.at = point(here.out);
    if (here.is_corner && i + 1 < count) {
      const glm::dvec3& tangent = carried.at.tangent;
      frames[i].out.frame = make_frame(turn_normal(in.normal, in.tangent, tangent), tangent);
    }
  }
  return frames;
}

}  // namespace sweepkit::sweep
