// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "intersection_tree.hpp"
#include "ray_differential.hpp"
#include "sweepkit/render/render.hpp"
#include "sweepkit/scene/plan.hpp"
#include "sweepkit/scene/scene.hpp"
#include "sweepkit/texmap/footprint.hpp"
#include "sweepkit/texmap/procedural.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"
#include "tracer.hpp"

namespace sweepkit::render {

/// By Scene::textures; none where the texture is computed, or not used.
using Samplers = std::vector<std::optional<texmap::TextureSampler>>;

/// The rows that the filter sees: above, the row itself, below. Where nothing is filtered all three are the
/// row itself.
using RowWindow = std::array<const TreeRow*, 3>;

struct ShadingCounts {
  std::uint64_t shadow_rays = 0;
  std::uint64_t nodes = 0;
  std::uint64_t textured = 0;
  std::uint64_t filtered = 0;
  std::uint64_t differentials = 0;
};

/// Shades a pixel's tree from its deepest node up (the paper's 3.2.2).
class Shader {
 public:
  Shader(const scene::Scene& scene, const scene::Plan& plan, const Tracer& tracer, const Samplers& samplers,
         texmap::Filter filter, Footprint footprint)
      : scene_(scene),
        tracer_(tracer),
        samplers_(samplers),
        filter_(filter),
        footprint_(footprint),
        looks_round_(plan.needs_part(scene::Part::kFilteredNodes)),
        uses_differentials_(plan.needs_part(scene::Part::kDifferentials) &&
                            footprint != Footprint::kNeighbours) {}

  /// Pixel (x, y), whose eye ray is one of `eye_rays`.
  glm::dvec3 pixel(const RowWindow& rows, const EyeRays& eye_rays, int x, int y, texmap::FilterThread& filter,
                   ShadingCounts& counts) const;

 private:
  // The nodes of the same path in the 3 x 3 pixels about one, [1][1] the pixel's own; below 0 where there is
  // none.
  using Neighbourhood = std::array<std::array<std::int32_t, 3>, 3>;

  // How a node was reached: from which one, or from the eye through which pixel.
  struct Path {
    const TreeNode* node;
    const Path* from;
    const EyeRays* eye_rays;
    int x;
    int y;
  };

  glm::dvec3 node(const RowWindow& rows, const Neighbourhood& nodes, const Path& path,
                  texmap::FilterThread& filter, ShadingCounts& counts) const;
  glm::dvec3 diffuse(const RowWindow& rows, const Neighbourhood& nodes, const Path& path,
                     const scene::Material& material, texmap::FilterThread& filter,
                     ShadingCounts& counts) const;
  // Of the ray that the path ends with. No further ray is traced.
  RayDifferential differential(const Path& path) const;
  HitDifferential moved_hit(const Path& path) const;
  // The neighbour's node in its row, if it lies on the same piece of the same object.
  static std::optional<std::size_t> on_same_piece(const RowWindow& rows, const Neighbourhood& nodes,
                                                  std::size_t r, std::size_t c);
  std::optional<glm::vec3> filtered(const RowWindow& rows, const Neighbourhood& nodes,
                                    const texmap::TextureSampler& sampler,
                                    texmap::FilterThread& filter) const;
  // Where a node lies in the space that a procedural texture is on, and what its pixel covers there, by the
  // pixels beside it; none where they do not tell.
  glm::dvec3 pattern_place(const TreeRow& row, std::size_t node, texmap::ProceduralOn on) const;
  std::optional<texmap::PatternFootprint> pattern_footprint(const RowWindow& rows, const Neighbourhood& nodes,
                                                            texmap::ProceduralOn on) const;
  glm::dvec3 local_light(const TreeNode& at, const scene::Material& material, const glm::dvec3& diffuse,
                         ShadingCounts& counts) const;

  const scene::Scene& scene_;
  const Tracer& tracer_;
  const Samplers& samplers_;
  texmap::Filter filter_;
  Footprint footprint_;
  bool looks_round_;         // are footprints made from neighbours?
  bool uses_differentials_;  // and from the rays' derivatives?
};

}  // namespace sweepkit::render
