// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sweepkit/sweep/curve.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::sweep {

/// Where vertices stand along a curve. At a corner the curve arrives at one location and leaves from another.
struct Station {
  CurveLocation in;
  CurveLocation out;
  double length = 0;     ///< from the curve's start
  double parameter = 0;  ///< 0 at the start, 1 at the end, each segment an equal share
  bool is_corner = false;
};

/// Stations at the start, the end, every corner, and in between so that there are `cells` cells: shared among
/// the smooth pieces by length, at least one each (so a curve with more pieces than cells has one cell a
/// piece), equally long inside a piece. A closed curve has its start again as its last station. `least_cells`
/// may ask for more than 1 on a segment, which is a piece of its own then.
template <int D>
std::vector<Station> place_stations(const Curve<D>& curve, int cells, std::span<const int> least_cells = {});

/// The stations of the same curve walked the other way.
template <int D>
std::vector<Station> reversed(const Curve<D>& curve, std::vector<Station> stations);

/// 0 to 1 along the stations, by arc length or by parameter.
std::vector<double> texture_fractions(const std::vector<Station>& stations, UvBy by);

/// Throws InputError where a loop has fewer cells than a triangle has sides. `what` names it ("contour").
void check_loop(std::size_t cells, const char* what);

/// Throws InputError unless both repeats are finite.
void check_texture(const UvOptions& uv);

/// Throws InputError unless 1 <= cells <= kMaxCells. `along` names them in the message ("contour").
void check_cells(int cells, const char* along);

}  // namespace sweepkit::sweep
