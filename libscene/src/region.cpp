// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "region.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "outline.hpp"
#include "sweepkit/error.hpp"
#include "winding.hpp"

namespace sweepkit::scene {
namespace {

using Polygon = std::vector<glm::dvec2>;

// Sixteen chords a quarter turn, or a Bezier segment: within 1.2e-3 of an arc's radius. Concentric rings are
// flattened alike, so that not even thin walls cross.
constexpr int kChords = 16;

// Edges of an outline looked at, before it is said to bound nothing.
constexpr std::size_t kMostSamples = 64;
constexpr std::size_t kFewSamples = 8;  // elsewhere than at the middles: long edges are few

// Where along an edge: first its middle, then elsewhere, since what crosses the edge changes its sides. The
// middles of a pentagram's edges, say, have the region on both.
constexpr std::array<double, 7> kAlong = {0.5, 0.1, 0.9, 0.3, 0.7, 0.01, 0.99};

// So many edges are looked at in about a second.
constexpr std::size_t kMostWork = 400'000'000;

Polygon flattened(const sweep::Curve2& curve) {
  Polygon points;
  for (const sweep::Segment<2>& segment : curve.segments()) {
    int chords = kChords;
    if (const auto* bezier = std::get_if<sweep::BezierSegment<2>>(&segment)) {
      if (bezier->control.size() == 2) chords = 1;
    } else {
      const auto& arc = std::get<sweep::ArcSegment<2>>(segment);
      chords = static_cast<int>(std::ceil(std::abs(arc.to_deg - arc.from_deg) / 90 * kChords));
    }
    for (int i = 0; i < chords; ++i) {
      points.push_back(sweep::evaluate<2>(segment, static_cast<double>(i) / chords).position);
    }
  }
  return points;
}

bool is_filled(FillRule rule, int turns) {
  return rule == FillRule::kNonzero ? turns != 0 : turns % 2 != 0;
}

// All shapes' outlines flattened, and the answers that they give.
class Region {
 public:
  Region(std::span<const FilledShape> shapes, const std::vector<std::vector<Polygon>>& polygons)
      : shapes_(shapes), turns_(shapes.size(), 0), winding_(edges_of(polygons)) {
    for (const std::vector<Polygon>& of_shape : polygons) {
      for (const Polygon& polygon : of_shape) {
        for (const glm::dvec2& p : polygon) reach_ = std::max({reach_, std::abs(p.x), std::abs(p.y)});
      }
    }
  }

  bool holds(const glm::dvec2& point) {
    std::fill(turns_.begin(), turns_.end(), 0);
    work_ += winding_.count(point, turns_) + shapes_.size() / 4;  // a shape is cheaper than an edge
    if (work_ > kMostWork) {
      throw InputError(
          "has too many outlines one over another to tell inside from outside; choose an element by "
          "\"id\", or simplify the drawing");
    }
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      if (is_filled(shapes_[i].rule, turns_[i])) return true;
    }
    return false;
  }

  // Has the outline the region on its left and not on its right (true), or the other way round? Nothing where
  // both sides are alike.
  std::optional<bool> left_is_inside(const Polygon& polygon) {
    for (const double share : kAlong) {
      const std::size_t samples = std::min(share == kAlong[0] ? kMostSamples : kFewSamples, polygon.size());
      for (std::size_t k = 0; k < samples; ++k) {
        const std::size_t i = k * polygon.size() / samples;
        const glm::dvec2& from = polygon[i];
        const glm::dvec2 along = polygon[(i + 1) % polygon.size()] - from;
        // Beside the edge by a millionth of its length, nearer than anything drawn; an edge shorter than its
        // ends' rounding has no sides.
        const glm::dvec2 aside = 1e-6 * glm::dvec2(-along.y, along.x);
        if (!(glm::length(aside) > 4 * std::numeric_limits<double>::epsilon() * reach_)) continue;
        const glm::dvec2 at = from + share * along;
        const bool is_left = holds(at + aside);
        if (is_left != holds(at - aside)) return is_left;
      }
    }
    return std::nullopt;
  }

 private:
  static std::vector<Edge> edges_of(const std::vector<std::vector<Polygon>>& polygons) {
    std::vector<Edge> edges;
    for (std::size_t shape = 0; shape < polygons.size(); ++shape) {
      for (const Polygon& polygon : polygons[shape]) {
        for (std::size_t i = 0; i < polygon.size(); ++i) {
          edges.push_back({polygon[i], polygon[(i + 1) % polygon.size()], static_cast<std::uint32_t>(shape)});
        }
      }
    }
    return edges;
  }

  std::span<const FilledShape> shapes_;
  std::vector<int> turns_;
  Winding winding_;
  double reach_ = 0;
  std::size_t work_ = 0;
};

// Those seen before, point for point.
class Duplicates {
 public:
  bool add(const Polygon& polygon) {
    std::array<double, 4> box = {polygon[0].x, polygon[0].y, polygon[0].x, polygon[0].y};
    for (const glm::dvec2& p : polygon) {
      box = {std::min(box[0], p.x), std::min(box[1], p.y), std::max(box[2], p.x), std::max(box[3], p.y)};
    }
    std::vector<const Polygon*>& alike = seen_[box];
    for (const Polygon* other : alike) {
      if (*other == polygon) return false;
    }
    alike.push_back(&polygon);
    return true;
  }

 private:
  std::map<std::array<double, 4>, std::vector<const Polygon*>> seen_;
};

}  // namespace

std::vector<sweep::Curve2> bounding_outlines(std::span<const FilledShape> shapes) {
  std::vector<std::vector<Polygon>> polygons(shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    polygons[i].reserve(shapes[i].outlines.size());
    for (const sweep::Curve2& outline : shapes[i].outlines) polygons[i].push_back(flattened(outline));
  }
  Region region(shapes, polygons);
  Duplicates duplicates;
  std::vector<sweep::Curve2> bounding;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t k = 0; k < polygons[i].size(); ++k) {
      const std::optional<bool> is_left = region.left_is_inside(polygons[i][k]);
      if (!is_left || !duplicates.add(polygons[i][k])) continue;
      const sweep::Curve2& outline = shapes[i].outlines[k];
      bounding.push_back(*is_left ? outline : sweep::Curve2(reversed(outline).segments));
    }
  }
  return bounding;
}

}  // namespace sweepkit::scene
