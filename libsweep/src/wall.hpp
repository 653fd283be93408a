// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "grid_writer.hpp"
#include "morph.hpp"
#include "rows.hpp"
#include "spine.hpp"
#include "sweepkit/sweep/mesh.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::sweep {

/// What one outline sweeps.
struct Wall {
  Morph morph;
  std::vector<Run> column_runs;
  /// A closed trajectory's last row is its first one's vertices, so many columns on.
  std::size_t closing_columns = 0;
};

/// Appends the vertices and triangles of a wall as an area of its own. `mesh.origin` is set.
void add_wall(Mesh& mesh, const Wall& wall, const Spine& spine, const UvOptions& uv);

}  // namespace sweepkit::sweep
