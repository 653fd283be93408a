// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "sweepkit/sweep/mesh.hpp"

namespace sweepkit::sweep {

/// A surface that is given by its triangles and not by curves, as plain arrays. Every place has one index:
/// triangles that share an edge share two.
struct TriangleSurface {
  std::span<const glm::dvec3> positions;  ///< metres
  std::span<const Triangle> triangles;
  /// By triangle and corner; empty: (0, 0) everywhere.
  std::span<const std::array<glm::vec2, 3>> texcoords;
  /// By triangle and corner, of any length; one without length, and all if this is empty, are found from the
  /// triangles.
  std::span<const std::array<glm::vec3, 3>> normals;
};

struct TriangleSurfaceOptions {
  double crease_deg = 30;  ///< normals break at edges where the surface bends by more, and where it is open
  bool has_half_edges = true;
};

/// The mesh of such a surface. A normal that has to be found is the mean over the triangles that go round the
/// vertex without a crease, weighted by their angles there. Vertices are split where (u,v) or normals differ.
/// Triangles that hang together in (u,v) by edges are an area, and come one after another; all areas together
/// are one sheet of texture. Corners keep their order in the triangle. No grid patches. Throws InputError for
/// a surface larger or smaller than float32 positions can hold, or of more vertices or triangles than 2^30.
/// Preconditions: finite values, indices inside `positions`, at least one triangle.
Mesh mesh_of(const TriangleSurface& surface, const TriangleSurfaceOptions& options = {});

}  // namespace sweepkit::sweep
