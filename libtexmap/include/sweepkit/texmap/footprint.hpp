// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "sweepkit/texmap/summed_area_table.hpp"

namespace sweepkit::texmap {

/// The paper's Fig. 4: the bounding box of a hit's (u,v) and its neighbours'. A neighbour across the seam of
/// an area that comes round (`period` > 0 in u or v) is taken at its nearest representative, so that the box
/// does not span the whole texture. Neighbours that are not finite are passed over.
UvBox neighbour_box(glm::dvec2 hit, std::span<const glm::dvec2> neighbours, glm::dvec2 period);

/// The same box shrunk about the hit: the neighbours' hits span two pixels, so a `share` of 0.5 spans one.
UvBox shrunk(const UvBox& box, glm::dvec2 hit, double share);

}  // namespace sweepkit::texmap
