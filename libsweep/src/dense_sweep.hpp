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
  std::vector<std::size_t> outer_of;  ///< as nest_outlines() says
  std::vector<Morph> morphs;          ///< an outline
  Spine spine;
  bool changes = false;                          ///< the section turns, grows or changes along the trajectory
  std::vector<std::vector<KeyWeights>> weights;  ///< an outline, a row; of outlines that change
  /// A closed trajectory comes home turned by so many columns, an outline; then what is chosen of them is to
  /// repeat after `repeat_columns`, so that it comes home to itself.
  std::vector<std::size_t> closing_columns;
  std::vector<std::size_t> repeat_columns;

  glm::dvec3 position(const ColumnPlace& place, std::size_t row) const;
};

/// How near chords of a dense sweep are to its surface, as a share of the tolerance.
inline constexpr double kDenseShare = 1.0 / 64;

/// Every outline divided so that chords over two cells are within `bound` of it, a straight piece in
/// `straight` cells. Throws InputError, which names `tolerance`, where that would take too many columns.
std::vector<Morph> sample_densely(const ContourSamplers& samplers, double bound, double tolerance,
                                  int straight);

/// Lets the columns of contours that cover themselves when turned repeat: for a closed trajectory, at whose
/// end the section comes home to one of those turns.
void make_periodic(ContourSamplers& samplers);

/// Divides contour and trajectory so that chords over two cells are within kDenseShare of `tolerance`; a
/// `density` above 0 makes cells 4 times as many in both, again and again. Throws InputError where that would
/// take too many cells, and as its parts do.
DenseSweep make_dense_sweep(const ContourSamplers& samplers, const Curve3& trajectory,
                            const SweepOptions& options, double tolerance, int density);

/// The columns that lie farthest out in directions all round.
std::vector<ColumnPlace> extreme_columns(const std::vector<Morph>& morphs);

/// Cells of a contour by which shapes are chosen that are not to depend on the mesh's own.
inline constexpr int kShapeCells = 512;

/// `trajectory` with its corners joined for what the contour reaches there.
JoinedTrajectory join_corners(const Curve3& trajectory, const ContourSamplers& samplers,
                              const SweepOptions& options);

}  // namespace sweepkit::sweep
