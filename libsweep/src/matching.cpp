// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Two contours with different corners, point by point. Each is measured by its length. A start is found on
// the second such that points move least (least squares about the centroids); corners are then paired in
// order, as sequences are aligned: the pairing of greatest gain, a pair's gain falling from 1 to 0 as the two
// lie farther apart along the contours (dynamic programming). Between pairs the lengths go evenly.
// Of the starts the best one is taken for which no shape on the way crosses itself.

#include "matching.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "outline_crossing.hpp"

namespace sweepkit::sweep {
namespace {

// Points a contour that starts are compared by.
constexpr int kSamples = 120;
// Corners farther apart along the contours than this share are no pair.
constexpr double kFarthestPair = 0.25;
// More pairs of corners than this are not tried; lengths alone match contours of so many.
constexpr std::size_t kMostPairs = 1 << 22;
// Starts looked at for crossings.
constexpr std::size_t kMostStarts = 24;
// Places nearer than this along a contour are one.
constexpr double kSamePlace = 1e-9;

double round_about(double at) {
  return at - std::floor(at);
}

struct Pair {
  std::size_t from, to;  // indices of corners
};

// Corners at ascending places, paired in order for the greatest gain.
std::vector<Pair> pair_corners(const std::vector<double>& from, const std::vector<double>& to) {
  const std::size_t n = from.size();
  const std::size_t m = to.size();
  if (n == 0 || m == 0 || n * m > kMostPairs) return {};
  // gain[i][j]: of the first i and j corners.
  std::vector<double> gain((n + 1) * (m + 1), 0.0);
  const auto at = [&](std::size_t i, std::size_t j) -> double& { return gain[i * (m + 1) + j]; };
  const auto pair_gain = [&](std::size_t i, std::size_t j) {
    return 1 - std::abs(from[i] - to[j]) / kFarthestPair;
  };
  for (std::size_t i = 1; i <= n; ++i) {
    for (std::size_t j = 1; j <= m; ++j) {
      at(i, j) = std::max({at(i - 1, j), at(i, j - 1), at(i - 1, j - 1) + pair_gain(i - 1, j - 1)});
    }
  }
  std::vector<Pair> pairs;
  for (std::size_t i = n, j = m; i > 0 && j > 0;) {
    if (at(i, j) == at(i - 1, j)) {
      --i;
    } else if (at(i, j) == at(i, j - 1)) {
      --j;
    } else {
      pairs.push_back({--i, --j});
    }
  }
  std::reverse(pairs.begin(), pairs.end());
  return pairs;
}

// Places beyond `start`, once round.
std::vector<double> corners_after(const Walk& walk, double start) {
  std::vector<double> places;
  places.reserve(walk.corners().size());
  for (const Walk::Corner& corner : walk.corners()) {
    const double place = walk.curve().is_closed() ? round_about(corner.at - start) : corner.at - start;
    if (place > kSamePlace && place < 1 - kSamePlace) places.push_back(place);
  }
  std::sort(places.begin(), places.end());
  return places;
}

// Knots from the pair of starts once round to it again.
RisingMap map_between(const Walk& from, const Walk& to, double from_start, double to_start) {
  const std::vector<double> a = corners_after(from, from_start);
  const std::vector<double> b = corners_after(to, to_start);
  std::vector<glm::dvec2> knots = {{0, 0}};
  for (const Pair& pair : pair_corners(a, b)) knots.emplace_back(a[pair.from], b[pair.to]);
  knots.emplace_back(1, 1);
  if (from_start == 0) {
    for (glm::dvec2& knot : knots) knot.y += to_start;
    return {knots};
  }
  // Cut open at 0 instead.
  const RisingMap round{knots};
  const double seam = 1 - from_start;
  const double y_at_seam = round.at(seam);
  RisingMap map{{{0, to_start + y_at_seam - 1}}};
  for (const glm::dvec2& knot : knots) {
    if (knot.x > seam + kSamePlace && knot.x < 1)
      map.knots.emplace_back(knot.x - seam, to_start + knot.y - 1);
  }
  for (const glm::dvec2& knot : knots) {
    if (knot.x < seam - kSamePlace) map.knots.emplace_back(knot.x + from_start, to_start + knot.y);
  }
  map.knots.emplace_back(1, to_start + y_at_seam);
  return map;
}

struct Start {
  double from, to;
  double cost;  // mean squared way
};

std::vector<glm::dvec2> about_centroid(const Walk& walk) {
  std::vector<glm::dvec2> points(kSamples);
  glm::dvec2 sum(0.0);
  for (int i = 0; i < kSamples; ++i) sum += points[i] = walk.position(static_cast<double>(i) / kSamples);
  for (glm::dvec2& p : points) p -= sum / static_cast<double>(kSamples);
  return points;
}

// Places where the second contour may begin, best first: a corner on a corner, or where one has none any
// place.
std::vector<Start> find_starts(const Walk& from, const Walk& to) {
  const std::vector<glm::dvec2> a = about_centroid(from);
  const std::vector<glm::dvec2> b = about_centroid(to);
  const auto cost = [&](double shift) {
    double sum = 0;
    for (int i = 0; i < kSamples; ++i) {
      const double at = round_about(static_cast<double>(i) / kSamples + shift) * kSamples;
      const int low = static_cast<int>(at) % kSamples;
      const glm::dvec2 there = glm::mix(b[low], b[(low + 1) % kSamples], at - std::floor(at));
      sum += glm::dot(there - a[i], there - a[i]);
    }
    return sum / kSamples;
  };
  std::vector<Start> starts;
  const auto& from_corners = from.corners();
  const auto& to_corners = to.corners();
  if (!from_corners.empty() && !to_corners.empty()) {
    // Of many corners every few will do for a start.
    const std::size_t step = 1 + std::max(from_corners.size(), to_corners.size()) / 64;
    for (std::size_t i = 0; i < from_corners.size(); i += step) {
      for (std::size_t j = 0; j < to_corners.size(); j += step) {
        starts.push_back({from_corners[i].at, to_corners[j].at, cost(to_corners[j].at - from_corners[i].at)});
      }
    }
  } else {
    for (int k = 0; k < kSamples; ++k) {
      const double shift = static_cast<double>(k) / kSamples;
      starts.push_back({0, shift, cost(shift)});
    }
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Start& x, const Start& y) { return x.cost < y.cost; });
  if (from_corners.empty() || to_corners.empty()) {
    // The best start may lie between two samples.
    double low = starts.front().to - 1.0 / kSamples;
    double high = starts.front().to + 1.0 / kSamples;
    for (int step = 0; step < 40; ++step) {
      const double third = (high - low) / 3;
      if (cost(low + third) <= cost(high - third)) {
        high -= third;
      } else {
        low += third;
      }
    }
    double shift = 0.5 * (low + high);
    // A contour's own start is kept where moving it gains next to nothing: a thousandth of the square of
    // their size is what turning two circles by 2 degrees costs.
    double size_squared = 0;
    for (int i = 0; i < kSamples; ++i) size_squared += glm::dot(a[i], a[i]) / kSamples;
    if (cost(0) <= cost(shift) + 1e-3 * size_squared) shift = 0;
    starts.insert(starts.begin(), {0, shift, cost(shift)});
  }
  return starts;
}

bool crosses_on_the_way(const Walk& from, const Walk& to, const RisingMap& map) {
  std::vector<glm::dvec2> a(kSamples);
  std::vector<glm::dvec2> b(kSamples);
  for (int i = 0; i < kSamples; ++i) {
    const double at = static_cast<double>(i) / kSamples;
    a[i] = from.position(at);
    b[i] = to.position(map.at(at));
  }
  for (const double t : {0.25, 0.5, 0.75}) {
    std::vector<glm::dvec2> between(kSamples);
    for (int i = 0; i < kSamples; ++i) between[i] = glm::mix(a[i], b[i], t);
    if (find_crossing(between, true)) return true;
  }
  return false;
}

}  // namespace

