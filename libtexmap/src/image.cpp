// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/image.hpp"

namespace sweepkit::texmap {

std::size_t Image::bytes() const {
  return std::visit([](const auto& values) { return values.size() * sizeof(values[0]); }, texels);
}

glm::vec3 Image::color(int x, int y) const {
  const std::size_t first =
      (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
      static_cast<std::size_t>(channels);
  const std::size_t green = channels >= 3 ? 1 : 0;
  const std::size_t blue = channels >= 3 ? 2 : 0;
  if (const auto* floats = std::get_if<std::vector<float>>(&texels)) {
    return {(*floats)[first], (*floats)[first + green], (*floats)[first + blue]};
  }
  const auto& integers = std::get<std::vector<std::uint16_t>>(texels);
  return glm::vec3(integers[first], integers[first + green], integers[first + blue]) / 65535.0f;
}

Image make_float_image(int width, int height, int channels) {
  const auto count =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels);
  return {width, height, channels, std::vector<float>(count, 0.0f)};
}

}  // namespace sweepkit::texmap
