// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <variant>
#include <vector>

namespace sweepkit::texmap {

/// Texels in linear light, row 0 on top. Integer images (8- and 16-bit files) are kept as 16-bit integers,
/// 65535 being 1, so that tables over them are exact; float and HDR images, and pictures that were rendered,
/// as float32.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 3;  ///< 1 grey, 2 grey and alpha, 3 RGB, 4 RGB and alpha
  std::variant<std::vector<std::uint16_t>, std::vector<float>>
      texels;  ///< width * height * channels, interleaved

  bool is_float() const { return std::holds_alternative<std::vector<float>>(texels); }
  std::size_t bytes() const;
  /// Colour of a texel; grey is spread over RGB, alpha is left out. Precondition: inside the image.
  glm::vec3 color(int x, int y) const;
};

/// A black float image.
Image make_float_image(int width, int height, int channels = 3);

}  // namespace sweepkit::texmap
