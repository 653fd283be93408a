// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string_view>

namespace sweepkit::scene {

/// The number of type T that begins at byte `at`, first byte lowest, or last byte lowest. Precondition: it
/// ends inside.
template <class T>
T from_bytes(std::string_view bytes, std::size_t at, std::endian order) {
  std::array<char, sizeof(T)> own;
  std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), sizeof(T), own.begin());
  if (order != std::endian::native) std::reverse(own.begin(), own.end());
  return std::bit_cast<T>(own);
}

template <class T>
T little_endian(std::string_view bytes, std::size_t at) {
  return from_bytes<T>(bytes, at, std::endian::little);
}

}  // namespace sweepkit::scene
