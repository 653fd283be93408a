// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "grid_writer.hpp"

#include <limits>
#include <string>

#include "first_touch.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

void write_triangles(std::vector<Triangle>& triangles, const GridPatch& patch) {
  Triangle* out = triangles.data() + patch.first_triangle;
  for (std::uint32_t row = 0; row < patch.rows; ++row) {
    const bool has_lower = !(patch.has_first_pole && row == 0);
    const bool has_upper = !(patch.has_last_pole && row + 1 == patch.rows);
    for (std::uint32_t column = 0; column < patch.columns; ++column) {
      const std::uint32_t q = patch.vertex(column + 1, row);
      const std::uint32_t r = patch.vertex(column, row + 1);
      if (has_lower) *out++ = {r, q - 1, q};
      if (has_upper) *out++ = {q, r + 1, r};
    }
  }
}

}  // namespace

std::vector<Run> split_runs(const std::vector<bool>& breaks) {
  std::vector<Run> runs;
  std::size_t first = 0;
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    if (breaks[i] || i + 1 == breaks.size()) {
      runs.push_back({first, i});
      first = i;
    }
  }
  return runs;
}

void lay_out_wall(Mesh& mesh, const std::vector<Run>& column_runs, const std::vector<Run>& row_runs,
                  const Poles& poles, glm::dvec2 period) {
  Area area;
  area.first_triangle = static_cast<std::uint32_t>(mesh.triangles.size());
  area.u_period = period.x;
  area.v_period = period.y;
  std::size_t vertices = mesh.n_vertices();
  std::size_t triangles = mesh.triangles.size();
  const std::size_t first_patch = mesh.patches.size();
  for (const Run& rows : row_runs) {
    for (std::size_t run = 0; run < column_runs.size(); ++run) {
      const Run& columns = column_runs[run];
      GridPatch patch;
      patch.first_vertex = static_cast<std::uint32_t>(vertices);
      patch.first_triangle = static_cast<std::uint32_t>(triangles);
      patch.columns = static_cast<std::uint32_t>(columns.last - columns.first);
      patch.rows = static_cast<std::uint32_t>(rows.last - rows.first);
      patch.has_first_pole = poles[run][rows.first];
      patch.has_last_pole = poles[run][rows.last];
      patch.area = static_cast<std::uint32_t>(mesh.areas.size());
      if (patch.rows == 1 && patch.has_first_pole && patch.has_last_pole)
        continue;  // on the axis, or pressed to a line: no surface
      vertices += patch.vertex_count();
      triangles += patch.triangle_count();
      mesh.patches.push_back(patch);
      check_triangle_count(triangles);
    }
  }
  add_vertices(mesh, vertices - mesh.n_vertices());
  area.triangle_count = static_cast<std::uint32_t>(triangles - mesh.triangles.size());
  resize_to_fill(mesh.triangles, triangles);
  for (std::size_t i = first_patch; i < mesh.patches.size(); ++i)
    write_triangles(mesh.triangles, mesh.patches[i]);
  mesh.areas.push_back(area);
}

std::uint32_t add_vertices(Mesh& mesh, std::size_t count) {
  const auto first = static_cast<std::uint32_t>(mesh.n_vertices());
  if (count > 0) {
    // OpenMesh keeps its vectors to itself: with one vertex more the room reserved behind it can be seen.
    mesh.reserve(first + count, mesh.n_edges(), mesh.n_faces());
    mesh.resize(first + 1, mesh.n_edges(), mesh.n_faces());
    prepare_first_touch(mesh.positions().data() + first, count * sizeof(glm::vec3));
    prepare_first_touch(mesh.normals().data() + first, count * sizeof(glm::vec3));
    prepare_first_touch(mesh.texcoords().data() + first, count * sizeof(glm::vec2));
  }
  mesh.resize(first + count, mesh.n_edges(), mesh.n_faces());
  return first;
}

}  // namespace sweepkit::sweep
