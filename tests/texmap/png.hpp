// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

// PNG files as a test wants them, broken ones too, written without any codec: the pixels are stored, not
// compressed (RFC 1950 and 1951, PNG third edition).
namespace sweepkit::texmap {

struct PngHeader {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint8_t bits = 8;
  std::uint8_t color_type = 2;  ///< 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGB and alpha
};

inline void put32(std::vector<std::byte>& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::byte>(value >> shift));
}

inline void put_chunk(std::vector<std::byte>& png, std::string_view type, std::span<const std::byte> data) {
  put32(png, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = png.size();
  for (const char c : type) png.push_back(static_cast<std::byte>(c));
  png.insert(png.end(), data.begin(), data.end());
  std::uint32_t crc = 0xFFFFFFFFu;
  for (std::size_t i = start; i < png.size(); ++i) {
    crc ^= static_cast<std::uint32_t>(png[i]);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320u : 0u);
  }
  put32(png, ~crc);
}

/// `rows` is the image's data as PNG packs it, without filter bytes; at most 65535 bytes with them. `palette`
/// is RGB.
inline std::vector<std::byte> make_png(const PngHeader& header, std::span<const std::uint8_t> rows,
                                       std::span<const std::uint8_t> palette = {}) {
  std::vector<std::byte> png;
  for (const unsigned value : {0x89u, 0x50u, 0x4Eu, 0x47u, 0x0Du, 0x0Au, 0x1Au, 0x0Au})
    png.push_back(static_cast<std::byte>(value));
  std::vector<std::byte> chunk;
  put32(chunk, header.width);
  put32(chunk, header.height);
  for (const std::uint8_t value :
       {header.bits, header.color_type, std::uint8_t{0}, std::uint8_t{0}, std::uint8_t{0}})
    chunk.push_back(static_cast<std::byte>(value));
  put_chunk(png, "IHDR", chunk);
  if (!palette.empty()) put_chunk(png, "PLTE", std::as_bytes(palette));

  std::vector<std::byte> data;
  const std::size_t row = std::max<std::size_t>(1, rows.size() / std::max(1u, header.height));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i % row == 0) data.push_back(std::byte{0});  // the filter "none"
    data.push_back(static_cast<std::byte>(rows[i]));
  }
  std::vector<std::byte> zlib = {std::byte{0x78}, std::byte{0x01}, std::byte{0x01}};
  const auto length = static_cast<std::uint32_t>(data.size());
  for (const unsigned value : {length & 255u, (length >> 8u) & 255u, ~length & 255u, (~length >> 8u) & 255u})
    zlib.push_back(static_cast<std::byte>(value));
  zlib.insert(zlib.end(), data.begin(), data.end());
  std::uint32_t low = 1;
  std::uint32_t high = 0;
  for (const std::byte value : data) {
    low = (low + static_cast<std::uint32_t>(value)) % 65521;
    high = (high + low) % 65521;
  }
  put32(zlib, (high << 16) | low);
  put_chunk(png, "IDAT", zlib);
  put_chunk(png, "IEND", {});
  return png;
}

}  // namespace sweepkit::texmap
