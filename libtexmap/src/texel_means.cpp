// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Steps that lie along the texel's sides have a mean in closed form. Askew, a part has one colour where the
// box along the axes round it has; others are divided into four, and those again, down to 1/32 of a texel,
// whose box stands for it. So no edge is overlooked, however small what it cuts off.
//
// Of noise, where a texel is smaller than the pattern's detail, the colour at its middle is its mean but
// where the pattern bends: on edges and veins, which a texel's neighbours tell. With d the second difference
// (a + b) / 2 - c along a line of three texels, the mean is c + (d_x + d_y) / 12 for a parabola, and off by
// less than (d_x + d_y) / 4 for a single kink: by one level at most, d being two. A texel that bends is
// divided into four, and those again, until a part is as straight as its size allows; edges cross parts at
// random, so that the errors of the 1 / s parts of side s along an edge add up as those of chance do, to
// s^(3/2) of a part's, and a part may be off by as much more. No straight edge crosses a part unseen: it has
// corners on both sides. Where a texel covers detail, points would alias: it is the mean of parts under
// footprints.

#include "texel_means.hpp"

#include <algorithm>
#include <cmath>

namespace sweepkit::texmap {
namespace {

constexpr int kMostLevels = 4;  // of parts in parts: 1/16 of a texel at least
constexpr int kMostEdgeLevels = 5;
constexpr int kNodes = (2 << kMostLevels) + 1;  // of corners and middles, along a side
constexpr double kLevel = 1.0 / 255;
constexpr double kMostBend = 2;  // levels
constexpr int kParts = 16;

// A texel's side, in details, up to which points tell its mean. Granite's edges are far steeper than its
// noise, so that points are worth more there.
double most_details(ProceduralKind kind) {
  return kind == ProceduralKind::kGranite ? 0.75 : 0.5;
}

// What a level of an 8-bit file is at a colour: of its numbers, linear or sRGB, whichever is finer. The sRGB
// curve's slope lies above the chord of its slopes at the ends.
double level_at(double color) {
  return kLevel * std::min(1.0, 0.077 + 2.2 * color);
}

// Is (a + b) / 2 within `share` levels of c?
bool is_straight(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double share) {
  for (glm::length_t k = 0; k < 3; ++k) {
    if (!(std::abs(0.5 * (a[k] + b[k]) - c[k]) <= share * level_at(c[k]))) return false;
  }
  return true;
}

}  // namespace

TexelScratch::TexelScratch()
    : colors_(static_cast<std::size_t>(kNodes) * kNodes),
      stamps_(static_cast<std::size_t>(kNodes) * kNodes) {}

TexelMeans::TexelMeans(const Procedural& procedural)
    : pattern_(pattern_of(procedural)), detail_(finest_detail(pattern_) / procedural.scale) {}

TexelMeans::Way TexelMeans::way_of(const glm::dvec3& dx, const glm::dvec3& dy) const {
  const bool has_steps = is_of_steps(pattern_.given.kind);
  if (has_steps && lies_along_axes(pattern_.given, dx, dy)) return Way::kBox;
  const double side = std::max(glm::length(dx), glm::length(dy));
  if (!(side < most_details(pattern_.given.kind) * detail_)) return Way::kParts;
  return has_steps ? Way::kEdges : Way::kPoints;
}

std::optional<glm::dvec3> TexelMeans::smooth_mean(const std::array<const glm::dvec3*, 9>& around) {
  const glm::dvec3& middle = *around[4];
  for (std::size_t i = 0; i < 4; ++i) {
    if (!is_straight(*around[i], *around[8 - i], middle, kMostBend)) return std::nullopt;
  }
  return middle + (*around[1] + *around[3] + *around[5] + *around[7] - 4.0 * middle) / 24.0;
}

glm::dvec3 TexelMeans::mean(Way way, const PatternFootprint& texel, TexelScratch& scratch) const {
  switch (way) {
    case Way::kBox:
      return box_mean(pattern_, texel);
    case Way::kEdges:
      return divided_by_edges(texel, kMostEdgeLevels);
    case Way::kPoints:
      return divided(texel, scratch);
    case Way::kParts:
      return mean_of_parts(texel);
  }
  return glm::dvec3(0.0);
}

glm::dvec3 TexelMeans::divided_by_edges(const PatternFootprint& texel, int levels) const {
  const glm::dvec3 mean = box_mean(pattern_, texel);
  const glm::dvec3 apart = glm::abs(mean - point(texel.at));
  constexpr double kRounding = 1e-9;
  if (levels == 0 || std::max({apart.x, apart.y, apart.z}) < kRounding) return mean;
  const glm::dvec3 dx = 0.5 * texel.dx;
  const glm::dvec3 dy = 0.5 * texel.dy;
  glm::dvec3 sum(0.0);
  for (const double j : {-0.5, 0.5}) {
    for (const double i : {-0.5, 0.5})
      sum += divided_by_edges({texel.at + i * dx + j * dy, dx, dy}, levels - 1);
  }
  return 0.25 * sum;
}

glm::dvec3 TexelMeans::divided(const PatternFootprint& texel, TexelScratch& scratch) const {
  if (++scratch.stamp_ == 0) {
    std::ranges::fill(scratch.stamps_, 0);
    ++scratch.stamp_;
  }
  // Nodes are numbered from the texel's first corner in steps of half the smallest part.
  const auto node = [&](int i, int j) -> const glm::dvec3& {
    const std::size_t index = static_cast<std::size_t>(j) * kNodes + static_cast<std::size_t>(i);
    if (scratch.stamps_[index] != scratch.stamp_) {
      scratch.stamps_[index] = scratch.stamp_;
      constexpr double kStep = 1.0 / (kNodes - 1);
      scratch.colors_[index] = point(texel.at + (i * kStep - 0.5) * texel.dx + (j * kStep - 0.5) * texel.dy);
    }
    return scratch.colors_[index];
  };
  constexpr int kSmallest = 2;
  const auto mean_of_part = [&](const auto& self, int i, int j, int size, double share) -> glm::dvec3 {
    const glm::dvec3& middle = node(i + size / 2, j + size / 2);
    const glm::dvec3& a = node(i, j);
    const glm::dvec3& b = node(i + size, j);
    const glm::dvec3& c = node(i, j + size);
    const glm::dvec3& d = node(i + size, j + size);
    const bool is_whole = size == kNodes - 1;  // it bends, as its neighbours have told
    if (size == kSmallest ||
        (!is_whole && is_straight(a, d, middle, share) && is_straight(b, c, middle, share))) {
      return (2.0 * middle + 0.25 * (a + b + c + d)) / 3.0;
    }
    const int half = size / 2;
    const double more = share * 2 * std::sqrt(2.0);
    return 0.25 * (self(self, i, j, half, more) + self(self, i + half, j, half, more) +
                   self(self, i, j + half, half, more) + self(self, i + half, j + half, half, more));
  };
  return mean_of_part(mean_of_part, 0, 0, kNodes - 1, 8);
}

// Each under a tent that stays inside it, so that an edge between texels stays sharp.
glm::dvec3 TexelMeans::mean_of_parts(const PatternFootprint& texel) const {
  const double aspect = glm::length(texel.dx) / std::max(glm::length(texel.dy), 1e-300);
  const int across = static_cast<int>(std::clamp(std::nearbyint(std::sqrt(kParts * aspect)), 1.0, 16.0));
  const int down = (kParts + across - 1) / across;
  const glm::dvec3 dx = texel.dx / (2.0 * across);
  const glm::dvec3 dy = texel.dy / (2.0 * down);
  glm::dvec3 sum(0.0);
  for (int j = 0; j < down; ++j) {
    for (int i = 0; i < across; ++i)
      sum += color_of(pattern_, {texel.at + (2.0 * i + 1 - across) * dx + (2.0 * j + 1 - down) * dy, dx, dy});
  }
  return sum / static_cast<double>(across * down);
}

}  // namespace sweepkit::texmap
