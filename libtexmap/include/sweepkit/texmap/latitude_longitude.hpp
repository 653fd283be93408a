// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "sweepkit/texmap/footprint.hpp"
#include "sweepkit/texmap/texture.hpp"

namespace sweepkit::texmap {

/// A picture of everything around by latitude and longitude: its middle is -Z (where a camera that is not
/// turned looks), +X is a quarter of the width to the right of it, the top row is about +Y and the bottom row
/// about -Y; the left and the right border meet at +Z.
///
/// As a texture it covers the sphere twice, so that it comes round both ways and a filter goes over the
/// borders and over the poles as over any other place: the upper half is the picture, the lower half is what
/// lies beyond the pole, upside down and half a turn on. No texel is copied. Precondition: the image is not
/// empty.
ImageTexture over_sphere(const ImageTexture& picture);

/// Where a direction falls on such a texture, and what a pixel covers there: `direction` is unit, `dx` and
/// `dy` say how it turns for a step of one pixel to the right and down. `size` is the picture's, in texels.
/// Close to a pole a step counts for no more than 16 texels along for each texel across: there the rows'
/// texels lie so close that a longer footprint would read the same sky many times.
Footprint over_sphere(const glm::dvec3& direction, const glm::dvec3& dx, const glm::dvec3& dy,
                      glm::dvec2 size);

}  // namespace sweepkit::texmap
