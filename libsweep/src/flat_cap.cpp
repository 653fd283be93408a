// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "flat_cap.hpp"

#include <algorithm>
#include <vector>

#include "grid_writer.hpp"
#include "triangulate.hpp"

namespace sweepkit::sweep {

void add_flat_cap(Mesh& mesh, std::span<const Section> piece, const CapPlane& plane, bool is_mirrored) {
  std::vector<std::vector<glm::dvec2>> outlines;
  outlines.reserve(piece.size());
  std::size_t count = 0;
  for (const Section& section : piece) {
    outlines.push_back(outline_of(section));
    count += outlines.back().size();
  }
  glm::dvec2 low = outlines.front().front();
  glm::dvec2 high = low;
  for (const glm::dvec2& p : outlines.front()) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double size = std::max(high.x - low.x, high.y - low.y);

  const std::uint32_t first = add_vertices(mesh, count);
  std::size_t vertex = first;
  for (const std::vector<glm::dvec2>& outline : outlines) {
    for (const glm::dvec2& p : outline) {
      const glm::dvec3 position = plane.center + p.x * plane.x_axis + p.y * plane.y_axis;
      mesh.positions()[vertex] = glm::vec3(position - mesh.origin);
      mesh.normals()[vertex] = glm::vec3(plane.normal);
      // u runs the other way on a mirrored cap, so that no texture is mirrored.
      const double u = (is_mirrored ? high.x - p.x : p.x - low.x) / size;
      mesh.texcoords()[vertex] = {static_cast<float>(u), static_cast<float>((p.y - low.y) / size)};
      ++vertex;
    }
  }

  Area area;
  area.first_triangle = static_cast<std::uint32_t>(mesh.triangles.size());
  for (const Triangle& t : triangulate_region(outlines)) {
    mesh.triangles.push_back(is_mirrored ? Triangle{first + t[0], first + t[2], first + t[1]}
                                         : Triangle{first + t[0], first + t[1], first + t[2]});
  }
  area.triangle_count = static_cast<std::uint32_t>(mesh.triangles.size()) - area.first_triangle;
  mesh.areas.push_back(area);
}

void add_flat_caps(Mesh& mesh, std::span<const Section> sections, std::span<const std::size_t> outer_of,
                   const CapPlane& plane, bool is_mirrored) {
  for (std::size_t outer = 0; outer < sections.size(); ++outer) {
    if (outer_of[outer] != outer) continue;
    std::vector<Section> piece = {sections[outer]};
    for (std::size_t i = 0; i < sections.size(); ++i) {
      if (i != outer && outer_of[i] == outer) piece.push_back(sections[i]);
    }
    add_flat_cap(mesh, piece, plane, is_mirrored);
  }
}

}  // namespace sweepkit::sweep
