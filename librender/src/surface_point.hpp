// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "ray.hpp"
#include "tracer.hpp"

namespace sweepkit::render {

/// Where a hit lies on the surface, in the world. Both normals are unit and face the side the ray came from.
struct SurfacePoint {
  glm::dvec3 position;
  glm::dvec3 face_normal;     ///< of the triangle
  glm::dvec3 shading_normal;  ///< interpolated
  double error;    ///< metres: moved this far along its normal, `position` is off the triangle for certain
  bool is_inside;  ///< the ray came from the inner side
};

SurfacePoint surface_point(const Tracer& tracer, const Hit& hit, const glm::dvec3& direction);

/// Both as the mesh has them, outwards; unit, where they are not 0.
struct SurfaceNormals {
  glm::dvec3 face;
  glm::dvec3 shading;
};
SurfaceNormals surface_normals(const Tracer& tracer, const Hit& hit);

/// Metres, in the world.
double longest_edge(const Tracer& tracer, const Hit& hit);

/// Did a ray along `direction` meet the triangle on its inner side?
bool is_on_inner_side(const Tracer& tracer, const Hit& hit, const glm::dvec3& direction);

/// The ray that leaves `hit` from `start`, on the surface or above it, for `direction`. It starts off the
/// triangle by the point's error bound, on the side that is seen.
Ray leave_surface(const Hit& hit, const SurfacePoint& point, const glm::dvec3& start,
                  const glm::dvec3& direction);

/// The ray that goes on through the surface at `hit`, for a direction that leads beyond it. It starts as far
/// off the triangle on the other side.
Ray pass_surface(const Hit& hit, const SurfacePoint& point, const glm::dvec3& direction);

/// A start for shadow rays on the smooth surface that the normals stand for, so that a coarse mesh throws no
/// shadow of its facets on itself [Hanika21].
glm::dvec3 smooth_start(const Tracer& tracer, const Hit& hit, const SurfacePoint& point);

}  // namespace sweepkit::render
