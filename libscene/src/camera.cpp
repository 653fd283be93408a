// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/camera.hpp"

#include <cmath>

namespace sweepkit::scene {

glm::dmat3 world_from_camera(const Camera& camera) {
  const glm::dvec3 back = glm::normalize(camera.eye - camera.target);
  glm::dvec3 right = glm::cross(camera.up, back);
  if (glm::length(right) < 1e-9 * glm::length(camera.up)) {
    right = glm::cross(std::abs(back.z) < 0.5 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0), back);
  }
  right = glm::normalize(right);
  return {right, glm::cross(back, right), back};
}

}  // namespace sweepkit::scene
