// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/bake_over.hpp"

namespace sweepkit::scene {

texmap::BakedTexture bake_over(const MeshView& mesh, const texmap::Texture& texture,
                               const texmap::BakeOptions& options) {
  const std::vector<std::uint32_t> ends = sheet_ends(mesh);
  std::vector<glm::dvec2> periods;
  periods.reserve(ends.size());
  for (const sweep::Area& area : mesh.areas) {
    if (!area.continues_sheet || periods.empty()) periods.emplace_back(area.u_period, area.v_period);
  }
  return texmap::bake(texture, {mesh.positions, mesh.texcoords, mesh.triangles, ends, mesh.origin, periods},
                      options);
}

std::vector<glm::vec2> baked_texcoords(const MeshView& mesh,
                                       std::span<const texmap::UvTransform> transforms) {
  std::vector<glm::vec2> texcoords(mesh.texcoords.begin(), mesh.texcoords.end());
  if (transforms.empty()) return texcoords;
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
  return texcoords;
}

}  // namespace sweepkit::scene
