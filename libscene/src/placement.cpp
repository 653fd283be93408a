// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {
namespace {

// A quarter turn is exact, so that a wall turned by 90 degrees stands upright to the last bit.
glm::dvec2 cos_sin(double degrees) {
  const double quarters = degrees / 90;
  if (quarters == std::floor(quarters)) {
    switch (static_cast<int>(std::fmod(quarters, 4)) & 3) {
      case 0:
        return {1, 0};
      case 1:
        return {0, 1};
      case 2:
        return {-1, 0};
      default:
        return {0, -1};
    }
  }
  const double radians = std::fmod(degrees, 360) * (std::numbers::pi / 180);
  return {std::cos(radians), std::sin(radians)};
}

}  // namespace

glm::dmat4 to_matrix(const Placement& placement) {
  const glm::dvec2 x = cos_sin(placement.rotate_deg.x);
  const glm::dvec2 y = cos_sin(placement.rotate_deg.y);
  const glm::dvec2 z = cos_sin(placement.rotate_deg.z);
  // Columns: glm stores a matrix by them.
  const glm::dmat3 about_x({1, 0, 0}, {0, x[0], x[1]}, {0, -x[1], x[0]});
  const glm::dmat3 about_y({y[0], 0, -y[1]}, {0, 1, 0}, {y[1], 0, y[0]});
  const glm::dmat3 about_z({z[0], z[1], 0}, {-z[1], z[0], 0}, {0, 0, 1});
  const glm::dmat3 linear = about_z * about_y * about_x;
  return {glm::dvec4(linear[0] * placement.scale.x, 0), glm::dvec4(linear[1] * placement.scale.y, 0),
          glm::dvec4(linear[2] * placement.scale.z, 0), glm::dvec4(placement.translate, 1)};
}

}  // namespace sweepkit::scene
