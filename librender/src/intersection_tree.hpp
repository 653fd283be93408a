// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "eye_rays.hpp"
#include "normal_maps.hpp"
#include "ray.hpp"
#include "ray_differential.hpp"
#include "scattering.hpp"
#include "surface_point.hpp"
#include "sweepkit/scene/plan.hpp"
#include "sweepkit/scene/scene.hpp"
#include "tracer.hpp"
#include "visibility.hpp"

namespace sweepkit::render {

/// No node: the ray escaped to the background, or was not traced: the depth ended, nothing goes that way, or
/// the other child stands for both.
inline constexpr std::int32_t kEscaped = -1;
inline constexpr std::int32_t kNotTraced = -2;

/// A hit of a pixel's intersection tree (the paper's 3.2.1, Fig. 3): object, point, and the ray's direction.
struct TreeNode {
  Hit hit;
  glm::dvec3 direction;
  std::uint32_t area = 0;        ///< of the object's mesh: one piece of texture
  std::uint32_t medium = kNone;  ///< the object that the ray ran inside of on its way here; kNone: air
};

/// Intersection trees, one for each of the places that eye rays go through: those of a row of pixels, with
/// some more at either end (the filter's border) where something is filtered, or the samples of a pixel.
/// Nodes lie flat, parents before children, and link by index: reflection grows one way, refraction the
/// other. (u,v), links, shares and visibility have their arrays only where the plan needs them. The storage
/// is used again from row to row.
struct TreeRow {
  int first_pixel = 0;
  std::vector<glm::dvec2> places;   ///< of the picture, in pixels
  std::vector<std::int32_t> roots;  ///< node or kEscaped
  std::vector<TreeNode> nodes;
  std::vector<glm::dvec2> texcoords;
  std::vector<std::int32_t> reflections;  ///< by node: node, kEscaped or kNotTraced
  std::vector<std::int32_t> refractions;
  std::vector<Shares> shares;  ///< of the children; without them a material's `reflect`
  Visibility visibility;
  std::vector<glm::dvec3> normals;  ///< with normal maps: what each node is shaded with (NormalMaps)
  std::vector<RayDifferential> differentials;  ///< with normal maps: of the rays that arrive

  std::int32_t root(int x) const { return roots[static_cast<std::size_t>(x - first_pixel)]; }
  std::int32_t reflection(std::int32_t node) const {
    return reflections.empty() ? kNotTraced : reflections[static_cast<std::size_t>(node)];
  }
  std::int32_t refraction(std::int32_t node) const {
    return refractions.empty() ? kNotTraced : refractions[static_cast<std::size_t>(node)];
  }
  std::size_t bytes() const;
  std::size_t normal_bytes() const;
};

/// A node whose share of the pixel would be split into one below this and another is not split: the larger
/// part goes on with both shares. Two hundred and fifty-six such parts make a level of 8 bits in light of 1,
/// no light is lost, and a pixel's tree has no more than 2 / kLeastWeight leaves however deep it may grow.
inline constexpr double kLeastWeight = 1.0 / 65536;

/// Rays by kind.
struct RayCounts {
  std::uint64_t eye = 0;
  std::uint64_t reflected = 0;
  std::uint64_t refracted = 0;
  std::uint64_t shadow = 0;
  std::uint64_t texcoords = 0;
  std::uint64_t shares = 0;   ///< nodes whose shares were worked out
  std::uint64_t normals = 0;  ///< looked up in normal maps

  void add(const RayCounts& other);
};

/// Fills rows of trees.
class TreeBuilder {
 public:
  /// `maps` where the plan needs normal maps.
  TreeBuilder(const scene::Scene& scene, const scene::Plan& plan, const Tracer& tracer,
              const NormalMaps* maps = nullptr);

  /// Pixels first..end-1 of row y. `filter` is for normal maps alone.
  void build(TreeRow& row, const EyeRays& eye_rays, int y, int first, int end, RayCounts& counts,
             texmap::FilterThread* filter = nullptr) const;
  /// The trees of row.places, each for a square of `side` pixels.
  void build(TreeRow& row, const EyeRays& eye_rays, RayCounts& counts, texmap::FilterThread* filter = nullptr,
             double side = 1) const;

  /// (u,v) of a hit. Precondition: its mesh has any.
  glm::dvec2 texcoord_of(const Hit& hit) const;

 private:
  /// A node that waits for its children, and its share of the pixel.
  struct Pending {
    std::int32_t node;
    int level;
    double weight;
    SurfacePoint point;  ///< the normal of a normal map in place of the interpolated one
  };
  /// What all nodes of a row's building share.
  struct Growth {
    std::vector<Pending>& pending;
    RayCounts& counts;
    texmap::FilterThread* filter;
  };

  std::int32_t add_node(TreeRow& row, const Hit& hit, const Ray& ray, std::uint32_t medium,
                        RayCounts& counts) const;
  // Goes on from a root: all that follows, and the light that falls on it.
  void grow(TreeRow& row, std::int32_t root, std::uint64_t seed, const Growth& growth) const;
  // Lights a node, the last one, and makes it wait if it has children.
  void visit(TreeRow& row, std::int32_t node, int level, double weight, std::uint64_t seed,
             const Growth& growth) const;
  void add_children(TreeRow& row, const Pending& parent, std::uint64_t seed, const Growth& growth) const;
  // What the node is shaded with: its normal map's, which it keeps, or the surface's own.
  glm::dvec3 normal_of(TreeRow& row, std::int32_t node, const SurfacePoint& point,
                       const Growth& growth) const;
  std::uint32_t area_of(const Hit& hit) const;

  const scene::Scene& scene_;
  const Tracer& tracer_;
  const NormalMaps* maps_;
  bool needs_texcoords_;
  bool leaves_out_;  // (u,v) of what has no texture
  bool needs_trees_;
  bool needs_refractions_;
  bool needs_shares_;
  bool needs_shadows_;
};

}  // namespace sweepkit::render
