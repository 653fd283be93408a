// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/image_error.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "checked_rect.hpp"

namespace sweepkit::texmap {

double rmse(const Image& image, const Image& reference, const PixelRect& rect) {
  const PixelRect area = checked_rect(image, reference, rect);
  double sum = 0;
  for (int y = area.y; y < area.y + area.height; ++y) {
    for (int x = area.x; x < area.x + area.width; ++x) {
      const glm::dvec3 difference = glm::dvec3(image.color(x, y)) - glm::dvec3(reference.color(x, y));
      sum += glm::dot(difference, difference);
    }
  }
  return std::sqrt(sum / (3.0 * area.width * area.height));
}

double rmse(const Image& image, const Image& reference, std::span<const std::uint8_t> mask) {
  const PixelRect area = checked_rect(image, reference, {});
  if (mask.size() != static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height)) {
    throw InputError("the mask has " + std::to_string(mask.size()) + " pixels, the pictures have " +
                     std::to_string(area.width) + " x " + std::to_string(area.height));
  }
  double sum = 0;
  double count = 0;
  for (int y = 0; y < area.height; ++y) {
    for (int x = 0; x < area.width; ++x) {
      if (mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(area.width) +
               static_cast<std::size_t>(x)] == 0)
        continue;
      const glm::dvec3 difference = glm::dvec3(image.color(x, y)) - glm::dvec3(reference.color(x, y));
      sum += glm::dot(difference, difference);
      count += 3;
    }
  }
  return count > 0 ? std::sqrt(sum / count) : 0;
}

double psnr(const Image& image, const Image& reference, const PixelRect& rect) {
  const double error = rmse(image, reference, rect);
  return error > 0 ? -20 * std::log10(error) : std::numeric_limits<double>::infinity();
}

}  // namespace sweepkit::texmap
