// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "ray.hpp"
#include "sweepkit/scene/camera.hpp"

namespace sweepkit::render {

/// One ray through the middle of each pixel of a picture width x height; pixels outside it have rays too (the
/// filter's border). x to the right, y down.
class EyeRays {
 public:
  EyeRays(const scene::Camera& camera, int width, int height) : eye_(camera.eye) {
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    glm::dvec3 right = glm::cross(forward, camera.up);
    // Looking along `up`, the picture's top is -Z, or +Z where the view is downwards along -Z itself.
    if (glm::length(right) < 1e-9 * glm::length(camera.up)) {
      right = glm::cross(forward, std::abs(forward.z) < 0.5 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0));
    }
    right = glm::normalize(right);
    const glm::dvec3 up = glm::cross(right, forward);
    const double pixel = 2 * std::tan(0.5 * camera.fov_deg * std::numbers::pi / 180) / height;
    across_ = pixel * right;
    down_ = -pixel * up;
    corner_ = forward - 0.5 * width * across_ - 0.5 * height * down_;
  }

  Ray through(int x, int y) const {
    return {eye_, glm::normalize(corner_ + (x + 0.5) * across_ + (y + 0.5) * down_)};
  }

 private:
  glm::dvec3 eye_;
  glm::dvec3 corner_;
  glm::dvec3 across_;
  glm::dvec3 down_;
};

}  // namespace sweepkit::render
