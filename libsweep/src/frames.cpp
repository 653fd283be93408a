// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "frames.hpp"

#include <cmath>

namespace sweepkit::sweep {

Frame turned(const Frame& frame, double angle) {
  if (angle == 0) return frame;
  const glm::dvec3 n = std::cos(angle) * frame.normal + std::sin(angle) * frame.binormal;
  return {n, glm::cross(frame.tangent, n), frame.tangent};
}

double angle_to(const Frame& frame, const glm::dvec3& direction) {
  return std::atan2(glm::dot(direction, frame.binormal), glm::dot(direction, frame.normal));
}

}  // namespace sweepkit::sweep
