// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "tree_difference.hpp"

#include <cmath>

#include "material_of.hpp"

namespace sweepkit::render {
namespace {

constexpr double kLeastCosine = 0.9;

// Normals are there where lights need them. Without a light they show in mirrors alone, and there by what is
// mirrored.
bool have_turned(const TreeRow& row_a, std::size_t a, const TreeRow& row_b, std::size_t b) {
  if (row_a.visibility.points.empty()) return false;
  return glm::dot(row_a.visibility.points[a].normal, row_b.visibility.points[b].normal) < kLeastCosine;
}

bool see_other_lights(const Visibility& seen_a, std::size_t a, const Visibility& seen_b, std::size_t b,
                      double least) {
  if (seen_a.points.empty()) return false;
  const std::size_t count = seen_a.shares.size() / seen_a.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const float share_a = seen_a.shares[a * count + i];
    const float share_b = seen_b.shares[b * count + i];
    // Where one is turned away the light only grazes the other.
    if (share_a == kTurnedAway || share_b == kTurnedAway) continue;
    if (std::abs(static_cast<double>(share_a) - static_cast<double>(share_b)) > least) return true;
  }
  return false;
}

// From two nodes on that give `share` of the pixel each.
bool differ_from(const scene::Scene& scene, const TreeRow& row_a, std::int32_t node_a, const TreeRow& row_b,
                 std::int32_t node_b, double share, double least) {
  if (!(share > least)) return false;
  if (node_a < 0 || node_b < 0) return node_a != node_b;
  const auto i = static_cast<std::size_t>(node_a);
  const auto j = static_cast<std::size_t>(node_b);
  const TreeNode& at_a = row_a.nodes[i];
  const TreeNode& at_b = row_b.nodes[j];
  if (at_a.hit.object != at_b.hit.object || at_a.area != at_b.area || have_turned(row_a, i, row_b, j) ||
      see_other_lights(row_a.visibility, i, row_b.visibility, j, least / share))
    return true;
  const Shares shares =
      row_a.shares.empty() ? Shares{material_of(scene, at_a.hit.object).reflect, 0} : row_a.shares[i];
  return differ_from(scene, row_a, row_a.reflection(node_a), row_b, row_b.reflection(node_b),
                     share * shares.mirrored, least) ||
         differ_from(scene, row_a, row_a.refraction(node_a), row_b, row_b.refraction(node_b),
                     share * shares.refracted, least);
}

}  // namespace

bool differ(const scene::Scene& scene, const TreeRow& row_a, std::size_t a, const TreeRow& row_b,
            std::size_t b, double least) {
  return differ_from(scene, row_a, row_a.roots[a], row_b, row_b.roots[b], 1, least);
}

}  // namespace sweepkit::render
