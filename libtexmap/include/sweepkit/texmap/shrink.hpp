// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "sweepkit/texmap/image.hpp"

namespace sweepkit::texmap {

/// Both sides made smaller alike until neither is over `most`, at least one texel each; the size itself where
/// it fits. Precondition: all are at least 1.
glm::ivec2 fitting_size(glm::ivec2 size, int most);

/// The image in fewer texels, each the mean of what it covers, in linear light as images are. Sums of integer
/// texels are exact and the mean is rounded once, to nearest; alpha is a channel like any other, since no
/// colour is multiplied by it. Precondition: 1 <= size <= the image's, on both sides.
Image shrink(const Image& image, glm::ivec2 size);

}  // namespace sweepkit::texmap
