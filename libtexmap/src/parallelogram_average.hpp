// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "filter_scratch.hpp"
#include "pyramid.hpp"
#include "sweepkit/texmap/footprint.hpp"

namespace sweepkit::texmap {

/// The mean of a texture under a pixel itself, the parallelogram of its footprint: what a box of one pixel
/// sees, where an ellipse stands for a tent. None where a side is shorter than a texel, the footprint is not
/// finite, longer than 64 times its width or larger than a few textures: there the elliptical average is as
/// good.
std::optional<glm::vec3> parallelogram_average(const Pyramid& pyramid, Wrap wrap, const Footprint& footprint,
                                               FilterScratch& scratch);

}  // namespace sweepkit::texmap
