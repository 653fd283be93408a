// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "filter_scratch.hpp"
#include "pyramid.hpp"
#include "sweepkit/texmap/footprint.hpp"

namespace sweepkit::texmap {

/// The elliptical weighted average of a texture under a pixel's footprint [Heckbert89]. Footprints of any
/// size and shape; those that are not finite give the mean of all.
glm::vec3 elliptical_average(const Pyramid& pyramid, Wrap wrap, const Footprint& footprint,
                             FilterScratch& scratch);

}  // namespace sweepkit::texmap
