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

// `cells` shared by length, at least as many as `least` says each: one after the other goes to the piece
// whose cells are longest at the time (Adams' method of apportionment; ties to the earlier piece). No other
// share leaves the longest cell shorter, and where cells of one length fit every piece, they are what comes
// out.
std::vector<int> share_cells(const std::vector<double>& lengths, std::vector<int> least, int cells) {
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

}  // namespace

template <int D>
std::vector<Station> place_stations(const Curve<D>& curve, int cells, std::span<const int> least_cells) {
  const std::span<const double> ends = curve.end_lengths();
  const std::size_t segments = ends.size();
  std::vector<std::size_t> piece_ends;  // one past the last segment of each smooth piece
  const auto least = [&](std::size_t i) { return least_cells.empty() ? 1 : least_cells[i]; };
  for (std::size_t i = 1; i < segments; ++i) {
    if (curve.is_corner(i) || least(i) > 1 || least(i - 1) > 1) piece_ends.push_back(i);
  }
  piece_ends.push_back(segments);

  std::vector<double> lengths;
  std::vector<int> least_of_piece;
  double start = 0;
  for (const std::size_t end : piece_ends) {
    lengths.push_back(ends[end - 1] - start);
    least_of_piece.push_back(least(end - 1));
    start = ends[end - 1];
  }
  const std::vector<int> share = share_cells(lengths, std::move(least_of_piece), cells);

  const auto parameter = [&](CurveLocation at) {
    return (static_cast<double>(at.segment) + at.t) / static_cast<double>(segments);
  };
  std::vector<Station> stations;
  start = 0;
  for (std::size_t piece = 0; piece < lengths.size(); ++piece) {
    for (int i = 0; i < share[piece]; ++i) {
      Station station;
      station.length = start + lengths[piece] * i / share[piece];
      if (i == 0) {
        const std::size_t first = piece == 0 ? 0 : piece_ends[piece - 1];
        station.out = {first, 0};
        station.in = piece > 0           ? CurveLocation{first - 1, 1}
                     : curve.is_closed() ? CurveLocation{segments - 1, 1}
                                         : station.out;
        station.is_corner = curve.is_corner(first);
      } else {
        station.in = station.out = curve.locate(station.length);
      }
      station.parameter = parameter(station.out);
      stations.push_back(station);
    }
    start = ends[piece_ends[piece] - 1];
  }
  Station last = stations.front();
  if (!curve.is_closed()) last = {.in = {segments - 1, 1}, .out = {segments - 1, 1}};
  last.length = curve.length();
  last.parameter = 1;
  stations.push_back(last);
  return stations;
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

void check_cells(int cells, const char* along) {
  if (cells < 1 || cells > kMaxCells) {
    throw InputError("tessellation along the " + std::string(along) + " needs 1 to " +
                     std::to_string(kMaxCells) + " cells, got " + std::to_string(cells));
  }
}

void check_texture(const UvOptions& uv) {
  if (!std::isfinite(uv.repeat.x) || !std::isfinite(uv.repeat.y)) {
    throw InputError("uv repeat needs two finite numbers, got " + number_text(uv.repeat.x) + " and " +
                     number_text(uv.repeat.y));
  }
}

template std::vector<Station> place_stations<2>(const Curve<2>&, int, std::span<const int>);
template std::vector<Station> place_stations<3>(const Curve<3>&, int, std::span<const int>);
template std::vector<Station> reversed<2>(const Curve<2>&, std::vector<Station>);

}  // namespace sweepkit::sweep
