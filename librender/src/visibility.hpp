// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "surface_point.hpp"
#include "sweepkit/scene/scene.hpp"
#include "tracer.hpp"

namespace sweepkit::render {

/// Where light falls on a node.
struct LitPoint {
  glm::dvec3 start;   ///< of its shadow rays
  glm::dvec3 normal;  ///< the surface's, unit, on the side that is seen
};

/// The way to a light from a point.
struct ToLight {
  glm::dvec3 direction;  ///< unit; 0 at the light itself
  double distance;
};
ToLight towards(const scene::Light& light, const glm::dvec3& from);

/// What comes of every light to every node of a row, traced with the row.
struct Visibility {
  /// Numbers a share has: 1, or 3 (RGB) where something on the way may let light of a colour through.
  std::size_t channels = 1;
  std::size_t lights = 1;
  std::vector<LitPoint> points;  ///< by node
  /// By node, light and channel: the share of the light that comes, 0 to 1; kTurnedAway where the node is
  /// turned away from the light and no ray was traced.
  std::vector<float> shares;

  void clear();
  std::size_t bytes() const;
};
inline constexpr float kTurnedAway = -1;

/// Traces the shadow rays of a node and appends what they find; one ray a light, kLightSamples to one that
/// has a radius and shows as a disc, `seed` turning them. Returns the number of rays. `normal` is what the
/// node is shaded with: the point's own, or a normal map's. A light that it sees from below the surface's own
/// horizon has a share of 0, since the way there leads through the surface.
std::uint64_t add_visibility(Visibility& visibility, const scene::Scene& scene, const Tracer& tracer,
                             const Hit& hit, const SurfacePoint& point, const glm::dvec3& normal,
                             std::uint64_t seed);

}  // namespace sweepkit::render
