// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Sides in the order of their leftmost points: each is held against those that begin before it ends.

#include "outline_crossing.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace sweepkit::sweep {
namespace {

// Twice the signed area of p q r.
double side_of(const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

}  // namespace

std::optional<OutlineCrossing> find_crossing(std::span<const glm::dvec2> points, bool is_closed) {
  const std::size_t n = points.size();
  if (n < 4) return std::nullopt;
  const std::size_t sides = is_closed ? n : n - 1;
  const auto begin = [&](std::size_t i) -> const glm::dvec2& { return points[i]; };
  const auto end = [&](std::size_t i) -> const glm::dvec2& { return points[(i + 1) % n]; };
  const auto left = [&](std::size_t i) { return std::min(begin(i).x, end(i).x); };
  std::vector<std::size_t> order(sides);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return left(a) != left(b) ? left(a) < left(b) : a < b; });
  for (std::size_t k = 0; k < sides; ++k) {
    const std::size_t i = order[k];
    const double right = std::max(begin(i).x, end(i).x);
    for (std::size_t l = k + 1; l < sides && left(order[l]) <= right; ++l) {
      const std::size_t j = order[l];
      if ((i + 1) % n == j || (j + 1) % n == i) continue;
      const double from = side_of(begin(j), end(j), begin(i));
      const double to = side_of(begin(j), end(j), end(i));
      if (!(from * to < 0)) continue;
      if (!(side_of(begin(i), end(i), begin(j)) * side_of(begin(i), end(i), end(j)) < 0)) continue;
      return OutlineCrossing{std::min(i, j), std::max(i, j),
                             begin(i) + from / (from - to) * (end(i) - begin(i))};
    }
  }
  return std::nullopt;
}

}  // namespace sweepkit::sweep
