// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "sweepkit/texmap/image.hpp"

namespace sweepkit::texmap::test {

/// RGB, every sample evenly random: 16-bit integers, or floats from 0 to 1.
inline Image random_image(int width, int height, unsigned seed, bool is_float = false) {
  std::mt19937 random(seed);
  const std::size_t count = 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Image image{width, height, 3, {}};
  if (is_float) {
    std::vector<float> texels(count);
    for (float& t : texels) t = std::uniform_real_distribution<float>(0, 1)(random);
    image.texels = std::move(texels);
  } else {
    std::vector<std::uint16_t> texels(count);
    for (std::uint16_t& t : texels) t = static_cast<std::uint16_t>(random());
    image.texels = std::move(texels);
  }
  return image;
}

}  // namespace sweepkit::texmap::test
