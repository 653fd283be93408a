// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace sweepkit::scene {

/// A straight edge of an outline of the shape of that number.
struct Edge {
  glm::dvec2 from;
  glm::dvec2 to;
  std::uint32_t shape;
};

/// How often closed polygons wind round a point, for each shape. The edges lie sorted into horizontal
/// strips, so that a question looks only at those near the point's height.
class Winding {
 public:
  explicit Winding(std::vector<Edge> edges);

  /// Adds the turns round `point`, counter-clockwise positive, to `turns`, one number a shape. Returns the
  /// number of edges looked at.
  std::size_t count(const glm::dvec2& point, std::vector<int>& turns) const;

 private:
  std::size_t strip_of(double y) const;

  std::vector<Edge> edges_;
  double low_ = 0;
  double strips_per_length_ = 0;
  std::vector<std::size_t> strip_starts_;  // into strip_edges_; one more than there are strips
  std::vector<std::uint32_t> strip_edges_;
};

}  // namespace sweepkit::scene
