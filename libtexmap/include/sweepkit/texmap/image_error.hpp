// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "sweepkit/texmap/image.hpp"

namespace sweepkit::texmap {

/// A rectangle of pixels; the whole image where width is 0.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Root of the mean squared difference over RGB, in linear light. Throws InputError if the sizes differ.
double rmse(const Image& image, const Image& reference, const PixelRect& rect = {});

/// The same over the pixels where `mask` is not 0 (row by row, one byte a pixel); 0 if there is none.
double rmse(const Image& image, const Image& reference, std::span<const std::uint8_t> mask);

/// Peak signal-to-noise ratio in dB for a peak of 1; infinity for equal images.
double psnr(const Image& image, const Image& reference, const PixelRect& rect = {});

struct FlipOptions {
  double pixels_per_degree = 67.0206;  ///< a 0.7 m wide 3840-pixel screen seen from 0.7 m
};
/// Mean of FLIP, the difference a person sees when two pictures alternate, 0 to 1 [Andersson20]. Takes linear
/// RGB, clamped to [0, 1].
double mean_flip(const Image& image, const Image& reference, const FlipOptions& options = {},
                 const PixelRect& rect = {});

}  // namespace sweepkit::texmap
