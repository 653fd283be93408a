// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "stations.hpp"
#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::sweep {

/// An orthonormal right-handed frame (N, B, T): N x B = T.
struct Frame {
  glm::dvec3 normal;
  glm::dvec3 binormal;
  glm::dvec3 tangent;
};

/// A point of a trajectory and its unit tangent.
struct TangentPoint {
  glm::dvec3 position;
  glm::dvec3 tangent;
};

/// One step of double reflection: the normal at `from` carried to `to`. A step of no length keeps what it can
/// of it.
glm::dvec3 double_reflection(const glm::dvec3& normal, const TangentPoint& from, const TangentPoint& to);

/// The normal carried along the smallest rotation that turns one tangent into another (a trajectory's
/// corner).
glm::dvec3 turn_normal(const glm::dvec3& normal, const glm::dvec3& from_tangent,
                       const glm::dvec3& to_tangent);

/// The frame at a trajectory's start: B is +Y made perpendicular to T, or -Z where T is along +-Y.
Frame first_frame(const glm::dvec3& tangent);

/// The frames in which the curve arrives at and leaves each station.
struct StationFrames {
  Frame in;
  Frame out;
};

struct FramesAlong {
  std::vector<StationFrames> frames;
  double closing_rate =
      0;  ///< radians about T a metre, already applied: spreads a closed trajectory's leftover angle
};

FramesAlong rotation_minimizing_frames(const Curve3& trajectory, std::span<const Station> stations);

}  // namespace sweepkit::sweep
