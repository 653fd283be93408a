// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sweepkit/error.hpp"
#include "sweepkit/texmap/image_error.hpp"

namespace sweepkit::texmap {

/// The rectangle to compare, inside both images. Throws InputError if the sizes differ or it is not inside.
inline PixelRect checked_rect(const Image& image, const Image& reference, const PixelRect& rect) {
  const auto size = [](int width, int height) {
    return std::to_string(width) + " x " + std::to_string(height);
  };
  if (image.width != reference.width || image.height != reference.height) {
    throw InputError("pictures of one size are needed, got " + size(image.width, image.height) + " and " +
                     size(reference.width, reference.height));
  }
  if (rect.width == 0) return {0, 0, image.width, image.height};
  if (rect.x < 0 || rect.y < 0 || rect.width < 1 || rect.height < 1 || rect.x + rect.width > image.width ||
      rect.y + rect.height > image.height) {
    throw InputError("the rectangle does not lie inside the picture of " + size(image.width, image.height));
  }
  return rect;
}

}  // namespace sweepkit::texmap
