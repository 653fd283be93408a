// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_arrays.hpp"

#include <string_view>

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
  std::vector<glm::vec2> texcoords(mesh.texcoords.begin(), mesh.texcoords.end());
  const std::vector<std::uint32_t> ends = sheet_ends(mesh);
  std::uint32_t first = 0;
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    const auto& [scale, offset] = transforms[i];
    // A vertex belongs to one area but to several triangles: each is taken from the mesh's own (u,v).
    for (const sweep::Triangle& triangle : mesh.triangles.subspan(first, ends[i] - first)) {
      for (const std::uint32_t vertex : triangle) {
        texcoords[vertex] = glm::vec2(offset + scale * glm::dvec2(mesh.texcoords[vertex]));
      }
    }
    first = ends[i];
  }
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
