// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "stations.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <string>
#include <utility>

#include "number_text.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::sweep {

namespace {

// Lengths that differ by their rounding only made equal: which of the sides of a star is the longest is no
// reason to give it more cells.
std::vector<double> without_rounding(const std::vector<double>& lengths) {
  constexpr double kRounding = 1e-12;
  std::vector<std::size_t> ascending(lengths.size());
  std::iota(ascending.begin(), ascending.end(), std::size_t{0});
  std::sort(ascending.begin(), ascending.end(),
            [&](std::size_t a, std::size_t b) { return lengths[a] < lengths[b]; });
  std::vector<double> equal(lengths.size());
  double shortest = 0;
  for (const std::size_t i : ascending) {
    if (lengths[i] > shortest * (1 + kRounding)) shortest = lengths[i];
    equal[i] = shortest;
  }
  return equal;
}

}  // namespace

// Adams' method of apportionment, ties to the earlier piece; where cells of one length fit every piece, they
// are what comes out.
std::vector<int> share_cells(const std::vector<double>& given, std::vector<int> least, int cells) {
  const std::vector<double> lengths = without_rounding(given);
  std::vector<int> share = std::move(least);
  using Entry = std::pair<double, std::size_t>;  // (length of a cell, piece)
  const auto is_after = [](const Entry& a, const Entry& b) {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  };
  std::priority_queue<Entry, std::vector<Entry>, decltype(is_after)> longest(is_after);
  for (std::size_t i = 0; i < lengths.size(); ++i) longest.push({lengths[i] / share[i], i});
  for (int spare = cells - std::accumulate(share.begin(), share.end(), 0); spare > 0; --spare) {
    const std::size_t piece = longest.top().second;
    longest.pop();
    ++share[piece];
    longest.push({lengths[piece] / share[piece], piece});
  }
  return share;
}

std::vector<int> share_cells(std::span<const Piece> pieces, int cells) {
  std::vector<double> lengths;
  std::vector<int> least;
  lengths.reserve(pieces.size());
  least.reserve(pieces.size());
  for (const Piece& piece : pieces) {
    lengths.push_back(piece.length);
    least.push_back(piece.least_cells);
  }
  return share_cells(lengths, std::move(least), cells);
}

template <int D>
std::vector<Piece> smooth_pieces(const Curve<D>& curve, std::span<const int> least_cells) {
  const std::span<const double> ends = curve.end_lengths();
  const auto least = [&](std::size_t i) { return least_cells.empty() ? 1 : least_cells[i]; };
  std::vector<Piece> pieces;
  std::size_t first = 0;
  for (std::size_t i = 1; i <= ends.size(); ++i) {
    if (i < ends.size() && !curve.is_corner(i) && least(i) == 1 && least(i - 1) == 1) continue;
    const double start = first == 0 ? 0 : ends[first - 1];
    pieces.push_back({first, start, ends[i - 1] - start, least(i - 1)});
    first = i;
  }
  return pieces;
}

template <int D>
std::vector<Piece> segment_pieces(const Curve<D>& curve) {
  const std::span<const double> ends = curve.end_lengths();
  std::vector<Piece> pieces;
  pieces.reserve(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const auto* bezier = std::get_if<BezierSegment<D>>(&curve.segments()[i]);
    const bool is_straight = bezier != nullptr && bezier->control.size() == 2;
    const double start = i == 0 ? 0 : ends[i - 1];
    pieces.push_back({i, start, ends[i] - start, is_straight ? 1 : kLeastLooks});
  }
  return pieces;
}

std::vector<Piece> halved(std::span<const Piece> pieces, const std::vector<bool>& is_halved) {
  std::vector<Piece> result;
  result.reserve(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    result.push_back(pieces[i]);
    if (!is_halved[i]) continue;
    result.back().length /= 2;
    result.push_back(result.back());
    result.back().start += result.back().length;
  }
  return result;
}

