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
  std::uint64_t nodes = 0;
  std::uint64_t smoothed = 0;  ///< of them, lit by what their neighbours see of the lights as well
  std::uint64_t environment_lookups = 0;
  LookupCounts lookups;

  void add(const ShadingCounts& other);
};

/// What a tree sends to the eye: its colour and, fourth, 1 where the eye ray met an object; and the colour
/// with the textures that are averaged over the pixel left white (texture_lookup.hpp).
struct TreeColor {
  glm::dvec4 color;
  glm::dvec3 plain;
};

/// Light on its way through a tree, as TreeColor has it.
struct TreeLight {
  glm::dvec3 color{0.0};
  glm::dvec3 plain{0.0};
};

/// Shades a pixel's tree from its deepest node up (the paper's 3.2.2).
class Shader {
 public:
  /// With `leaves_background_out` what the eye sees of the background is black.
  Shader(const scene::Scene& scene, const scene::Plan& plan, const Tracer& tracer,
         const TextureLookup& textures, const Environment& environment, bool leaves_background_out)
      : scene_(scene),
        tracer_(tracer),
        textures_(textures),
        environment_(environment),
        shadows_(plan.needs_part(scene::Part::kShadowEdges) ? Shadows::kSmooth : Shadows::kHard),
        looks_round_(plan.needs_part(scene::Part::kRows)),
        leaves_background_out_(leaves_background_out) {}

  /// Pixel x of the middle row.
  TreeColor pixel(const RowWindow& rows, const EyeRays& eye_rays, int x, texmap::FilterThread& filter,
                  ShadingCounts& counts) const;
  /// A tree that has no neighbours: the one of row.places[index], for a square of `side` pixels.
  TreeColor sample(const TreeRow& row, const EyeRays& eye_rays, std::size_t index, double side,
                   texmap::FilterThread& filter, ShadingCounts& counts) const;

 private:
  TreeColor seen(const RowWindow& rows, const Neighbourhood& nodes, const EyeSample& eye,
                 texmap::FilterThread& filter, ShadingCounts& counts) const;
  // What the node sends back along the ray that arrives at it, and what of that is left where the ray began.
  TreeLight node(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path,
                 texmap::FilterThread& filter, ShadingCounts& counts) const;
  TreeLight dimmed_node(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path,
                        texmap::FilterThread& filter, ShadingCounts& counts) const;
  // What comes back to the path's last node from the ray that goes on by `step`.
  TreeLight child(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path, Step step,
                  texmap::FilterThread& filter, ShadingCounts& counts) const;
  glm::dvec3 escaped(const NodePath& path, Step step, texmap::FilterThread& filter,
                     ShadingCounts& counts) const;
  glm::dvec3 background(const glm::dvec3& direction, const RayDifferential& ray, texmap::FilterThread& filter,
                        ShadingCounts& counts) const;

  const scene::Scene& scene_;
  const Tracer& tracer_;
  const TextureLookup& textures_;
  const Environment& environment_;
  Shadows shadows_;
  bool looks_round_;  // does anything look at neighbours?
  bool leaves_background_out_;
};

}  // namespace sweepkit::render
