// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "box_tree.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::render {

/// The hierarchy over all triangles of a mesh, without any search: the grids' leaves and nodes are blocks of
/// their cells; triangles of no grid, pole rows and grids too small lie in order along a space-filling curve.
/// Vertices that are no number count as none.
BoxTree build_box_tree(const scene::MeshView& mesh);

}  // namespace sweepkit::render
