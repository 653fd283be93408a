// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "rotation_minimizing_frames.hpp"
#include "stations.hpp"
#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::sweep {

/// One side of a row: the frame there and how fast the row's axes change along the trajectory.
struct RowSide {
  Frame frame;
  glm::dvec3 x_rate{0.0};  ///< X', a metre
  glm::dvec3 y_rate{0.0};
};

/// The section's place at a station: S = center + x x_axis + y y_axis. At a corner it lies in the mitre
/// plane.
struct Row {
  glm::dvec3 center;
  glm::dvec3 x_axis;
  glm::dvec3 y_axis;
  RowSide in, out;
  bool is_corner = false;
};

/// A row for every station. A closed trajectory's last is its first, to the bit. Throws InputError where the
/// trajectory turns back on itself.
std::vector<Row> make_rows(const Curve3& trajectory, const std::vector<Station>& stations,
                           const FramesAlong& along);

}  // namespace sweepkit::sweep
