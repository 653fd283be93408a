// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "rows.hpp"
#include "section.hpp"
#include "sweepkit/sweep/mesh.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::sweep {

/// Which end of a trajectory.
enum class End { kFirst, kLast };

/// Where a dome stands and how high it is.
struct Dome {
  glm::dvec2 middle;
  double height;
};

/// The dome over a closed section: over its centroid, as high as the outline's mean distance from that (a
/// hemisphere over a circle). The finer the section, the nearer to what its contour asks for.
Dome dome_over(const Section& section, const Row& row);

/// Closes a closed section with a dome in `rows` rows of cells, an area of its own whose u is the wall's and
/// whose v runs from 0 to 1 along the trajectory. Its ring has the bits of the wall's.
void add_round_cap(Mesh& mesh, const Section& section, const Row& row, End end, const Dome& dome,
                   std::uint32_t rows, const UvOptions& uv);

}  // namespace sweepkit::sweep
