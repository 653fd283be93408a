// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "environment.hpp"
#include "neighbourhood.hpp"
#include "sweepkit/scene/plan.hpp"
#include "sweepkit/scene/scene.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"
#include "texture_lookup.hpp"
#include "tracer.hpp"

namespace sweepkit::render {

struct ShadingCounts {
  std::uint64_t shadow_rays = 0;
  std::uint64_t nodes = 0;
  std::uint64_t environment_lookups = 0;
  LookupCounts lookups;
};

/// Shades a pixel's tree from its deepest node up (the paper's 3.2.2).
class Shader {
 public:
  Shader(const scene::Scene& scene, const scene::Plan& plan, const Tracer& tracer,
         const TextureLookup& textures, const Environment& environment)
      : scene_(scene),
        tracer_(tracer),
        textures_(textures),
        environment_(environment),
        looks_round_(plan.needs_part(scene::Part::kFilteredNodes)) {}

  /// Pixel (x, y), whose eye ray is one of `eye_rays`.
  glm::dvec3 pixel(const RowWindow& rows, const EyeRays& eye_rays, int x, int y, texmap::FilterThread& filter,
                   ShadingCounts& counts) const;

 private:
  // What the node sends back along the ray that arrives at it, and what of that is left where the ray began.
  glm::dvec3 node(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path,
                  texmap::FilterThread& filter, ShadingCounts& counts) const;
  glm::dvec3 dimmed_node(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path,
                         texmap::FilterThread& filter, ShadingCounts& counts) const;
  // What comes back to the path's last node from the ray that goes on by `step`.
  glm::dvec3 child(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path, Step step,
                   texmap::FilterThread& filter, ShadingCounts& counts) const;
  glm::dvec3 escaped(const NodePath& path, Step step, texmap::FilterThread& filter,
                     ShadingCounts& counts) const;
  glm::dvec3 background(const glm::dvec3& direction, const RayDifferential& ray, texmap::FilterThread& filter,
                        ShadingCounts& counts) const;

  const scene::Scene& scene_;
  const Tracer& tracer_;
  const TextureLookup& textures_;
  const Environment& environment_;
  bool looks_round_;  // are footprints made from neighbours?
};

}  // namespace sweepkit::render
