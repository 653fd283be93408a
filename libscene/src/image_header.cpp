// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// PNG: the IHDR chunk comes first. JPEG: segments up to the first start of frame; Exif is TIFF in a segment.

#include "image_header.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace sweepkit::scene {
namespace {

using Bytes = std::span<const std::byte>;

std::uint32_t big_endian(Bytes bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
  return value;
}

bool begins_with(Bytes bytes, std::string_view text) {
  return bytes.size() >= text.size() &&
         std::ranges::equal(bytes.first(text.size()), std::as_bytes(std::span(text)));
}

// Of the first directory: twelve bytes an entry, the orientation a 16-bit number of tag 0x112.
int exif_orientation(Bytes tiff) {
  if (tiff.size() < 8) return 1;
  const bool is_little = begins_with(tiff, "II");
  const auto number = [&](std::size_t at, std::size_t count) -> std::uint32_t {
    if (at > tiff.size() || tiff.size() - at < count) return 0;
    if (!is_little) return big_endian(tiff, at, count);
    std::uint32_t value = 0;
    for (std::size_t i = count; i-- > 0;) value = value << 8 | std::to_integer<std::uint32_t>(tiff[at + i]);
    return value;
  };
  const std::size_t directory = number(4, 4);
  for (std::size_t i = 0; i < number(directory, 2); ++i) {
    const std::size_t entry = directory + 2 + 12 * i;
    if (number(entry, 2) == 0x112) return static_cast<int>(number(entry + 8, 2));
  }
  return 1;
}

}  // namespace

std::optional<ImageHeader> image_header(Bytes bytes) {
  using namespace std::string_view_literals;
  if (bytes.size() >= 24 && begins_with(bytes, "\x89PNG\r\n\x1a\n"sv)) {
    return ImageHeader{.width = static_cast<int>(big_endian(bytes, 16, 4)),
                       .height = static_cast<int>(big_endian(bytes, 20, 4))};
  }
  if (!begins_with(bytes, "\xff\xd8"sv)) return std::nullopt;
  ImageHeader header{.is_jpeg = true};
  bool has_exif = false;
  for (std::size_t at = 2; at + 10 <= bytes.size() && bytes[at] == std::byte{0xff};) {
    const std::uint32_t marker = big_endian(bytes, at + 1, 1);
    const std::size_t size = big_endian(bytes, at + 2, 2);
    const bool is_frame =
        marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (is_frame) {
      header.height = static_cast<int>(big_endian(bytes, at + 5, 2));
      header.width = static_cast<int>(big_endian(bytes, at + 7, 2));
      header.components = static_cast<int>(big_endian(bytes, at + 9, 1));
      return header;
    }
    if (size < 2 || size > bytes.size() - at - 2) return std::nullopt;
    const Bytes segment = bytes.subspan(at + 4, size - 2);
    if (marker == 0xe1 && !has_exif && begins_with(segment, "Exif\0\0"sv)) {
      has_exif = true;  // the first counts
      header.orientation = exif_orientation(segment.subspan(6));
    }
    at += 2 + size;
  }
  return std::nullopt;
}

}  // namespace sweepkit::scene
