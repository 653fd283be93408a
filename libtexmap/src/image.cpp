// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/image.hpp"

namespace sweepkit::texmap {

Image make_float_image(int width, int height, int channels) {
  const auto count =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels);
  return {width, height, channels, std::vector<float>(count, 0.0f)};
}

}  // namespace sweepkit::texmap
