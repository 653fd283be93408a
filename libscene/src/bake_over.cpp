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

}  // namespace sweepkit::scene
