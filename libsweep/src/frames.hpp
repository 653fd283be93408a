// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

namespace sweepkit::sweep {

/// An orthonormal right-handed frame (N, B, T): N x B = T.
struct Frame {
  glm::dvec3 normal;
  glm::dvec3 binormal;
  glm::dvec3 tangent;
};

/// A frame that turns: by `rate` radians a metre about T, right-handed, measured against a
/// rotation-minimizing one.
struct TurningFrame {
  Frame frame;
  double rate = 0;
};

/// The frames in which the curve arrives at and leaves a station.
struct StationFrames {
  TurningFrame in;
  TurningFrame out;
};

/// `frame` turned by `angle` radians about T.
Frame turned(const Frame& frame, double angle);

/// The angle about `frame.tangent` by which its N has to turn to point where `direction` does.
double angle_to(const Frame& frame, const glm::dvec3& direction);

}  // namespace sweepkit::sweep
