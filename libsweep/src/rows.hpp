// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "frames.hpp"
#include "stations.hpp"
#include "sweepkit/sweep/curve.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::sweep {

/// One side of a row: the frame there and how fast the row's axes change along the trajectory.
struct RowSide {
  Frame frame;
  glm::dvec3 x_rate{0.0};  ///< X', a metre
  glm::dvec3 y_rate{0.0};
  bool is_plain = true;  ///< nothing but the trajectory's own bend changes the axes
};

/// The section's place at a station: S = center + x x_axis + y y_axis. At a corner it lies in the mitre
/// plane.
struct Row {
  glm::dvec3 center;
  glm::dvec3 x_axis;
  glm::dvec3 y_axis;
  /// The axes' directions, with lengths in proportion to theirs: at a pole, where those are 0, too.
  glm::dvec3 x_direction;
  glm::dvec3 y_direction;
  RowSide in, out;
  bool is_corner = false;
  bool is_pole = false;     ///< the profile has shrunk the section to a point
  bool is_pressed = false;  ///< to a line: one of the axes is 0
};

/// Where a point of the section's plane lies.
inline glm::dvec3 position_of(const Row& row, const glm::dvec2& p) {
  return row.center + p.x * row.x_axis + p.y * row.y_axis;
}

/// A row for every station. A closed trajectory's last is its first, to the bit. Precondition: no corner of
/// it turns right back (joints.hpp). Throws InputError where the profile is below 0, and where that of a
/// closed trajectory does not end as it began.
std::vector<Row> make_rows(const Curve3& trajectory, const std::vector<Station>& stations,
                           const std::vector<StationFrames>& frames, const Profile& profile);

}  // namespace sweepkit::sweep
