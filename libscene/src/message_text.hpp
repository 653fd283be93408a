// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace sweepkit::scene {

/// The user's own words inside a message that has one line: control characters become \u00xx as in JSON, and
/// what is longer than `longest` bytes is cut at a character's start.
inline std::string one_line(std::string_view text, std::size_t longest = std::string_view::npos) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (out.size() >= longest && (byte & 0xC0) != 0x80) return out + "...";
    if (byte < 0x20 || byte == 0x7F) {
      constexpr char kHex[] = "0123456789abcdef";
      out += {'\\', 'u', '0', '0', kHex[byte >> 4], kHex[byte & 15]};
    } else {
      out += c;
    }
  }
  return out;
}

inline std::string in_quotes(std::string_view text) {
  return '"' + one_line(text, 80) + '"';
}

}  // namespace sweepkit::scene
