// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

namespace sweepkit::sweep {

/// (cos, sin) of an angle in degrees, exact at whole quarter turns and symmetric about them, so that rings
/// close bit for bit. The angle is reduced exactly (fmod, then a subtraction of near numbers) before any
/// rounding.
struct CosSin {
  double cos, sin;
};

inline CosSin cos_sin_deg(double degrees) {
  const double turn = std::fmod(degrees, 360.0);
  const double quarter = std::nearbyint(turn / 90.0);
  const double radians = (turn - 90.0 * quarter) * (std::numbers::pi / 180.0);
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  switch ((static_cast<int>(quarter) % 4 + 4) % 4) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

}  // namespace sweepkit::sweep
