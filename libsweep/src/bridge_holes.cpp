// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on D. Eberly, "Triangulation by ear clipping" (Geometric Tools, 2002): the holes are taken from the
// right to the left, and each is joined by its rightmost vertex M to a vertex of the ring that M sees. A ray
// from M to the right meets the ring at I on an edge, P the edge's end farther right: M sees P unless reflex
// vertices lie in the triangle M I P; then it sees the one at the least angle to the ray.

#include "bridge_holes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace sweepkit::sweep {
namespace {

double orient(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class Ring {
 public:
  Ring(std::vector<glm::dvec2> points, std::size_t outer) : points_(std::move(points)) {
    for (std::size_t i = 0; i < outer; ++i) ring_.push_back(static_cast<std::uint32_t>(i));
  }

  const std::vector<std::uint32_t>& vertices() const { return ring_; }

  /// Joins the hole that is vertices first..end-1.
  void join(std::size_t first, std::size_t end) {
    std::size_t rightmost = first;
    for (std::size_t i = first; i < end; ++i) {
      if (points_[i].x > points_[rightmost].x) rightmost = i;
    }
    const std::size_t at = place_towards(seen_from(points_[rightmost]), points_[rightmost]);
    std::vector<std::uint32_t> detour;
    detour.reserve(end - first + 2);
    for (std::size_t i = rightmost; i < end; ++i) detour.push_back(static_cast<std::uint32_t>(i));
    for (std::size_t i = first; i <= rightmost; ++i) detour.push_back(static_cast<std::uint32_t>(i));
    detour.push_back(ring_[at]);
    ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(at) + 1, detour.begin(), detour.end());
  }

 private:
  const glm::dvec2& point(std::size_t at) const { return points_[ring_[at % ring_.size()]]; }

  // Is `p` between the ring's two edges at this place, on the inside?
  bool opens_towards(std::size_t at, const glm::dvec2& p) const {
    const glm::dvec2& before = point(at + ring_.size() - 1);
    const glm::dvec2& here = point(at);
    const glm::dvec2& after = point(at + 1);
    if (orient(before, here, after) >= 0) return orient(before, here, p) >= 0 && orient(here, after, p) >= 0;
    return orient(before, here, p) >= 0 || orient(here, after, p) >= 0;
  }

  // A vertex that has been joined before stands in the ring more than once, each time with other edges: the
  // place whose edges have `m` between them.
  std::size_t place_towards(std::size_t at, const glm::dvec2& m) const {
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      if (ring_[k] == ring_[at] && opens_towards(k, m)) return k;
    }
    return at;
  }

  std::size_t seen_from(const glm::dvec2& m) const {
    std::optional<std::size_t> hit;  // the edge from here on
    double x = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const glm::dvec2& a = point(i);
      const glm::dvec2& b = point(i + 1);
      // The inside is to the left of an edge, so it is one that runs upwards.
      if (!(a.y <= m.y && m.y <= b.y && a.y < b.y)) continue;
      const double crossing = a.x + (b.x - a.x) * ((m.y - a.y) / (b.y - a.y));
      if (crossing >= m.x && crossing < x) {
        x = crossing;
        hit = i;
      }
    }
    if (!hit) return nearest(m);
    const std::size_t p = point(*hit).x > point(*hit + 1).x ? *hit : (*hit + 1) % ring_.size();
    const glm::dvec2 i(x, m.y);
    if (point(p) == i) return p;
    std::size_t best = p;
    double least_slope = std::numeric_limits<double>::infinity();
    const double side = orient(m, i, point(p)) > 0 ? 1 : -1;
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      const glm::dvec2& q = point(k);
      if (q.x <= m.x || q == point(p)) continue;
      const bool is_inside = side * orient(m, i, q) >= 0 && side * orient(i, point(p), q) >= 0 &&
                             side * orient(point(p), m, q) >= 0;
      if (!is_inside || !opens_towards(k, m)) continue;
      const double slope = std::abs(q.y - m.y) / (q.x - m.x);
      if (slope < least_slope || (slope == least_slope && q.x < point(best).x)) {
        least_slope = slope;
        best = k;
      }
    }
    return best;
  }

  // For a hole that touches the outline it should lie in.
  std::size_t nearest(const glm::dvec2& m) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < ring_.size(); ++i) {
      if (glm::length(point(i) - m) < glm::length(point(best) - m)) best = i;
    }
    return best;
  }

  std::vector<glm::dvec2> points_;
  std::vector<std::uint32_t> ring_;
};

}  // namespace

std::vector<std::uint32_t> bridge_holes(std::span<const std::vector<glm::dvec2>> outlines) {
  std::vector<glm::dvec2> points;
  struct Hole {
    std::size_t first, end;
    double right;
  };
  std::vector<Hole> holes;
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    const std::size_t first = points.size();
    points.insert(points.end(), outlines[k].begin(), outlines[k].end());
    if (k == 0) continue;
    double right = -std::numeric_limits<double>::infinity();
    for (const glm::dvec2& p : outlines[k]) right = std::max(right, p.x);
    holes.push_back({first, points.size(), right});
  }
  std::stable_sort(holes.begin(), holes.end(),
                   [](const Hole& a, const Hole& b) { return a.right > b.right; });
  Ring ring(std::move(points), outlines.front().size());
  for (const Hole& hole : holes) ring.join(hole.first, hole.end);
  return ring.vertices();
}

}  // namespace sweepkit::sweep
