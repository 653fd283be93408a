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

/// The middle of pixel (x, y), as a place of the picture.
inline glm::dvec2 middle_of(int x, int y) {
  return {x + 0.5, y + 0.5};
}

/// The rays through the places of a picture width x height, in pixels from its top left corner, x to the
/// right, y down; places outside it have rays too (the filter's border). A width that is no whole
/// number is that of a coarser picture whose last column is cut.
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

  Ray through(const glm::dvec2& place) const { return {eye_, glm::normalize(towards(place))}; }
  Ray through(int x, int y) const { return through(middle_of(x, y)); }

  /// For steps of `step` pixels.
  RayDifferential differential(const glm::dvec2& place, double step = 1) const {
    const glm::dvec3 to = towards(place);
    const double length = glm::length(to);
    const glm::dvec3 direction = to / length;
    // Of a vector made unit.
    const auto turned = [&](const glm::dvec3& moved) {
      return (moved - glm::dot(direction, moved) * direction) / length;
    };
    return {.direction_x = turned(step * across_), .direction_y = turned(step * down_)};
  }
  RayDifferential differential(int x, int y) const { return differential(middle_of(x, y)); }

 private:
  glm::dvec3 towards(const glm::dvec2& place) const { return corner_ + place.x * across_ + place.y * down_; }

  glm::dvec3 eye_;
  glm::dvec3 axis_;
  glm::dvec3 corner_;
  glm::dvec3 across_;
  glm::dvec3 down_;
};

}  // namespace sweepkit::render
