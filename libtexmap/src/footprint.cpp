// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/footprint.hpp"

#include <cmath>

namespace sweepkit::texmap {

UvBox neighbour_box(glm::dvec2 hit, std::span<const glm::dvec2> neighbours, glm::dvec2 period) {
  UvBox box{hit, hit};
  for (glm::dvec2 uv : neighbours) {
    // The nearest of the places that are the same one: a step over the seam is a small step. Only a whole
    // period is taken off, so a box that is wide for a good reason stays wide.
    if (period.x > 0) uv.x -= period.x * std::nearbyint((uv.x - hit.x) / period.x);
    if (period.y > 0) uv.y -= period.y * std::nearbyint((uv.y - hit.y) / period.y);
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) continue;
    box.min = glm::min(box.min, uv);
    box.max = glm::max(box.max, uv);
  }
  return box;
}

UvBox shrunk(const UvBox& box, glm::dvec2 hit, double share) {
  return {hit + share * (box.min - hit), hit + share * (box.max - hit)};
}

}  // namespace sweepkit::texmap
