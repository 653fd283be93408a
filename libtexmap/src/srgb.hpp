// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace sweepkit::texmap {

/// The sRGB transfer curve (IEC 61966-2-1), both ways, for values in [0, 1].
inline double linear_from_srgb(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}
inline double srgb_from_linear(double value) {
  return value <= 0.0031308 ? value * 12.92 : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
}

/// 16-bit sRGB samples to 16-bit linear light, rounded to nearest: 65,536 entries, made by the first call.
const std::vector<std::uint16_t>& linear_from_srgb_table();

}  // namespace sweepkit::texmap
