// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::scene {

std::vector<std::uint32_t> sheet_ends(const MeshView& mesh) {
  std::vector<std::uint32_t> ends;
  for (const sweep::Area& area : mesh.areas) {
    if (!area.continues_sheet || ends.empty()) ends.emplace_back();
    ends.back() = area.first_triangle + area.triangle_count;
  }
  return ends;
}

}  // namespace sweepkit::scene
