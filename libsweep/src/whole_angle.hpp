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

inline CosSin turned_by_quarters(CosSin angle, int quarters) {
  switch ((quarters % 4 + 4) % 4) {
    case 0:
      return angle;
    case 1:
      return {-angle.sin, angle.cos};
    case 2:
      return {-angle.cos, -angle.sin};
    default:
      return {angle.sin, -angle.cos};
  }
}

inline CosSin cos_sin_deg(double degrees) {
  const double turn = std::fmod(degrees, 360.0);
  const double quarter = std::nearbyint(turn / 90.0);
  const double radians = (turn - 90.0 * quarter) * (std::numbers::pi / 180.0);
  return turned_by_quarters({std::cos(radians), std::sin(radians)}, static_cast<int>(quarter));
}

/// (cos, sin) of part / parts of a whole turn. The reduction is in integers, so the ring of `parts` points is
/// the same bits mirrored about both axes, and turned by quarters where 4 divides `parts`.
inline CosSin cos_sin_turn(int part, int parts) {
  const int quarter = (8 * part + parts) / (2 * parts);  // the nearest; parts is at most 32768
  const double rest = static_cast<double>(4 * part - quarter * parts) / parts;
  const double radians = rest * (std::numbers::pi / 2);
  return turned_by_quarters({std::cos(radians), std::sin(radians)}, quarter);
}

}  // namespace sweepkit::sweep
