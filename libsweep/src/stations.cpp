// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "stations.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

// `cells` shared by length: one each, the rest by largest remainder, ties to the earlier piece.
std::vector<int> share_cells(const std::vector<double>& lengths, int cells) {
  const double total = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  std::vector<int> share(lengths.size(), 1);
  const int pieces = static_cast<int>(lengths.size());
  for (int spare = cells - pieces; spare > 0; --spare) {
    // Give one to the piece whose cells are longest now: the result is that of sharing by length, without
    // ever leaving a piece bare.
    if (spare > 4 * pieces) {
      const int batch = spare - 2 * pieces;
      int given = 0;
      for (std::size_t i = 0; i < lengths.size(); ++i) {
        const int fair = static_cast<int>(std::floor(lengths[i] / total * (cells - pieces)));
        const int extra = std::clamp(fair - share[i], 0, batch - given);
        share[i] += extra;
        given += extra;
      }
      if (given > 0) {
        spare -= given - 1;
        continue;
      }
    }
    std::size_t longest = 0;
    for (std::size_t i = 1; i < lengths.size(); ++i) {
      if (lengths[i] / share[i] > lengths[longest] / share[longest]) longest = i;
    }
    ++share[longest];
  }
  return share;
}

}  // namespace

template <int D>
std::vector<Station> place_stations(const Curve<D>& curve, int cells) {
  const std::span<const double> ends = curve.end_lengths();
  const std::size_t segments = ends.size();
  std::vector<std::size_t> piece_ends;  // one past the last segment of each smooth piece
  for (std::size_t i = 1; i < segments; ++i) {
    if (curve.is_corner(i)) piece_ends.push_back(i);
  }
  piece_ends.push_back(segments);

  std::vector<double> lengths;
  double start = 0;
  for (const std::size_t end : piece_ends) {
    lengths.push_back(ends[end - 1] - start);
    start = ends[end - 1];
  }
  const std::vector<int> share = share_cells(lengths, cells);

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
        station.is_corner = piece > 0 || (curve.is_closed() && curve.is_corner(0));
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

template std::vector<Station> place_stations<2>(const Curve<2>&, int);
template std::vector<Station> place_stations<3>(const Curve<3>&, int);
template std::vector<Station> reversed<2>(const Curve<2>&, std::vector<Station>);

}  // namespace sweepkit::sweep