template <int D>
std::vector<Station> place_stations(const Curve<D>& curve, std::span<const Piece> pieces,
                                    std::span<const int> cells) {
  const std::span<const double> ends = curve.end_lengths();
  const std::size_t segments = ends.size();
  const auto parameter = [&](CurveLocation at) {
    return (static_cast<double>(at.segment) + at.t) / static_cast<double>(segments);
  };
  std::vector<Station> stations;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto [first, start, length, least] = pieces[k];
    const bool is_at_joint = start == (first == 0 ? 0 : ends[first - 1]);
    for (int cell = 0; cell < cells[k]; ++cell) {
      Station station;
      station.length = start + length * cell / cells[k];
      if (cell == 0 && is_at_joint) {
        station.out = {first, 0};
        station.in = first > 0           ? CurveLocation{first - 1, 1}
                     : curve.is_closed() ? CurveLocation{segments - 1, 1}
                                         : station.out;
        station.is_corner = curve.is_corner(first);
      } else {
        station.in = station.out = curve.locate(station.length);
      }
      station.parameter = parameter(station.out);
      stations.push_back(station);
    }
  }
  Station last = stations.front();
  if (!curve.is_closed()) last = {.in = {segments - 1, 1}, .out = {segments - 1, 1}};
  last.length = curve.length();
  last.parameter = 1;
  stations.push_back(last);
  return stations;
}

template <int D>
std::vector<Station> place_stations(const Curve<D>& curve, int cells, std::span<const int> least_cells) {
  const std::vector<Piece> pieces = smooth_pieces(curve, least_cells);
  return place_stations<D>(curve, pieces, share_cells(pieces, cells));
}

void check_tolerance(std::optional<double> tolerance) {
  if (tolerance && !(*tolerance > 0 && std::isfinite(*tolerance))) {
    throw InputError("tolerance needs to be above 0 m, got " + number_text(*tolerance));
  }
}

void check_loop(std::size_t cells, const char* what) {
  if (cells < 3) {
    throw InputError(std::string(what) + " is closed and needs at least 3 cells, got " +
                     std::to_string(cells));
  }
}

template <int D>
std::vector<Station> reversed(const Curve<D>& curve, std::vector<Station> stations) {
  std::reverse(stations.begin(), stations.end());
  for (Station& station : stations) {
    std::swap(station.in, station.out);
    station.length = curve.length() - station.length;
    station.parameter = 1 - station.parameter;
  }
  return stations;
}

std::vector<double> texture_fractions(const std::vector<Station>& stations, UvBy by) {
  std::vector<double> fractions;
  fractions.reserve(stations.size());
  const double total = stations.back().length;
  for (const Station& station : stations) {
    fractions.push_back(by == UvBy::kParameter ? station.parameter : station.length / total);
  }
  return fractions;
}

void check_triangles(const Tessellation& tessellation, std::uint64_t triangles) {
  if (triangles <= tessellation.most_triangles) return;
  throw InputError("tolerance of " + number_text(*tessellation.tolerance) + " m takes " +
                   std::to_string(triangles) + " triangles, more than the " +
                   std::to_string(tessellation.most_triangles) +
                   " that memory and the file have room for; ask for a larger one");
}

void check_cells(int cells, const char* along) {
  if (cells < 1 || cells > kMaxCells) {
    throw InputError("tessellation along the " + std::string(along) + " needs 1 to " +
                     std::to_string(kMaxCells) + " cells, got " + std::to_string(cells));
  }
}

template std::vector<Piece> smooth_pieces<2>(const Curve<2>&, std::span<const int>);
template std::vector<Piece> smooth_pieces<3>(const Curve<3>&, std::span<const int>);
template std::vector<Piece> segment_pieces<2>(const Curve<2>&);
template std::vector<Piece> segment_pieces<3>(const Curve<3>&);
template std::vector<Station> place_stations<2>(const Curve<2>&, std::span<const Piece>,
                                                std::span<const int>);
template std::vector<Station> place_stations<3>(const Curve<3>&, std::span<const Piece>,
                                                std::span<const int>);
template std::vector<Station> place_stations<2>(const Curve<2>&, int, std::span<const int>);
template std::vector<Station> place_stations<3>(const Curve<3>&, int, std::span<const int>);
template std::vector<Station> reversed<2>(const Curve<2>&, std::vector<Station>);

}  // namespace sweepkit::sweep
