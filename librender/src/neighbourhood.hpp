// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "eye_rays.hpp"
#include "intersection_tree.hpp"

namespace sweepkit::render {

/// The rows that the filter sees: above, the row itself, below. Where nothing is filtered all three are the
/// row itself.
using RowWindow = std::array<const TreeRow*, 3>;

/// The nodes of the same path in the 3 x 3 pixels about one, [1][1] the pixel's own; below 0 where there is
/// none.
using Neighbourhood = std::array<std::array<std::int32_t, 3>, 3>;

/// An eye ray's place, and the side of the square about it that it stands for, in pixels.
struct EyeSample {
  const EyeRays* eye_rays;
  glm::dvec2 place;
  double side = 1;
  bool is_alone = false;  ///< without neighbours on a grid
};

/// How a node was reached: by which step from which one, or from the eye by which ray.
struct NodePath {
  const TreeNode* node;
  const NodePath* from;
  Step step;  ///< with `from` alone
  EyeSample eye;
  /// What the node is shaded with in place of the mesh's own normal, where there are normal maps.
  const glm::dvec3* normal = nullptr;
};

/// The neighbour's node in its row, if it lies on the same piece of the same object.
inline std::optional<std::size_t> on_same_piece(const RowWindow& rows, const Neighbourhood& nodes,
                                                std::size_t r, std::size_t c) {
  if (nodes[r][c] < 0) return std::nullopt;
  const TreeNode& at = rows[1]->nodes[static_cast<std::size_t>(nodes[1][1])];
  const auto other = static_cast<std::size_t>(nodes[r][c]);
  const TreeNode& node = rows[r]->nodes[other];
  if (node.hit.object != at.hit.object || node.area != at.area) return std::nullopt;
  return other;
}

}  // namespace sweepkit::render
