// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

// A JPEG file that no encoder here writes, by hand (ITU-T T.81, Adobe's TN 5116).
namespace sweepkit::texmap {

/// 8 x 8 pixels of one colour in CMYK, as Adobe writes them: 255 is no ink.
inline std::vector<std::byte> make_cmyk_jpeg(const std::array<std::uint8_t, 4>& inks) {
  std::vector<std::byte> jpeg;
  const auto put = [&](std::initializer_list<int> values) {
    for (const int value : values) jpeg.push_back(static_cast<std::byte>(value));
  };
  put({0xFF, 0xD8});
  put({0xFF, 0xEE, 0, 14, 'A', 'd', 'o', 'b', 'e', 0, 100, 0, 0, 0, 0, 0});  // inks as they are
  put({0xFF, 0xDB, 0, 67, 0});
  for (int i = 0; i < 64; ++i) put({1});  // quantized in steps of 1
  put({0xFF, 0xC0, 0, 20, 8, 0, 8, 0, 8, 4});
  for (int i = 1; i <= 4; ++i) put({i, 0x11, 0});
  // Lengths 0 to 11 of a first coefficient, all in codes of 4 bits; of the others only "no more", one bit 0.
  put({0xFF, 0xC4, 0, 31, 0x00, 0, 0, 0, 12, 0, 0, 0, 0, 0, 0,  0, 0,
       0,    0,    0, 0,  0,    1, 2, 3, 4,  5, 6, 7, 8, 9, 10, 11});
  put({0xFF, 0xC4, 0, 20, 0x10, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  put({0xFF, 0xDA, 0, 14, 4, 1, 0, 2, 0, 3, 0, 4, 0, 0, 63, 0});
  std::vector<bool> bits;
  const auto put_bits = [&](int value, int count) {
    for (int i = count - 1; i >= 0; --i) bits.push_back((value >> i & 1) != 0);
  };
  for (const std::uint8_t ink : inks) {
    const int coefficient = 8 * (ink - 128);  // the mean, as the transform is scaled
    const int size = coefficient < 0 ? -coefficient : coefficient;
    int length = 0;
    while (size >> length != 0) ++length;
    put_bits(length, 4);
    put_bits(coefficient < 0 ? coefficient + (1 << length) - 1 : coefficient, length);
    put_bits(0, 1);
  }
  while (bits.size() % 8 != 0) bits.push_back(true);
  for (std::size_t i = 0; i < bits.size(); i += 8) {
    int byte = 0;
    for (std::size_t k = 0; k < 8; ++k) byte = 2 * byte + (bits[i + k] ? 1 : 0);
    put({byte});
    if (byte == 0xFF) put({0});
  }
  put({0xFF, 0xD9});
  return jpeg;
}

}  // namespace sweepkit::texmap
