// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "sweepkit/scene/scene.hpp"

namespace sweepkit::scene {

using SectionPoints = std::vector<glm::dvec3>;  ///< of every line that a part's walls have along their way

/// A swept part as sections along its way.
struct GrowingPart {
  struct WallVertex {
    std::uint32_t vertex;
    std::uint32_t station;  ///< index into times
    std::uint32_t line;
    std::uint32_t first_line;  ///< of its wall
    std::uint32_t last_line;
    bool begins_patch;  ///< nothing before it is of the same smooth surface
    bool ends_patch;
  };
  std::vector<double> times;            ///< rising, the last is 1
  std::vector<SectionPoints> sections;  ///< at those times
  double radius = 0;                    ///< of the largest section about its middle
  std::vector<WallVertex> wall;
  std::vector<std::uint32_t> end_cap;  ///< vertices

  SectionPoints section(double time) const;       ///< straight between those at `times`
  glm::dvec3 way_at(std::size_t station) const;   ///< the section's middle goes this way, of length 1 or 0
  std::size_t station_before(double time) const;  ///< the last one not after it
};

glm::dvec3 middle(const SectionPoints& points);

/// None where (u,v) do not tell the way (a repeat of 0).
std::optional<GrowingPart> growing_part(const MeshView& mesh, const SweptPart& part);

}  // namespace sweepkit::scene
