// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
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

/// `cells` shared by length, at least as many as `least` says each: one after the other goes to the piece
/// whose cells are longest at the time. No other share leaves the longest cell shorter.
std::vector<int> share_cells(const std::vector<double>& lengths, std::vector<int> least, int cells);

/// A stretch of a curve that is divided evenly.
struct Piece {
  std::size_t first;  ///< the segment it begins in
  double start;       ///< from the curve's start
  double length;
  int least_cells = 1;
};

/// The pieces between corners. `least_cells` may ask for more than 1 on a segment, which is a piece of its
/// own then.
template <int D>
std::vector<Piece> smooth_pieces(const Curve<D>& curve, std::span<const int> least_cells = {});

/// A piece that bends is looked at in no fewer cells than this: what looks straight in them is.
inline constexpr int kLeastLooks = 16;

/// Every segment a piece, a bent one of kLeastLooks cells at least.
template <int D>
std::vector<Piece> segment_pieces(const Curve<D>& curve);

/// The pieces with those in two of which is_halved says so.
std::vector<Piece> halved(std::span<const Piece> pieces, const std::vector<bool>& is_halved);

/// `cells` shared among pieces by length, at least as many as each needs.
std::vector<int> share_cells(std::span<const Piece> pieces, int cells);

/// Stations at the start, the end, every piece's ends, and in between so that piece i has cells[i] cells,
/// equally long inside it. A closed curve has its start again as its last station.
template <int D>
std::vector<Station> place_stations(const Curve<D>& curve, std::span<const Piece> pieces,
                                    std::span<const int> cells);

/// The same with `cells` in all, shared among the smooth pieces (so a curve with more pieces than cells has
/// one cell a piece).
template <int D>
std::vector<Station> place_stations(const Curve<D>& curve, int cells, std::span<const int> least_cells = {});

/// The stations of the same curve walked the other way.
template <int D>
std::vector<Station> reversed(const Curve<D>& curve, std::vector<Station> stations);

/// 0 to 1 along the stations, by arc length or by parameter.
std::vector<double> texture_fractions(const std::vector<Station>& stations, UvBy by);

/// Throws InputError for a tolerance that is not above 0 and finite.
void check_tolerance(std::optional<double> tolerance);

/// Throws InputError where what a tolerance takes is more than options.most_triangles. Precondition: it has a
/// tolerance.
void check_triangles(const Tessellation& tessellation, std::uint64_t triangles);

/// Throws InputError where a loop has fewer cells than a triangle has sides. `what` names it ("contour").
void check_loop(std::size_t cells, const char* what);

/// Throws InputError unless 1 <= cells <= kMaxCells. `along` names them in the message ("contour").
void check_cells(int cells, const char* along);

}  // namespace sweepkit::sweep
