// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace sweepkit::scene {

/// A list of points, one a line.
struct PointFile {
  int columns = 2;                 ///< 2 or 3, in every line
  std::vector<glm::dvec3> points;  ///< z is 0 where there are two columns; not empty
};

/// More would take gigabytes as segments of a curve.
inline constexpr std::size_t kMostPoints = 1'000'000;
inline constexpr std::size_t kLargestPointFile = std::size_t{128} << 20;

/// CSV, white-space XY or XYZ, Selig's airfoil .dat: known by their content, not by the file's name. Numbers
/// are apart by a comma, a semicolon or blanks; # begins a comment; empty lines are skipped. The first line
/// may be a header or a name: then its first word is no number.
/// Throws InputError with file, line and column: no number, an empty field, not 2 or 3 columns or a change of
/// them, coordinates beyond 1e9 m, no point, over kMostPoints. Lednicer's airfoil order, which begins with
/// the counts of two surfaces, is refused by name.
PointFile read_points(std::string_view text, const std::string& file);

}  // namespace sweepkit::scene
