// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace sweepkit::scene {

/// What a PNG or JPEG file says of itself at its beginning.
struct ImageHeader {
  bool is_jpeg = false;
  int width = 0;
  int height = 0;
  int components = 0;   ///< of a JPEG: 1 grey, 3 colour, 4 for printing; of a PNG 0
  int orientation = 1;  ///< of a JPEG: Exif's, 1 as it stands; browsers turn what is not 1, others do not
};

/// None for what is neither, or is cut short before it says so much.
std::optional<ImageHeader> image_header(std::span<const std::byte> bytes);

}  // namespace sweepkit::scene
