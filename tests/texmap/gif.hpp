// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

// GIF files as a test wants them, written without any codec (GIF89a).
namespace sweepkit::texmap {

/// An animation of frames of width x height indices into four colours.
inline std::vector<std::byte> make_gif(int width, int height,
                                       std::span<const std::array<std::uint8_t, 3>, 4> colors,
                                       std::span<const std::vector<std::uint8_t>> frames) {
  std::vector<std::byte> gif;
  const auto put = [&](int value) { gif.push_back(static_cast<std::byte>(value)); };
  const auto put_size = [&] {
    for (const int value : {width & 255, width >> 8, height & 255, height >> 8}) put(value);
  };
  for (const char c : std::string_view("GIF89a")) put(c);
  put_size();
  for (const int value : {0x81, 0, 0}) put(value);
  for (const auto& color : colors) {
    for (const std::uint8_t value : color) put(value);
  }
  for (const std::vector<std::uint8_t>& frame : frames) {
    for (const int value : {0x21, 0xF9, 4, 0, 10, 0, 0, 0}) put(value);  // shown for a tenth of a second
    for (const int value : {0x2C, 0, 0, 0, 0}) put(value);
    put_size();
    put(0);
    // Codes of 3 bits: 0 to 3 are colours, 4 clears the table, 5 ends. Cleared after every second colour, the
    // table never grows to where codes have 4.
    std::vector<int> codes;
    for (std::size_t i = 0; i < frame.size(); ++i) {
      if (i % 2 == 0) codes.push_back(4);
      codes.push_back(frame[i]);
    }
    codes.push_back(5);
    std::vector<int> bytes;
    for (std::size_t i = 0; i < codes.size(); ++i) {
      for (std::size_t bit = 3 * i; bit < 3 * i + 3; ++bit) {
        if (bit % 8 == 0) bytes.push_back(0);
        bytes.back() |= (codes[i] >> (bit - 3 * i) & 1) << bit % 8;
      }
    }
    put(2);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      if (i % 255 == 0) put(static_cast<int>(std::min<std::size_t>(255, bytes.size() - i)));
      put(bytes[i]);
    }
    put(0);
  }
  put(0x3B);
  return gif;
}

}  // namespace sweepkit::texmap
