// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "filter_scratch.hpp"
#include "pyramid.hpp"
#include "sweepkit/texmap/footprint.hpp"

namespace sweepkit::texmap {

/// How fine a level the texels come from. Long footprints cost the most, by their length, and gain the least:
/// past an aspect of 8 the error is that of the footprint itself, straight edges in place of perspective, and
/// finer texels do not lower it. Squared error in 1e-6, noise turned by 35 degrees (docs/plane_filters.md),
/// for a least variance of 0.25 / 0.17 / 0.10 texels squared along the minor axis, which reads 100 / 68 / 42
/// % of the texels:
///   aspect 1-2     2.4 / 3.6 / 22        4-8    1.2 / 2.2 / 4.8       16-32  1.02 / 1.08 / 1.24
///          2-4     2.0 / 4.4 / 15        8-16   0.88 / 1.1 / 1.8      over   0.70 / 0.72 / 0.74
enum class Detail {
  kFull,      ///< a least variance of 0.25 for every footprint
  kBalanced,  ///< 0.25 (2 / aspect)^(1/3), up to an aspect of 32: what a texel less costs is the same all
              ///< over
};

/// The elliptical weighted average of a texture under a pixel's footprint [Heckbert89]. Footprints of any
/// size and shape; those that are not finite give the mean of all.
glm::vec3 elliptical_average(const Pyramid& pyramid, Wrap wrap, const Footprint& footprint, Detail detail,
                             FilterScratch& scratch);

}  // namespace sweepkit::texmap
