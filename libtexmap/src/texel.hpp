// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

namespace sweepkit::texmap {

/// Four floats, or a texel of four, that are added and multiplied at once.
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

/// A texel as tiles hold it: RGB in linear light and a one, so that the sum of weighed texels carries the sum
/// of the weights along. 65535 is 1 in the integer form.
using IntegerTexel = std::uint16_t __attribute__((vector_size(8)));
using FloatTexel = Float4;

/// By way of 32-bit integers, zeros put between the halves: two instructions, where gcc makes sixteen of the
/// conversion from 16 bits.
inline Float4 to_float4(IntegerTexel texel) {
  if constexpr (std::endian::native == std::endian::little) {
    constexpr IntegerTexel kZeros = {};
    using Halves = std::uint16_t __attribute__((vector_size(16)));
    const Halves halves = __builtin_shufflevector(texel, kZeros, 0, 4, 1, 5, 2, 6, 3, 7);
    return __builtin_convertvector(reinterpret_cast<Int4>(halves), Float4);
  } else {
    return __builtin_convertvector(texel, Float4);
  }
}
inline Float4 to_float4(FloatTexel texel) {
  return texel;
}

}  // namespace sweepkit::texmap
