// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The winding number by crossings [Sunday 2001]: of the ray from the point to +x, an edge that crosses it
// upwards counts 1, downwards -1; an edge owns its lower end and not its upper one, so that a vertex on the
// ray counts once.
#include "winding.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace sweepkit::scene {

Winding::Winding(std::vector<Edge> edges) : edges_(std::move(edges)) {
  low_ = std::numeric_limits<double>::infinity();
  double high = -low_;
  for (const Edge& edge : edges_) {
    low_ = std::min({low_, edge.from.y, edge.to.y});
    high = std::max({high, edge.from.y, edge.to.y});
  }
  std::size_t strips = std::max<std::size_t>(edges_.size() / 2, 1);
  const auto settle = [&] {
    strips_per_length_ = high > low_ ? static_cast<double>(strips) / (high - low_) : 0;
  };
  // Long edges stand in many strips. Eight entries an edge at most keep the memory in bounds.
  const auto entries = [&] {
    return std::accumulate(
        edges_.begin(), edges_.end(), std::size_t{0}, [&](std::size_t sum, const Edge& edge) {
          const auto [bottom, top] = std::minmax(edge.from.y, edge.to.y);
          return sum + std::min(strip_of(top), strips - 1) - std::min(strip_of(bottom), strips - 1) + 1;
        });
  };
  for (settle(); strips > 1 && entries() > 8 * edges_.size(); settle()) strips /= 2;

  const auto for_each_entry = [&](const auto& visit) {
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      const auto [bottom, top] = std::minmax(edges_[i].from.y, edges_[i].to.y);
      const std::size_t last = std::min(strip_of(top), strips - 1);
      for (std::size_t s = std::min(strip_of(bottom), strips - 1); s <= last; ++s) visit(s, i);
    }
  };
  strip_starts_.assign(strips + 1, 0);
  for_each_entry([&](std::size_t strip, std::uint32_t) { ++strip_starts_[strip + 1]; });
  std::partial_sum(strip_starts_.begin(), strip_starts_.end(), strip_starts_.begin());
  strip_edges_.resize(strip_starts_.back());
  std::vector<std::size_t> next(strip_starts_.begin(), strip_starts_.end() - 1);
  for_each_entry([&](std::size_t strip, std::uint32_t edge) { strip_edges_[next[strip]++] = edge; });
}

std::size_t Winding::strip_of(double y) const {
  return static_cast<std::size_t>(std::max(0.0, (y - low_) * strips_per_length_));
}

std::size_t Winding::count(const glm::dvec2& point, std::vector<int>& turns) const {
  if (edges_.empty() || point.y < low_) return 0;
  const std::size_t strip = std::min(strip_of(point.y), strip_starts_.size() - 2);
  for (std::size_t k = strip_starts_[strip]; k < strip_starts_[strip + 1]; ++k) {
    const Edge& edge = edges_[strip_edges_[k]];
    const bool is_upward = edge.from.y <= point.y && point.y < edge.to.y;
    const bool is_downward = edge.to.y <= point.y && point.y < edge.from.y;
    if (!is_upward && !is_downward) continue;
    const glm::dvec2 along = edge.to - edge.from;
    const glm::dvec2 to_point = point - edge.from;
    const double side = along.x * to_point.y - along.y * to_point.x;  // above 0: left of the edge
    if (is_upward && side > 0) ++turns[edge.shape];
    if (is_downward && side < 0) --turns[edge.shape];
  }
  return strip_starts_[strip + 1] - strip_starts_[strip];
}

}  // namespace sweepkit::scene
