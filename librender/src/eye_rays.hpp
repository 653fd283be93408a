// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "ray.hpp"
#include "ray_differential.hpp"
#include "sweepkit/scene/camera.hpp"

namespace sweepkit::render {

/// One ray through the middle of each pixel of a picture width x height; pixels outside it have rays too (the
/// filter's border). x to the right, y down. A width that is no whole number is that of a coarser picture
/// whose last column is cut.
class EyeRays {
 public:
  EyeRays(const scene::Camera& camera, double width, double height) : eye_(camera.eye) {
    const glm::dmat3 axes = scene::world_from_camera(camera);
    const double pixel = 2 * std::tan(0.5 * camera.fov_deg * std::numbers::pi / 180) / height;
    across_ = pixel * axes[0];
    down_ = -pixel * axes[1];
    axis_ = -axes[2];
    corner_ = -axes[2] - 0.5 * width * across_ - 0.5 * height * down_;
  }

  /// Where the camera looks, unit.
  const glm::dvec3& view_axis() const { return axis_; }

  Ray through(int x, int y) const { return {eye_, glm::normalize(towards(x, y))}; }

  RayDifferential differential(int x, int y) const {
    const glm::dvec3 to = towards(x, y);
    const double length = glm::length(to);
    const glm::dvec3 direction = to / length;
    // Of a vector made unit.
    const auto turned = [&](const glm::dvec3& step) {
      return (step - glm::dot(direction, step) * direction) / length;
    };
    return {.direction_x = turned(across_), .direction_y = turned(down_)};
  }

 private:
  glm::dvec3 towards(int x, int y) const { return corner_ + (x + 0.5) * across_ + (y + 0.5) * down_; }

  glm::dvec3 eye_;
  glm::dvec3 axis_;
  glm::dvec3 corner_;
  glm::dvec3 across_;
  glm::dvec3 down_;
};

}  // namespace sweepkit::render
