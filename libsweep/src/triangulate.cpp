// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Flat caps. A strictly convex outline is halved again and again (every second vertex cut off), which keeps
// the triangles far fatter than a fan; any other is clipped ear by ear (Meisters 1975). An ear whose closure
// holds another vertex is not cut, even if that vertex only lies on its new edge: so points in a row on a
// straight side never end as a flat triangle.
// Departs from the textbook's in the search for vertices inside an ear: a binary tree of bounding boxes over
// the outline's order, whose neighbours lie near each other, finds them in about log n instead of n steps.

#include "triangulate.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "bridge_holes.hpp"
#include "delaunay_flips.hpp"

namespace sweepkit::sweep {
namespace {

// Points placed on a straight side are off it by rounding: a corner this flat (sine) is none, or float32
// would make a triangle of zero area of it.
constexpr double kFlat = 1e-6;
// A point this near to an ear, as a share of the ear's longest side, is in it.
constexpr double kNear = 1e-9;

// Twice the area of a, b, c. Plain double: what hangs on its sign is decided with margins (kFlat, kNear) that
// are a million times its rounding.
double orient(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool is_strictly_convex(std::span<const glm::dvec2> polygon) {
  const std::size_t n = polygon.size();
  int x_turns = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2& a = polygon[i];
    const glm::dvec2& b = polygon[(i + 1) % n];
    const glm::dvec2& c = polygon[(i + 2) % n];
    // Corners this flat would leave slivers when every second vertex is cut off.
    if (!(orient(a, b, c) > kFlat * glm::length(b - a) * glm::length(c - b))) return false;
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

struct Box {
  glm::dvec2 low{std::numeric_limits<double>::infinity()};
  glm::dvec2 high{-std::numeric_limits<double>::infinity()};

  bool meets(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
  }
};

Box around(const Box& a, const Box& b) {
  return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

// The vertices not yet clipped, in the outline's order, under a binary tree of their boxes.
class VertexTree {
 public:
  explicit VertexTree(std::span<const glm::dvec2> points)
      : leaves_(std::bit_ceil(points.size())), boxes_(2 * leaves_) {
    for (std::size_t i = 0; i < points.size(); ++i) boxes_[leaves_ + i] = {points[i], points[i]};
    for (std::size_t i = leaves_ - 1; i > 0; --i) boxes_[i] = around(boxes_[2 * i], boxes_[2 * i + 1]);
  }

  void remove(std::uint32_t vertex) {
    std::size_t i = leaves_ + vertex;
    boxes_[i] = {};
    while ((i /= 2) > 0) boxes_[i] = around(boxes_[2 * i], boxes_[2 * i + 1]);
  }

  // Does `holds` say yes to any vertex in the box?
  template <class Holds>
  bool any_in(const Box& box, const Holds& holds, std::size_t node = 1) const {
    if (!boxes_[node].meets(box)) return false;
    if (node >= leaves_) return holds(static_cast<std::uint32_t>(node - leaves_));
    return any_in(box, holds, 2 * node) || any_in(box, holds, 2 * node + 1);
  }

 private:
  std::size_t leaves_;
  std::vector<Box> boxes_;  // node i has the children 2i and 2i + 1; leaf k is node leaves_ + k
};

class EarClipper {
 public:
  explicit EarClipper(std::span<const glm::dvec2> polygon) : polygon_(polygon), left_(polygon) {
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
        left_.remove(current);
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
  bool is_ear(std::uint32_t vertex, int leniency) const {
    if (leniency >= 2) return true;
    const glm::dvec2& a = polygon_[previous_[vertex]];
    const glm::dvec2& b = polygon_[vertex];
    const glm::dvec2& c = polygon_[next_[vertex]];
    const double ab = glm::length(b - a);
    const double bc = glm::length(c - b);
    const double ca = glm::length(a - c);
    if (!(orient(a, b, c) > kFlat * ab * bc)) return false;
    if (leniency == 1) return true;
    const double near = kNear * std::max({ab, bc, ca});
    const Box box{glm::min(glm::min(a, b), c) - near, glm::max(glm::max(a, b), c) + near};
    return !left_.any_in(box, [&](std::uint32_t other) {
      const glm::dvec2& p = polygon_[other];
      if (p == a || p == b || p == c) return false;
      return orient(a, b, p) >= -near * ab && orient(b, c, p) >= -near * bc && orient(c, a, p) >= -near * ca;
    });
  }

  std::span<const glm::dvec2> polygon_;
  VertexTree left_;
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
  std::vector<Triangle> triangles = EarClipper(polygon).clip();
  flip_to_delaunay(polygon, triangles);
  return triangles;
}

std::vector<Triangle> triangulate_region(std::span<const std::vector<glm::dvec2>> outlines) {
  if (outlines.size() == 1) return triangulate_polygon(outlines.front());
  std::vector<glm::dvec2> points;
  for (const std::vector<glm::dvec2>& outline : outlines)
    points.insert(points.end(), outline.begin(), outline.end());
  const std::vector<std::uint32_t> ring = bridge_holes(outlines);
  std::vector<glm::dvec2> round;
  round.reserve(ring.size());
  for (const std::uint32_t vertex : ring) round.push_back(points[vertex]);
  std::vector<Triangle> triangles = EarClipper(round).clip();
  for (Triangle& triangle : triangles) {
    for (std::uint32_t& vertex : triangle) vertex = ring[vertex];
  }
  flip_to_delaunay(points, triangles);
  return triangles;
}

}  // namespace sweepkit::sweep
