// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

namespace sweepkit::scene {

/// (cos, sin) of an angle in degrees. A whole quarter turn is exact, so that a wall turned by 90 degrees
/// stands upright to the last bit.
inline glm::dvec2 cos_sin_deg(double degrees) {
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

}  // namespace sweepkit::scene
