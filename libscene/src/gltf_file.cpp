// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_file.hpp"

#include <cstdint>
#include <fstream>
#include <span>
#include <sstream>

#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

using Bytes = std::span<const unsigned char>;

std::uint32_t little_endian(Bytes bytes, std::size_t at) {
  return bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16 |
         static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

}  // namespace

std::string read_whole_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw InputError({.file = file.string()}, "is a folder");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError({.file = file.string()}, "no such file, or it cannot be read");
  std::ostringstream text;
  text << stream.rdbuf();
  return std::move(text).str();
}

// A .glb: header, JSON chunk, and at most one binary chunk.
GltfChunks split_gltf(std::string content, const std::string& name) {
  if (content.compare(0, 4, "glTF") != 0) return {std::move(content), {}};
  const Bytes bytes(reinterpret_cast<const unsigned char*>(content.data()), content.size());
  const auto fail = [&](const std::string& problem) { throw InputError({.file = name}, problem); };
  if (bytes.size() < 20)
    fail("is cut short: a .glb has at least 20 bytes, got " + std::to_string(bytes.size()));
  if (little_endian(bytes, 4) != 2)
    fail("is glTF version " + std::to_string(little_endian(bytes, 4)) + ", not 2");
  const std::size_t length = little_endian(bytes, 8);
  if (length > bytes.size()) {
    fail("is cut short: it should have " + std::to_string(length) + " bytes, got " +
         std::to_string(bytes.size()));
  }
  const std::size_t json_length = little_endian(bytes, 12);
  if (json_length > bytes.size() - 20) fail("its JSON chunk reaches past the end of the file");
  GltfChunks chunks{content.substr(20, json_length), {}};
  const std::size_t next = 20 + json_length;
  if (next + 8 <= bytes.size()) {
    const std::size_t binary_length = little_endian(bytes, next);
    if (binary_length > bytes.size() - next - 8) fail("its binary chunk reaches past the end of the file");
    chunks.binary = content.substr(next + 8, binary_length);
  }
  return chunks;
}

}  // namespace sweepkit::scene
