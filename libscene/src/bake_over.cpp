// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/bake_over.hpp"

namespace sweepkit::scene {

texmap::BakedTexture bake_over(const MeshView& mesh, const texmap::Texture& texture,
                               const texmap::BakeOptions& options) {
  std::vector<std::uint32_t> area_ends;
  std::vector<glm::dvec2> periods;
  area_ends.reserve(mesh.areas.size());
  periods.reserve(mesh.areas.size());
  for (const sweep::Area& area : mesh.areas) {
    area_ends.push_back(area.first_triangle + area.triangle_count);
    periods.emplace_back(area.u_period, area.v_period);
  }
  return texmap::bake(
      texture, {mesh.positions, mesh.texcoords, mesh.triangles, area_ends, mesh.origin, periods}, options);
}

}  // namespace sweepkit::scene
