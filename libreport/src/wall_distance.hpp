// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "sweepkit/sweep/mesh.hpp"

namespace sweepkit::report {

/// How far a point is from a surface, (u,v) being where on it to look first.
using SurfaceDistance = std::function<double(const glm::dvec3& point, const glm::dvec2& uv)>;

/// Where a triangle is looked at: at the corners of an even grid of this many steps along each side, and then
/// in the worst triangles, this many of them, on a finer grid. The distance to a smooth surface is close to a
/// quadratic over a triangle, so that of its peak at most 1 / steps^2 is missed.
struct WallSampling {
  int steps = 4;
  int fine_steps = 32;
  std::size_t worst = 256;
};

/// The largest distance from a mesh's walls (caps are left out) to the surface.
double wall_distance(const sweep::Mesh& mesh, const SurfaceDistance& distance,
                     const WallSampling& sampling = {});

}  // namespace sweepkit::report
