// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "frames.hpp"
#include "stations.hpp"
#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::sweep {

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

/// The frame at a trajectory's start: B is `up` made perpendicular to T; where T is along `up` -Z stands in,
/// and +Y where T is along that too.
Frame first_frame(const glm::dvec3& tangent, const glm::dvec3& up);

/// The frames at the stations, from first_frame() on. A closed trajectory's may come home turned: closing
/// them is orient()'s (orientation.hpp).
std::vector<StationFrames> rotation_minimizing_frames(const Curve3& trajectory,
                                                      std::span<const Station> stations,
                                                      const glm::dvec3& up = {0, 1, 0});

}  // namespace sweepkit::sweep
