// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "text_file.hpp"

#include <array>
#include <fstream>

#include "sweepkit/error.hpp"

namespace sweepkit::scene {

std::string read_text_file(const std::filesystem::path& file, const std::string& kind) {
  constexpr std::size_t kLargest = std::size_t{256} << 20;
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
    if (text.size() > kLargest) throw InputError(place, "is over 256 MiB, too large for " + kind);
  }
  if (stream.bad()) throw InputError(place, "cannot be read to its end");
  return text;
}

}  // namespace sweepkit::scene
