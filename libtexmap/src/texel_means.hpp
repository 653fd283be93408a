// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "pattern.hpp"

namespace sweepkit::texmap {

/// Points of a texel that a thread has looked at, kept while it divides that texel. One a thread.
class TexelScratch {
 public:
  TexelScratch();

 private:
  friend class TexelMeans;
  std::vector<glm::dvec3> colors_;
  std::vector<std::uint32_t> stamps_;  // of the texel that a colour is of
  std::uint32_t stamp_ = 0;
};

/// The means of a procedural texture over texels. Any number of threads, each with a scratch of its own.
class TexelMeans {
 public:
  /// How a texel of given sides is averaged.
  enum class Way {
    kBox,     ///< steps along its sides: in closed form
    kEdges,   ///< steps askew: parts, down to small ones where there are edges
    kPoints,  ///< no detail is finer than it: its middle, or points as close as the pattern asks for
    kParts,   ///< it covers detail: square parts under footprints
  };

  /// `procedural` must outlive this.
  explicit TexelMeans(const Procedural& procedural);

  Way way_of(const glm::dvec3& dx, const glm::dvec3& dy) const;

  glm::dvec3 point(const glm::dvec3& at) const { return color_of(pattern_, {at}); }

  /// The mean over a texel whose middle is `around[4]`, of a texel's neighbours row by row: none where it
  /// bends too much to be told from them.
  static std::optional<glm::dvec3> smooth_mean(const std::array<const glm::dvec3*, 9>& around);

  /// The mean over the texel that dx and dy span about `texel.at`.
  glm::dvec3 mean(Way way, const PatternFootprint& texel, TexelScratch& scratch) const;

 private:
  glm::dvec3 divided_by_edges(const PatternFootprint& texel, int levels) const;
  glm::dvec3 divided(const PatternFootprint& texel, TexelScratch& scratch) const;
  glm::dvec3 mean_of_parts(const PatternFootprint& texel) const;

  Pattern pattern_;
  double detail_;  // in the procedural's own space
};

}  // namespace sweepkit::texmap
