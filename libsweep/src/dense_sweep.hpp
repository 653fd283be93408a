// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "joints.hpp"
#include "morph.hpp"
#include "outline_sampler.hpp"
#include "spine.hpp"
#include "sweepkit/sweep/curve.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::sweep {

/// A column of one of the outlines.
struct ColumnPlace {
  std::size_t outline, column;
};

/// A sweep divided far more finely than it is to be: what a grid is chosen from and measured against.
struct DenseSweep {
  std::vector<Morph> morphs;  ///< an outline
  Spine spine;
  std::vector<std::vector<KeyWeights>> weights;  ///< an outline, a row; of outlines that change
  /// A closed trajectory comes home turned by so many columns, an outline; then what is chosen of them is to
  /// repeat after `repeat_columns`, so that it comes home to itself.
  std::vector<std::size_t> closing_columns;
  std::vector<std::size_t> repeat_columns;

  glm::dvec3 position(const ColumnPlace& place, std::size_t row) const;
};

/// Divides contour and trajectory so that chords between neighbours are nearer to the surface than a 32nd of
/// `tolerance`. Throws InputError where that would take too many cells, and as its parts do.
DenseSweep make_dense_sweep(const ContourSamplers& samplers, const Curve3& trajectory,
                            const SweepOptions& options, double tolerance);

/// The columns that lie farthest out in directions all round.
std::vector<ColumnPlace> extreme_columns(const std::vector<Morph>& morphs);

/// The distance of a point from a segment.
double distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b);

/// `trajectory` with its corners joined for what the contour reaches there.
JoinedTrajectory join_corners(const Curve3& trajectory, const std::vector<Morph>& morphs,
                              const SweepOptions& options);

}  // namespace sweepkit::sweep
