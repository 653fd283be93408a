// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace sweepkit::texmap {

/// Four floats, or a texel of four, that are added and multiplied at once.
using Float4 = float __attribute__((vector_size(16)));

/// A texel as tiles hold it: RGB in linear light and a one, so that the sum of weighed texels carries the sum
/// of the weights along. 65535 is 1 in the integer form.
using IntegerTexel = std::uint16_t __attribute__((vector_size(8)));
using FloatTexel = Float4;

inline Float4 to_float4(IntegerTexel texel) {
  return __builtin_convertvector(texel, Float4);
}
inline Float4 to_float4(FloatTexel texel) {
  return texel;
}

}  // namespace sweepkit::texmap
