// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "neighbourhood.hpp"
#include "normal_maps.hpp"
#include "ray_differential.hpp"
#include "sweepkit/render/render.hpp"
#include "sweepkit/scene/plan.hpp"
#include "sweepkit/scene/scene.hpp"
#include "sweepkit/texmap/footprint.hpp"
#include "sweepkit/texmap/procedural.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"
#include "tracer.hpp"

namespace sweepkit::render {

struct LookupCounts {
  std::uint64_t textured = 0;
  std::uint64_t filtered = 0;
  std::uint64_t differentials = 0;
};

/// A diffuse colour, and what it would be if the textures that are averaged over the pixel itself
/// (Filter::kBox) were white: what is left then varies within a pixel in ways that no filter has seen.
struct DiffuseColor {
  glm::dvec3 color;
  glm::dvec3 plain;
};

/// The diffuse colour of nodes: the material's, times its texture filtered over what the pixel covers.
class TextureLookup {
 public:
  TextureLookup(const scene::Scene& scene, const scene::Plan& plan, const Tracer& tracer,
                const Samplers& samplers, texmap::Filter filter, Footprint footprint)
      : scene_(scene),
        tracer_(tracer),
        samplers_(samplers),
        filter_(filter),
        footprint_(footprint),
        looks_round_(plan.needs_part(scene::Part::kFilteredNodes)),
        has_differentials_(plan.needs_part(scene::Part::kDifferentials)),
        leaves_out_(plan.leaves_out) {}

  /// Of the node nodes[1][1], which `path` ends with.
  DiffuseColor diffuse(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path,
                       const scene::Material& material, texmap::FilterThread& filter,
                       LookupCounts& counts) const;

 private:
  // The footprints of a node that needs none, for plans that leave nothing out.
  void look_in_vain(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path,
                    LookupCounts& counts) const;
  // What the (u,v) of the nodes beside say; none where they do not tell.
  std::optional<texmap::Footprint> footprint_beside(const RowWindow& rows, const Neighbourhood& nodes) const;
  HitDifferential moved_hit(const NodePath& path) const;
  std::optional<glm::vec3> filtered(const RowWindow& rows, const Neighbourhood& nodes, double side,
                                    const texmap::TextureSampler& sampler,
                                    texmap::FilterThread& filter) const;
  // Where a node lies in the space that a procedural texture is on, and what its pixel covers there, by the
  // pixels beside it; none where they do not tell.
  glm::dvec3 pattern_place(const TreeRow& row, std::size_t node, texmap::ProceduralOn on) const;
  std::optional<texmap::PatternFootprint> pattern_footprint(const RowWindow& rows, const Neighbourhood& nodes,
                                                            double side, texmap::ProceduralOn on) const;

  const scene::Scene& scene_;
  const Tracer& tracer_;
  const Samplers& samplers_;
  texmap::Filter filter_;
  Footprint footprint_;
  bool looks_round_;        // are footprints made from neighbours?
  bool has_differentials_;  // and from the rays' derivatives?
  bool leaves_out_;
};

}  // namespace sweepkit::render
