// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "fixed_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sweepkit::texmap {

FixedPoint fixed_point_of(const Pyramid& pyramid, int float_bits) {
  FixedPoint fixed;
  if (!pyramid.is_float()) {
    const IntegerTexel first = pyramid.read<IntegerTexel>(0, {0, 0, 1, 1}).front();
    for (std::size_t k = 0; k < 3; ++k) fixed.zero[k] = first[k];
    return fixed;
  }
  fixed.white = 1;
  fixed.bits = float_bits;
  const Pyramid::Level& size = pyramid.level(0);
  std::array<float, 3> low;
  std::array<float, 3> high;
  low.fill(std::numeric_limits<float>::max());
  high.fill(std::numeric_limits<float>::lowest());
  for (int y = 0; y < size.height; y += kTileSide) {
    const PixelRect band{0, y, size.width, std::min(kTileSide, size.height - y)};
    for (const FloatTexel& texel : pyramid.read<FloatTexel>(0, band)) {
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], texel[k]);
        high[k] = std::max(high[k], texel[k]);
      }
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    fixed.zero[k] = low[k];
    const double range = static_cast<double>(high[k]) - fixed.zero[k];
    fixed.step[k] = range / (std::exp2(fixed.bits) - 1);
    fixed.scale[k] = range > 0 ? (std::exp2(fixed.bits) - 1) / range : 0;
  }
  return fixed;
}

}  // namespace sweepkit::texmap
