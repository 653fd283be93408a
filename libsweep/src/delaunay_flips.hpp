// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "sweepkit/sweep/grid_patch.hpp"

namespace sweepkit::sweep {

/// Turns inner edges of a triangulation round until the angles against each are as wide as its outline
/// allows: the constrained Delaunay triangulation, whose triangles are the fattest there are.
void flip_to_delaunay(std::span<const glm::dvec2> points, std::vector<Triangle>& triangles);

}  // namespace sweepkit::sweep
