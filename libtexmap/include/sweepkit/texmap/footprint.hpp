// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "sweepkit/texmap/area_ratio_mapping.hpp"

namespace sweepkit::texmap {

/// A box in texture coordinates; v upwards. min <= max.
struct UvBox {
  glm::dvec2 min{0.0};
  glm::dvec2 max{0.0};
};

/// Where a pixel falls on a texture: the place of its middle, and how far one pixel to the right and one down
/// go from there. In (u,v).
struct Footprint {
  glm::dvec2 uv{0.0};
  glm::dvec2 dx{0.0};
  glm::dvec2 dy{0.0};
};

/// The paper's Fig. 4: the bounding box of a hit's (u,v) and its neighbours'. A neighbour across the seam of
/// an area that comes round (`period` > 0 in u or v) is taken at its nearest representative, so that the box
/// does not span the whole texture. Neighbours that are not finite are passed over.
UvBox neighbour_box(glm::dvec2 hit, std::span<const glm::dvec2> neighbours, glm::dvec2 period);

/// The same box shrunk about the hit: the neighbours' hits span two pixels, so a `share` of 0.5 spans one.
UvBox shrunk(const UvBox& box, glm::dvec2 hit, double share);

/// The hits in the pixels beside one's own; none where another surface lies there.
struct Beside {
  std::optional<glm::dvec2> left, right, above, below;
};
/// The footprint by differences: central ones, or to the one side that is there. A neighbour across a seam is
/// taken at its nearest representative, as above. None where a direction has no neighbour at all.
std::optional<Footprint> footprint_from(glm::dvec2 hit, const Beside& beside, glm::dvec2 period);

/// The footprint of a pixel by derivatives: `dx` and `dy` say how the hit moves on the triangle's plane for a
/// step of one pixel to the right and down, `uv` is (u,v) at A, B and C. Differences are taken about B in the
/// plane that drops the dominant axis of the normal, as area_ratio_map() does; only the parts of dx and dy in
/// that plane are read. A triangle without area gives a footprint without area; steps that are not finite
/// stay so (TextureSampler takes both).
Footprint footprint_from(const Triangle3<double>& triangle, const std::array<glm::dvec2, 3>& uv,
                         glm::dvec2 hit, const glm::dvec3& dx, const glm::dvec3& dy);

/// A part of a footprint and its share of the whole.
struct FootprintPart {
  Footprint footprint;
  double weight = 1;
};
/// Cuts a long footprint across into at most `most` parts whose aspect is about 1, side by side along the
/// major axis and weighed by the pixel's tent: for filters that know no long footprints (a box about a turned
/// one, a MIP level as coarse as the longer step). The weights sum to 1, and the parts' tents add up to the
/// footprint's own mean and covariance. Returns how many were written to `parts`, one where nothing is to cut
/// or a step is not finite. Precondition: 1 <= most <= parts.size().
int cut_along_major(const Footprint& footprint, int most, std::span<FootprintPart> parts);

}  // namespace sweepkit::texmap
