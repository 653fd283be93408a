// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_arrays.hpp"

#include <string_view>

#include "sweepkit/scene/bake_over.hpp"

namespace sweepkit::scene {

std::vector<std::uint16_t> short_indices(std::span<const sweep::Triangle> triangles) {
  std::vector<std::uint16_t> indices;
  indices.reserve(3 * triangles.size());
  for (const sweep::Triangle& triangle : triangles) {
    for (const std::uint32_t index : triangle) indices.push_back(static_cast<std::uint16_t>(index));
  }
  return indices;
}

std::vector<glm::vec2> gltf_texcoords(const MeshView& mesh, std::span<const texmap::UvTransform> transforms) {
  std::vector<glm::vec2> texcoords = baked_texcoords(mesh, transforms);
  for (glm::vec2& uv : texcoords) uv.y = 1 - uv.y;
  return texcoords;
}

std::string percent_encoded(const std::string& name) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~";
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string out;
  for (const char c : name) {
    if (kPlain.find(c) != std::string_view::npos) {
      out += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      out += {'%', kHex[byte >> 4], kHex[byte & 15]};
    }
  }
  return out;
}

}  // namespace sweepkit::scene
