// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "sweepkit/texmap/distortion.hpp"
#include "sweepkit/texmap/image.hpp"

namespace sweepkit::texmap {

struct HeatMapOptions {
  int width = 1024;  ///< texels, 1 to 32768
  int height = 1024;
};

struct HeatMap {
  Image image;          ///< 16-bit RGB, of the (u,v) from `low` to `high`
  glm::dvec2 low{0.0};  ///< whole numbers: the unit square for a mapping that lies in it
  glm::dvec2 high{1.0};
  double brightest = 1;  ///< the value shown brightest, with all above it; 1 is the darkest
};

/// A ratio for each triangle, at least 1, drawn where the triangle lies on the texture: dark where it is 1,
/// brighter with its logarithm up to the value that 99 % of the surface's area stay below (at least 1.1, so
/// that rounding does not shine). Where triangles overlap the larger ratio shows; texels that none covers
/// are filled from near ones, so that the image can be laid over the object itself. Infinite ratios are
/// brightest. Throws InputError for sizes out of range, and for (u,v) farther than 2^20 from 0.
HeatMap draw_heat_map(const MappedSurface& surface, std::span<const double> ratios,
                      const HeatMapOptions& options = {});

/// The colour of a share from 0 to 1, linear RGB: lightness in OKLab grows evenly from nearly black to nearly
/// white, the hue runs from blue over red to yellow.
glm::vec3 heat_color(double share);

}  // namespace sweepkit::texmap