Walk::Walk(const Curve2& curve, bool is_backward) : curve_(&curve), is_backward_(is_backward) {
  const std::span<const double> ends = curve.end_lengths();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (!curve.is_corner(i)) continue;
    const double along = i == 0 ? 0 : ends[i - 1] / curve.length();
    corners_.push_back({is_backward && along > 0 ? 1 - along : along, i});
  }
  std::sort(corners_.begin(), corners_.end(), [](const Corner& a, const Corner& b) { return a.at < b.at; });
}

Walk::Place Walk::place(double at) const {
  const bool is_closed = curve_->is_closed();
  const double wanted = is_closed ? round_about(at) : std::clamp(at, 0.0, 1.0);
  for (auto corner = std::lower_bound(corners_.begin(), corners_.end(), wanted - kSamePlace,
                                      [](const Corner&c, double value) { return c.at < value; });
       corner != corners_.end() && corner->at <= wanted + kSamePlace; ++corner) {
    const std::size_t before = corner->segment == 0 ? curve_->segments().size() - 1 : corner->segment - 1;
    const CurveLocation in{before, 1};
    const CurveLocation out{corner->segment, 0};
    return is_backward_ ? Place{out, in, true} : Place{in, out, true};
  }
  if (is_closed && wanted > 1 - kSamePlace && !corners_.empty() && corners_.front().at == 0) return place(0);
  const CurveLocation location = curve_->locate((is_backward_ ? 1 - wanted : wanted) * curve_->length());
  return {location, location};
}

glm::dvec2 Walk::position(double at) const {
  return curve_->evaluate(place(at).out).position;
}

double RisingMap::at(double x) const {
  const auto after = std::upper_bound(knots.begin() + 1, knots.end() - 1, x,
                                      [](double value, const glm::dvec2& knot) { return value < knot.x; });
  const glm::dvec2& low = *(after - 1);
  return low.y + (x - low.x) * ((after->y - low.y) / (after->x - low.x));
}

double RisingMap::inverse(double y) const {
  const auto after = std::upper_bound(knots.begin() + 1, knots.end() - 1, y,
                                      [](double value, const glm::dvec2& knot) { return value < knot.y; });
  const glm::dvec2& low = *(after - 1);
  return low.x + (y - low.y) * ((after->x - low.x) / (after->y - low.y));
}

RisingMap match(const Walk& from, const Walk& to) {
  if (!from.curve().is_closed()) return map_between(from, to, 0, 0);
  const std::vector<Start> starts = find_starts(from, to);
  std::optional<RisingMap> best;
  for (std::size_t i = 0; i < std::min(starts.size(), kMostStarts); ++i) {
    RisingMap map = map_between(from, to, starts[i].from, starts[i].to);
    if (!crosses_on_the_way(from, to, map)) return map;
    if (!best) best = std::move(map);
  }
  return *best;
}

}  // namespace sweepkit::sweep
