// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// C. L. Lawson, "Software for C1 surface interpolation" (1977): an edge whose two opposite angles add up to
// more than 180 degrees is replaced by the other diagonal of its quadrilateral. A flat cap clipped ear by ear
// has triangles so thin along gently bent sides that float32 positions turn them over; these go.

#include "delaunay_flips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

namespace sweepkit::sweep {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
// Angles that add up to this much more than 180 degrees (radians): points of a circle are left as they are.
constexpr double kMargin = 1e-9;
// Edges turned for each triangle, at most; a few are usual, and what is left after that is still valid.
constexpr std::size_t kMostFlips = 64;

class Flipper {
 public:
  Flipper(std::span<const glm::dvec2> points, std::vector<Triangle>& triangles)
      : points_(points), triangles_(triangles), across_(triangles.size(), {kNone, kNone, kNone}) {
    find_neighbours();
  }

  void run() {
    std::vector<std::uint32_t> open;
    open.reserve(triangles_.size());
    for (std::size_t i = triangles_.size(); i-- > 0;) open.push_back(static_cast<std::uint32_t>(i));
    std::size_t left = kMostFlips * triangles_.size();
    while (!open.empty() && left > 0) {
      const std::uint32_t triangle = open.back();
      open.pop_back();
      for (std::uint32_t side = 0; side < 3; ++side) {
        const std::uint32_t other = across_[triangle][side];
        if (other == kNone || !is_wide(triangle, side, other)) continue;
        flip(triangle, side, other);
        open.push_back(other);
        open.push_back(triangle);
        --left;
        break;
      }
    }
  }

 private:
  // Side k runs from vertex k to the next.
  void find_neighbours() {
    struct Edge {
      std::uint32_t low, high, triangle, side;
    };
    std::vector<Edge> edges;
    edges.reserve(3 * triangles_.size());
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = triangles_[i][k];
        const std::uint32_t b = triangles_[i][(k + 1) % 3];
        edges.push_back({std::min(a, b), std::max(a, b), i, k});
      }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
      return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      const Edge& a = edges[i];
      const Edge& b = edges[i + 1];
      if (a.low != b.low || a.high != b.high) continue;
      across_[a.triangle][a.side] = b.triangle;
      across_[b.triangle][b.side] = a.triangle;
      ++i;
    }
  }

  std::uint32_t side_towards(std::uint32_t triangle, std::uint32_t neighbour) const {
    for (std::uint32_t k = 0; k < 2; ++k) {
      if (across_[triangle][k] == neighbour) return k;
    }
    return 2;
  }

  const glm::dvec2& point(std::uint32_t triangle, std::uint32_t corner) const {
    return points_[triangles_[triangle][corner % 3]];
  }

  // The sine and cosine of the angle at b, times the lengths of its sides.
  static glm::dvec2 angle(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    const glm::dvec2 u = a - b;
    const glm::dvec2 v = c - b;
    return {v.x * u.y - v.y * u.x, glm::dot(u, v)};
  }

  bool is_wide(std::uint32_t triangle, std::uint32_t side, std::uint32_t other) const {
    const glm::dvec2& a = point(triangle, side);
    const glm::dvec2& b = point(triangle, side + 1);
    const glm::dvec2& c = point(triangle, side + 2);
    const glm::dvec2& d = point(other, side_towards(other, triangle) + 2);
    const glm::dvec2 at_c = angle(b, c, a);
    const glm::dvec2 at_d = angle(a, d, b);
    const double sine = at_c.x * at_d.y + at_c.y * at_d.x;
    if (!(sine < -kMargin * glm::length(at_c) * glm::length(at_d))) return false;
    // Both new triangles are to turn left.
    return angle(d, a, c).x < 0 && angle(c, b, d).x < 0 && angle(a, c, d).x < 0 && angle(d, c, b).x < 0;
  }

  // Triangles (a, b, c) and (b, a, d) become (a, d, c) and (d, b, c).
  void flip(std::uint32_t triangle, std::uint32_t side, std::uint32_t other) {
    const std::uint32_t other_side = side_towards(other, triangle);
    const std::uint32_t a = triangles_[triangle][side];
    const std::uint32_t b = triangles_[triangle][(side + 1) % 3];
    const std::uint32_t c = triangles_[triangle][(side + 2) % 3];
    const std::uint32_t d = triangles_[other][(other_side + 2) % 3];
    const std::uint32_t bc = across_[triangle][(side + 1) % 3];
    const std::uint32_t ca = across_[triangle][(side + 2) % 3];
    const std::uint32_t ad = across_[other][(other_side + 1) % 3];
    const std::uint32_t db = across_[other][(other_side + 2) % 3];
    triangles_[triangle] = {a, d, c};
    across_[triangle] = {ad, other, ca};
    triangles_[other] = {d, b, c};
    across_[other] = {db, bc, triangle};
    if (ad != kNone) across_[ad][side_towards(ad, other)] = triangle;
    if (bc != kNone) across_[bc][side_towards(bc, triangle)] = other;
  }

  std::span<const glm::dvec2> points_;
  std::vector<Triangle>& triangles_;
  std::vector<std::array<std::uint32_t, 3>> across_;
};

}  // namespace

void flip_to_delaunay(std::span<const glm::dvec2> points, std::vector<Triangle>& triangles) {
  Flipper(points, triangles).run();
}

}  // namespace sweepkit::sweep
