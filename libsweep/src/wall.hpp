// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "grid_writer.hpp"
#include "morph.hpp"
#include "rows.hpp"
#include "sweepkit/sweep/mesh.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::sweep {

/// The rows of a sweep, which all its outlines share.
struct Spine {
  std::vector<Row> rows;
  std::vector<bool> breaks;  ///< of the normal, a row
  std::vector<bool> poles;
  std::vector<double> shares;  ///< of the trajectory's length
  std::vector<double> v;       ///< 0 to 1
  std::vector<Run> runs;
  double length = 0;  ///< of the trajectory
  bool is_closed = false;
};

/// What one outline sweeps.
struct Wall {
  Morph morph;
  std::vector<Run> column_runs;
  /// A closed trajectory's last row is its first one's vertices, so many columns on.
  std::size_t closing_columns = 0;
};

glm::dvec3 position_of(const Row& row, const glm::dvec2& p);

/// Appends the vertices and triangles of a wall as an area of its own. `mesh.origin` is set.
void add_wall(Mesh& mesh, const Wall& wall, const Spine& spine, const UvOptions& uv);

}  // namespace sweepkit::sweep
