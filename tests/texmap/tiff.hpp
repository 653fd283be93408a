// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// TIFF files as a test wants them, written without any codec (TIFF 6.0, little-endian, not compressed).
namespace sweepkit::texmap {

struct TiffHeader {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint16_t channels = 1;
  std::uint16_t bits = 8;
  std::uint16_t photometric = 1;  ///< 0 white is 0, 1 black is 0, 2 RGB, 5 CMYK
  bool is_float = false;
  std::uint32_t tile = 0;  ///< its side, a multiple of 16; 0: one strip
};

/// `samples` is the strip as TIFF packs it, or the tiles one after another, each whole.
inline std::vector<std::byte> make_tiff(const TiffHeader& header, std::span<const std::byte> samples) {
  std::vector<std::byte> tiff;
  const auto put = [&](std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) tiff.push_back(static_cast<std::byte>(value >> (8 * i)));
  };
  struct Entry {
    std::uint16_t tag;
    std::vector<std::uint32_t> values;  // 32 bits each
  };
  const std::vector<std::uint32_t> per_channel(header.channels, header.bits);
  const std::vector<std::uint32_t> formats(header.channels, header.is_float ? 3 : 1);
  std::vector<std::uint32_t> offsets;
  std::vector<std::uint32_t> counts;
  const std::uint32_t tiles = header.tile == 0 ? 1
                                               : ((header.width + header.tile - 1) / header.tile) *
                                                     ((header.height + header.tile - 1) / header.tile);
  for (std::uint32_t i = 0; i < tiles; ++i) {
    counts.push_back(static_cast<std::uint32_t>(samples.size()) / tiles);
    offsets.push_back(8 + i * counts[0]);
  }
  std::vector<Entry> entries = {{256, {header.width}},
                                {257, {header.height}},
                                {258, per_channel},
                                {259, {1}},
                                {262, {header.photometric}}};
  if (header.tile == 0) entries.push_back({273, offsets});
  entries.push_back({277, {header.channels}});
  if (header.tile == 0) {
    entries.push_back({278, {header.height}});
    entries.push_back({279, counts});
  }
  entries.push_back({284, {1}});
  if (header.tile != 0) {
    entries.push_back({322, {header.tile}});
    entries.push_back({323, {header.tile}});
    entries.push_back({324, offsets});
    entries.push_back({325, counts});
  }
  entries.push_back({339, formats});

  put(0x002A4949, 4);
  put(static_cast<std::uint32_t>(8 + samples.size() + samples.size() % 2), 4);
  tiff.insert(tiff.end(), samples.begin(), samples.end());
  if (samples.size() % 2 == 1) put(0, 1);
  put(static_cast<std::uint32_t>(entries.size()), 2);
  // Values that do not fit into their entry stand behind the directory.
  std::uint32_t behind = static_cast<std::uint32_t>(tiff.size() + 12 * entries.size() + 4);
  for (const Entry& entry : entries) {
    put(entry.tag, 2);
    put(4, 2);
    put(static_cast<std::uint32_t>(entry.values.size()), 4);
    put(entry.values.size() == 1 ? entry.values[0] : behind, 4);
    if (entry.values.size() > 1) behind += static_cast<std::uint32_t>(4 * entry.values.size());
  }
  put(0, 4);
  for (const Entry& entry : entries) {
    if (entry.values.size() == 1) continue;
    for (const std::uint32_t value : entry.values) put(value, 4);
  }
  return tiff;
}

}  // namespace sweepkit::texmap
