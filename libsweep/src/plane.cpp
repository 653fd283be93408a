// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "float_positions.hpp"
#include "grid_writer.hpp"
#include "half_edges.hpp"
#include "number_text.hpp"
#include "stations.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/sweep/sweep.hpp"
#include "texture_repeats.hpp"

namespace sweepkit::sweep {

Mesh plane(glm::dvec2 size, const PlaneOptions& options) {
  check_cells(options.tessellation.contour, "x");
  check_cells(options.tessellation.trajectory, "z");
  check_tolerance(options.tessellation.tolerance);
  check_texture(options.uv);
  if (!(size.x > 0 && size.y > 0) || !std::isfinite(size.x) || !std::isfinite(size.y)) {
    throw InputError("size needs to be above 0 m both ways, got " + number_text(size.x) + " x " +
                     number_text(size.y));
  }
  const auto columns = static_cast<std::size_t>(options.tessellation.contour);
  const auto rows = static_cast<std::size_t>(options.tessellation.trajectory);
  const glm::dvec2 repeat = with_repeats(options.uv, {size.x, false}, {size.y, false}).repeat;
  Mesh mesh;
  lay_out_wall(mesh, {{0, columns}}, {{0, rows}}, {std::vector<bool>(rows + 1, false)}, glm::dvec2(0.0));
  std::size_t vertex = 0;
  for (std::size_t j = 0; j <= rows; ++j) {
    const double v = static_cast<double>(j) / static_cast<double>(rows);
    for (std::size_t i = 0; i <= columns; ++i, ++vertex) {
      const double u = static_cast<double>(i) / static_cast<double>(columns);
      mesh.positions()[vertex] = glm::vec3(glm::dvec3((u - 0.5) * size.x, 0, (0.5 - v) * size.y));
      mesh.normals()[vertex] = {0, 1, 0};
      mesh.texcoords()[vertex] = glm::vec2(glm::dvec2(u, v) * repeat);
    }
  }
  if (options.tessellation.tolerance) {
    mesh.deviation = float_error({{-0.5 * size.x, 0, -0.5 * size.y}, {0.5 * size.x, 0, 0.5 * size.y}});
  }
  if (options.has_half_edges) write_half_edges(mesh);
  return mesh;
}

}  // namespace sweepkit::sweep
