// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "texel.hpp"

namespace sweepkit::texmap {

/// Texels as the integers that a table sums: colour = origin + step * word, a channel at a time. Words of
/// integer texels are differences from one texel of the image, so that a constant image is all zeros; they
/// may be negative, which unsigned words that wrap round take as they are.
struct FixedPoint {
  std::array<double, 3> origin{};        ///< the colour of word 0
  std::array<double, 3> step{};          ///< of a word
  std::array<double, 3> zero{};          ///< the texel whose word is 0
  std::array<double, 3> scale{1, 1, 1};  ///< words a unit of a texel; 0 where float texels are all alike
  int bits = 16;                         ///< words are less than 2^bits in magnitude

  std::uint64_t word(IntegerTexel texel, std::size_t channel) const {
    return texel[channel] - static_cast<std::uint64_t>(zero[channel]);
  }
  std::uint64_t word(FloatTexel texel, std::size_t channel) const {
    // Means of coarser levels are rounded to float and may leave the range by that.
    const double value = (static_cast<double>(texel[channel]) - zero[channel]) * scale[channel];
    return value > 0 ? static_cast<std::uint64_t>(static_cast<std::int64_t>(value + 0.5)) : 0;
  }
};

}  // namespace sweepkit::texmap
