// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "pyramid.hpp"
#include "texel.hpp"

namespace sweepkit::texmap {

/// Texels as the integers that a table sums: texel = zero + step * word, a channel at a time. Words of
/// integer texels are differences from one texel of the image, so that a constant image is all zeros; they
/// may be negative, which unsigned words that wrap round take as they are.
struct FixedPoint {
  std::array<double, 3> zero{};          ///< the texel whose word is 0
  std::array<double, 3> step{1, 1, 1};   ///< a word more in a texel
  std::array<double, 3> scale{1, 1, 1};  ///< words a unit of a texel; 0 where float texels are all alike
  double white = 65535;                  ///< the texel that is 1
  int bits = 16;                         ///< words are less than 2^bits in magnitude

  /// The light that words, or a fraction of one, stand for.
  double light(double words, std::size_t channel) const {
    return (zero[channel] + step[channel] * words) / white;
  }

  std::uint64_t word(IntegerTexel texel, std::size_t channel) const {
    return texel[channel] - static_cast<std::uint64_t>(zero[channel]);
  }
  std::uint64_t word(FloatTexel texel, std::size_t channel) const {
    // Means of coarser levels are rounded to float and may leave the range by that.
    const double value = (static_cast<double>(texel[channel]) - zero[channel]) * scale[channel];
    return value > 0 ? static_cast<std::uint64_t>(std::llrint(value)) : 0;
  }
};

/// The words for a texture: differences of its own integers, or 2^float_bits steps over the range of its
/// floats, a channel at a time, for which all of them are looked at.
FixedPoint fixed_point_of(const Pyramid& pyramid, int float_bits);

}  // namespace sweepkit::texmap
