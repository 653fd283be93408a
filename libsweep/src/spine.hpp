// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "grid_writer.hpp"
#include "morph.hpp"
#include "rows.hpp"
#include "stations.hpp"
#include "sweepkit/sweep/curve.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::sweep {

/// The rows of a sweep, which all its outlines share.
struct Spine {
  std::vector<Row> rows;
  std::vector<bool> breaks;  ///< of the normal, a row
  std::vector<bool> poles;
  std::vector<double> shares;  ///< of the trajectory's length
  std::vector<double> v;       ///< 0 to 1
  std::vector<Run> runs;
  double length = 0;  ///< of the trajectory
  bool is_closed = false;
  /// Turned by a whole turn / symmetry the contour covers itself; a closed trajectory comes home turned by so
  /// many steps of it.
  int symmetry = 1;
  int closing_steps = 0;
};

/// Rows at the stations of a trajectory whose corners are joined. Of a contour's symmetry no more than
/// `most_symmetry` is used. Throws InputError as orient() and
/// make_rows() do, and where a closed trajectory's contour does not end as it began.
Spine make_spine(const Curve3& trajectory, const std::vector<Station>& stations,
                 const std::vector<Morph>& morphs, const SweepOptions& options,
                 int most_symmetry = std::numeric_limits<int>::max());

/// A closed trajectory's last row is its first one's vertices, so many columns on.
std::size_t closing_columns(const Morph& morph, const Spine& spine, bool is_hole);

}  // namespace sweepkit::sweep
