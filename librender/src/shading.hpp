// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "neighbourhood.hpp"
#include "sweepkit/scene/plan.hpp"
#include "sweepkit/scene/scene.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"
#include "texture_lookup.hpp"

namespace sweepkit::render {

struct ShadingCounts {
  std::uint64_t nodes = 0;
  std::uint64_t smoothed = 0;  ///< of them, lit by what their neighbours see of the lights as well
  LookupCounts lookups;
};

/// A tree's colour, and the same with the textures that are averaged over the pixel left white
/// (texture_lookup.hpp).
struct TreeColor {
  glm::dvec3 color;
  glm::dvec3 plain;
};

/// Shades a pixel's tree from its deepest node up (the paper's 3.2.2).
class Shader {
 public:
  Shader(const scene::Scene& scene, const scene::Plan& plan, const TextureLookup& textures)
      : scene_(scene),
        textures_(textures),
        shadows_(plan.needs_part(scene::Part::kShadowEdges) ? Shadows::kSmooth : Shadows::kHard),
        looks_round_(plan.needs_part(scene::Part::kRows)) {}

  /// Pixel x of the middle row.
  TreeColor pixel(const RowWindow& rows, const EyeRays& eye_rays, int x, texmap::FilterThread& filter,
                  ShadingCounts& counts) const;
  /// A tree that has no neighbours: the one of row.places[index], for a square of `side` pixels.
  TreeColor sample(const TreeRow& row, const EyeRays& eye_rays, std::size_t index, double side,
                   texmap::FilterThread& filter, ShadingCounts& counts) const;

 private:
  TreeColor node(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path,
                 texmap::FilterThread& filter, ShadingCounts& counts) const;

  const scene::Scene& scene_;
  const TextureLookup& textures_;
  Shadows shadows_;
  bool looks_round_;  // does anything look at neighbours?
};

}  // namespace sweepkit::render
