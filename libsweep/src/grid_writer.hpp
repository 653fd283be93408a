// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stations.hpp"
#include "sweepkit/sweep/mesh.hpp"

namespace sweepkit::sweep {

/// Stations first..last between two breaks of the normal.
struct Run {
  std::size_t first;
  std::size_t last;
};

/// Splits stations 0..count-1 at those where `breaks[i]` is set (ends excepted).
std::vector<Run> split_runs(const std::vector<bool>& breaks);

/// Which rows of a wall are poles: for every run of columns a flag a row. A row run begins or ends there.
using Poles = std::vector<std::vector<bool>>;

/// Lays out the patches of a wall (every row run with every column run) behind what the mesh holds, as one
/// area, and writes their triangles. The vertices are left for the caller to write.
void lay_out_wall(Mesh& mesh, const std::vector<Run>& column_runs, const std::vector<Run>& row_runs,
                  const Poles& poles, glm::dvec2 period);

/// Visits the rows of vertices of a wall laid out so, in their order: `visit(first vertex, index of the
/// column run, row, first column, last column, does the row begin its run)`.
template <class Visit>
void for_each_wall_row(std::uint32_t first_vertex, const std::vector<Run>& column_runs,
                       const std::vector<Run>& row_runs, const Poles& poles, Visit&& visit) {
  std::size_t vertex = first_vertex;
  for (const Run& rows : row_runs) {
    for (std::size_t run = 0; run < column_runs.size(); ++run) {
      const std::vector<bool>& pole_rows = poles[run];
      if (rows.last - rows.first == 1 && pole_rows[rows.first] && pole_rows[rows.last]) continue;
      for (std::size_t j = rows.first; j <= rows.last; ++j) {
        // A pole row has a vertex a triangle (GridPatch).
        const std::size_t first = column_runs[run].first + (pole_rows[j] && j == rows.first ? 1 : 0);
        const std::size_t last = column_runs[run].last - (pole_rows[j] && j == rows.last ? 1 : 0);
        visit(vertex, run, j, first, last, j == rows.first);
        vertex += last - first + 1;
      }
    }
  }
}

/// Room for more vertices behind those the mesh has; the edges are left alone. Returns the first new vertex.
std::uint32_t add_vertices(Mesh& mesh, std::size_t count);

}  // namespace sweepkit::sweep
