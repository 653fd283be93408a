// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "sweepkit/render/render.hpp"

namespace sweepkit::report {

/// How a picture may be drawn.
struct PictureMethod {
  std::string filter;        ///< "trilinear"; "plain" for samples of the texture's texels and nothing else
  std::string antialiasing;  ///< "off", "3x3", "adaptive"; "plain"
  std::string setting;       ///< "3x3", "adaptive 0.03", "64 samples"
  render::Options options;   ///< one thread
};

/// Every filter with one ray a pixel, with 3x3 rays, and with adaptive rays at several thresholds of
/// contrast; and plain sampling. One filter's methods stand together, and so do plain sampling's, from few
/// samples to many. A quick run leaves out three filters.
std::vector<PictureMethod> picture_methods(bool is_quick);

/// A picture of side x side point samples a pixel under a box of one pixel, as a reference.
render::Options plain_options(int side);

}  // namespace sweepkit::report
