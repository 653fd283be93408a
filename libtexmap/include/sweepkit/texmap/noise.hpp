// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace sweepkit::texmap {

/// Perlin's gradient noise. Both are 0 at whole coordinates, have no mean, and no cell of theirs is like
/// another.
enum class NoiseBasis {
  kPerlin2002,  ///< gradients to the middles of a cube's edges, quintic fade: C2, within 1.0364 of 0
  kPerlin1985,  ///< gradients all round, cubic fade: C1, softer, within 0.87 of 0
};

/// 0 where a coordinate is not finite or past 2^52.
double noise(const glm::dvec3& position, NoiseBasis basis = NoiseBasis::kPerlin2002);

/// A sum over octaves, each twice as fine and half as strong as the one before.
struct Octaves {
  int count = 6;  ///< 1 to 16
  NoiseBasis basis = NoiseBasis::kPerlin2002;
  /// In two dimensions: each octave is the plane of the lattice that position.z, rounded down, names. It has
  /// a mean of 0 over every period. In three each octave is turned against the one before, so that their
  /// lattices do not line up.
  bool is_flat = false;
  /// Cells after which a flat one comes round along x and y, times 2^count below 2^62; 0: never.
  std::int64_t period_x = 0;
  std::int64_t period_y = 0;
};

/// How the values under a footprint lie about their mean: the cumulants of order 2 to 4.
struct Cumulants {
  double variance = 0;
  double third = 0;
  double fourth = 0;
};

/// The mean of a noise under a footprint, and the cumulants of what it has lost.
struct FilteredNoise {
  double mean = 0;
  Cumulants lost;
};

/// Sum of noise over octaves [Perlin85], often called fBm, under a footprint whose covariance has the trace
/// `extent` (in cells squared; 0 is a point, infinity everything). Octaves finer than the footprint fade out,
/// evenly, to their mean of 0. Within 2.08 of 0.
FilteredNoise fractal_sum(const glm::dvec3& position, double extent, const Octaves& octaves);

/// The same of |noise| [Perlin85]: its octaves fade to their mean, which is not 0. From 0 to 2.08.
FilteredNoise turbulence(const glm::dvec3& position, double extent, const Octaves& octaves);

/// The cumulants of the whole of fractal_sum(), which is what it has lost at an extent of infinity.
Cumulants cumulants_of_fractal_sum(const Octaves& octaves);

}  // namespace sweepkit::texmap
