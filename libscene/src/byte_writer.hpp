// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace sweepkit::scene {

/// A file's bytes as they are put together, the same in every locale.
class ByteWriter {
 public:
  std::vector<std::byte> bytes;

  void text(std::string_view text) {
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    bytes.insert(bytes.end(), first, first + text.size());
  }

  /// The shortest text that reads back as this very number: as a float where the number is one.
  void number(double value) {
    std::array<char, 32> buffer;
    const auto narrow = static_cast<float>(value);
    char* const end = static_cast<double>(narrow) == value
                          ? std::to_chars(buffer.data(), buffer.data() + buffer.size(), narrow).ptr
                          : std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    text({buffer.data(), end});
  }

  void whole(std::uint64_t value) {
    std::array<char, 24> buffer;
    text({buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr});
  }

  template <class T>
  void little_endian(T value) {
    auto own = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
    if (std::endian::native != std::endian::little) std::reverse(own.begin(), own.end());
    bytes.insert(bytes.end(), own.begin(), own.end());
  }
};

}  // namespace sweepkit::scene
