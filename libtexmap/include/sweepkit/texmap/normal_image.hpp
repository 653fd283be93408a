// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "sweepkit/texmap/image.hpp"

namespace sweepkit::texmap {

/// An image of normals (RGB = (n + 1) / 2; x to the right, y upwards, z out of it) in fewer texels: each the
/// mean of the vectors that it covers, made unit; (0, 0, 1) where they cancel out. Grey images stay what
/// shrink() makes of them. Preconditions as shrink()'s.
Image shrink_normals(const Image& image, glm::ivec2 size);

/// What of a height field comes round.
struct HeightField {
  glm::dvec2 texel{1.0};  ///< metres, across and down
  double depth = 0;       ///< metres from black to white; negative: white is deep
  bool repeats_across = false;
  bool repeats_down = false;
};

/// The normals of the surface whose height is the image's grey value (the mean of RGB) times the depth, by
/// central differences, at an edge that does not repeat by those to the one side. 16-bit RGB.
Image normals_from_heights(const Image& image, const HeightField& field);

}  // namespace sweepkit::texmap
