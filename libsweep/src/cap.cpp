// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Flat caps. A strictly convex outline is halved again and again (every second vertex cut off), which keeps
// the triangles far fatter than a fan; any other is clipped ear by ear (Meisters 1975). An ear whose closure
// holds another vertex is not cut, even if that vertex only lies on its new edge: so points in a row on a
// straight side never end as a flat triangle.

#include "cap.hpp"

#include <algorithm>

namespace sweepkit::sweep {
namespace {

// Twice the area of a, b, c; the sign is wanted, so the products are taken in extended precision.
long double orient(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const long double abx = static_cast<long double>(b.x) - a.x;
  const long double aby = static_cast<long double>(b.y) - a.y;
  const long double acx = static_cast<long double>(c.x) - a.x;
  const long double acy = static_cast<long double>(c.y) - a.y;
  return abx * acy - aby * acx;
}

bool is_strictly_convex(std::span<const glm::dvec2> polygon) {
  const std::size_t n = polygon.size();
  int x_turns = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2& a = polygon[i];
    const glm::dvec2& b = polygon[(i + 1) % n];
    const glm::dvec2& c = polygon[(i + 2) % n];
    // Corners this flat would leave slivers when every second vertex is cut off.
    if (!(orient(a, b, c) > 1e-6L * glm::length(b - a) * glm::length(c - b))) return false;
    if ((b.x - a.x > 0) != (c.x - b.x > 0)) ++x_turns;
  }
  return x_turns <= 2;  // once round
}

std::vector<Triangle> halve(std::size_t count) {
  std::vector<std::uint32_t> ring(count);
  for (std::size_t i = 0; i < count; ++i) ring[i] = static_cast<std::uint32_t>(i);
  std::vector<Triangle> triangles;
  while (ring.size() > 2) {
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < ring.size(); i += 2) {
      kept.push_back(ring[i]);
      if (i + 1 < ring.size() && (i + 2 < ring.size() || ring.size() % 2 == 0)) {
        triangles.push_back({ring[i], ring[i + 1], ring[(i + 2) % ring.size()]});
      }
    }
    ring = std::move(kept);
  }
  return triangles;
}

class EarClipper {
 public:
  explicit EarClipper(std::span<const glm::dvec2> polygon) : polygon_(polygon) {
    const auto n = static_cast<std::uint32_t>(polygon.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      next_.push_back((i + 1) % n);
      previous_.push_back((i + n - 1) % n);
    }
  }

  std::vector<Triangle> clip() {
    std::vector<Triangle> triangles;
    std::uint32_t current = 0;
    std::size_t left = polygon_.size();
    std::size_t looked_at = 0;
    int leniency =
        0;  // 0: true ears alone; 1: whatever turns left; 2: anything, for outlines that cross themselves
    while (left > 3) {
      if (is_ear(current, leniency)) {
        triangles.push_back({previous_[current], current, next_[current]});
        next_[previous_[current]] = next_[current];
        previous_[next_[current]] = previous_[current];
        current = next_[next_[current]];  // skipping one keeps the triangles from fanning about one vertex
        --left;
        looked_at = 0;
        leniency = 0;
      } else {
        current = next_[current];
        if (++looked_at > left) {
          ++leniency;
          looked_at = 0;
        }
      }
    }
    triangles.push_back({previous_[current], current, next_[current]});
    return triangles;
  }

 private:
  // Points placed on a straight side are off it by rounding; a corner this flat (sine) is no ear, and a point
  // this near to an ear (share of the corner's reach) is in it, or float32 would make a triangle of zero area
  // of it.
  static constexpr long double kFlat = 1e-6L;
  static constexpr long double kNear = 1e-9L;

  bool is_ear(std::uint32_t vertex, int leniency) const {
    if (leniency >= 2) return true;
    const glm::dvec2& a = polygon_[previous_[vertex]];
    const glm::dvec2& b = polygon_[vertex];
    const glm::dvec2& c = polygon_[next_[vertex]];
    const double reach = glm::length(b - a) * glm::length(c - b);
    if (!(orient(a, b, c) > kFlat * reach)) return false;
    if (leniency == 1) return true;
    for (std::uint32_t other = next_[next_[vertex]]; other != previous_[vertex]; other = next_[other]) {
      const glm::dvec2& p = polygon_[other];
      if (p == a || p == b || p == c) continue;
      const long double tolerance = -kNear * (reach + glm::length(p - b) * glm::length(c - a));
      if (orient(a, b, p) >= tolerance && orient(b, c, p) >= tolerance && orient(c, a, p) >= tolerance)
        return false;
    }
    return true;
  }

  std::span<const glm::dvec2> polygon_;
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t> previous_;
};

}  // namespace

double twice_signed_area(std::span<const glm::dvec2> polygon) {
  double sum = 0;
  const glm::dvec2 about = polygon.front();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i] - about;
    const glm::dvec2 b = polygon[i + 1] - about;
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

std::vector<Triangle> triangulate_polygon(std::span<const glm::dvec2> polygon) {
  if (polygon.size() < 3) return {};
  if (is_strictly_convex(polygon)) return halve(polygon.size());
  return EarClipper(polygon).clip();
}

}  // namespace sweepkit::sweep
