// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <variant>
#include <vector>

#include "sweepkit/texmap/image.hpp"
#include "sweepkit/texmap/texture.hpp"

namespace sweepkit::texmap {

/// A box in texture coordinates; v upwards. min <= max.
struct UvBox {
  glm::dvec2 min{0.0};
  glm::dvec2 max{0.0};
};

/// Repeated integration of order 1 [Crow84]: the exact mean of a texture, constant over each texel, over any
/// box in any place, under the texture's wrap. Integer images are summed in 64-bit integers that may wrap
/// round and differenced before any rounding: boxes with integer corners are exact, others within 1e-3 of an
/// 8-bit level. Float images are summed in double after their mean is taken off.
class SummedAreaTable {
 public:
  SummedAreaTable(const Image& image, Wrap wrap);

  /// The mean colour, linear RGB. A side narrower than one texel is widened to one about its middle, which is
  /// bilinear interpolation. Boxes that are infinite or NaN give the mean of the whole texture.
  glm::vec3 mean(const UvBox& box) const;

  std::size_t bytes() const;

 private:
  int width_;
  int height_;
  Wrap wrap_;
  // (width + 1) x (height + 1) sums of RGB over the texels left of and above each corner; row 0 and column 0
  // are zero.
  std::variant<std::vector<std::uint64_t>, std::vector<double>> sums_;
  glm::dvec3 offset_{0.0};  // what was taken off each texel of a float image
};

}  // namespace sweepkit::texmap
