// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "text_file.hpp"

#include <algorithm>
#include <array>
#include <fstream>

namespace sweepkit::scene {

std::string read_text_file(const std::filesystem::path& file, std::size_t most, const std::string& kind) {
  const Place place{.file = file.string()};
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw InputError(place, "is a folder, not " + kind);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    const bool exists = std::filesystem::exists(file, ignored);
    throw InputError(place, exists ? "cannot be read; check its permissions" : "no such file");
  }
  // Counted as it comes, since a device or a pipe does not tell its size.
  std::string text;
  std::array<char, 65536> block;
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > most) {
      throw InputError(place, "is over " + std::to_string(most >> 20) + " MiB, too large for " + kind);
    }
  }
  if (stream.bad()) throw InputError(place, "cannot be read to its end");
  return text;
}

Place place_in(std::string_view text, std::size_t offset, const std::string& file) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return {.file = file,
          .line = static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
          .column = static_cast<int>(before.size() - line_start) + 1};
}

}  // namespace sweepkit::scene
