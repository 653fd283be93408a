// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "cap_writer.hpp"

#include <algorithm>
#include <vector>

#include "cap.hpp"
#include "grid_writer.hpp"

namespace sweepkit::sweep {

void add_cap(Mesh& mesh, const Section& section, const CapPlane& plane, bool is_mirrored) {
  std::vector<glm::dvec2> outline;
  for (std::size_t i = 0; i + 1 < section.points.size(); ++i) outline.push_back(section.points[i].position);
  glm::dvec2 low = outline.front();
  glm::dvec2 high = low;
  for (const glm::dvec2& p : outline) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double size = std::max(high.x - low.x, high.y - low.y);

  const std::uint32_t first = add_vertices(mesh, outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2& p = outline[i];
    const glm::dvec3 position = plane.center + p.x * plane.x_axis + p.y * plane.y_axis;
    mesh.positions()[first + i] = glm::vec3(position - mesh.origin);
    mesh.normals()[first + i] = glm::vec3(plane.normal);
    // u runs the other way on a mirrored cap, so that no texture is mirrored.
    const double u = (is_mirrored ? high.x - p.x : p.x - low.x) / size;
    mesh.texcoords()[first + i] = {static_cast<float>(u), static_cast<float>((p.y - low.y) / size)};
  }

  Area area;
  area.first_triangle = static_cast<std::uint32_t>(mesh.triangles.size());
  for (const Triangle& t : triangulate_polygon(outline)) {
    mesh.triangles.push_back(is_mirrored ? Triangle{first + t[0], first + t[2], first + t[1]}
                                         : Triangle{first + t[0], first + t[1], first + t[2]});
  }
  area.triangle_count = static_cast<std::uint32_t>(mesh.triangles.size()) - area.first_triangle;
  mesh.areas.push_back(area);
}

}  // namespace sweepkit::sweep
