// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

namespace sweepkit::render {

/// What drawing a pixel tells of its error, without any ray for that alone. Squares of linear light, the mean
/// of R, G and B.
struct PixelError {
  /// The variance of a pixel half its own and half its least like neighbour; where both show the same
  /// surfaces, with the textures that are averaged over the pixel left white.
  float edge = 0;
  float refined = 0;       ///< with several rays: the squared error that their variance lets expect
  std::uint32_t rays = 1;  ///< that its colour is made of
};

/// Rays in a pixel besides its own may all miss what made it differ: their variance is estimated with so many
/// added that have that of PixelError::edge.
inline constexpr double kPriorRays = 2;

/// The side of the square that the textures of one of a pixel's `n` rays are averaged over. The rays' places
/// are spread over the pixel already. Squares of half the pixel's area, shared out, blur least and still
/// leave no gap.
inline double side_of_sample(int n) {
  return std::sqrt(0.5 / n);
}

}  // namespace sweepkit::render
