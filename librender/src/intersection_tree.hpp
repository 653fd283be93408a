// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "eye_rays.hpp"
#include "ray.hpp"
#include "sweepkit/scene/plan.hpp"
#include "sweepkit/scene/scene.hpp"
#include "tracer.hpp"
#include "visibility.hpp"

namespace sweepkit::render {

/// No node: the ray escaped to the background, or was not traced because the depth ended.
inline constexpr std::int32_t kEscaped = -1;
inline constexpr std::int32_t kNotTraced = -2;

/// A hit of a pixel's intersection tree (the paper's 3.2.1, Fig. 3): object, point, and the ray's direction.
struct TreeNode {
  Hit hit;
  glm::dvec3 direction;
  std::uint32_t area = 0;  ///< of the object's mesh: one piece of texture
};

/// Where the tree goes on: reflection grows one way, refraction the other (its shading is not built yet).
struct TreeLinks {
  std::int32_t reflection = kNotTraced;
  std::int32_t refraction = kNotTraced;
};

/// Intersection trees, one for each of the places that eye rays go through: those of a row of pixels, with
/// some more at either end (the filter's border) where something is filtered, or the samples of a few pixels.
/// Nodes lie flat, parents before children, and link by index; (u,v), links and visibility have their arrays
/// only where the plan needs them. The storage is used again from row to row.
struct TreeRow {
  int first_pixel = 0;
  std::vector<glm::dvec2> places;   ///< of the picture, in pixels
  std::vector<std::int32_t> roots;  ///< node or kEscaped
  std::vector<TreeNode> nodes;
  std::vector<glm::dvec2> texcoords;
  std::vector<TreeLinks> links;
  Visibility visibility;

  std::int32_t root(int x) const { return roots[static_cast<std::size_t>(x - first_pixel)]; }
  std::int32_t reflection(std::int32_t node) const {
    return links.empty() ? kNotTraced : links[static_cast<std::size_t>(node)].reflection;
  }
  std::size_t bytes() const;
};

/// Rays by kind.
struct RayCounts {
  std::uint64_t eye = 0;
  std::uint64_t reflected = 0;
  std::uint64_t shadow = 0;
  std::uint64_t texcoords = 0;
};

/// Fills rows of trees.
class TreeBuilder {
 public:
  TreeBuilder(const scene::Scene& scene, const scene::Plan& plan, const Tracer& tracer);

  /// Pixels first..end-1 of row y.
  void build(TreeRow& row, const EyeRays& eye_rays, int y, int first, int end, RayCounts& counts) const;
  /// The trees of row.places.
  void build(TreeRow& row, const EyeRays& eye_rays, RayCounts& counts) const;

 private:
  // Goes on from a root: what it mirrors, and the light that falls on all of it.
  void grow(TreeRow& row, std::int32_t root, std::uint64_t seed, RayCounts& counts) const;
  std::int32_t add_node(TreeRow& row, const Hit& hit, const Ray& ray, RayCounts& counts) const;
  std::uint32_t area_of(const Hit& hit) const;
  glm::dvec2 texcoord_of(const Hit& hit) const;

  const scene::Scene& scene_;
  const Tracer& tracer_;
  bool needs_texcoords_;
  bool needs_trees_;
  bool needs_shadows_;
};

}  // namespace sweepkit::render
