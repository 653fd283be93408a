// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/sweep/mesh.hpp"

namespace sweepkit::sweep {

/// Writes OpenMesh's faces, edges and half-edges for the whole triangle list. Grid patches are written by
/// closed-form indices, without a search; the triangles of caps, and of surfaces that are no grid, by
/// matching their edges, area by area. No patch or area without one shares a vertex with another.
/// Precondition: the mesh has no faces yet.
void write_half_edges(Mesh& mesh);

}  // namespace sweepkit::sweep
