// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Akdemir98, 5]: "This method can also be improved for producing smooth shadow edges." The rows
// hold what each node's one shadow ray a light found, and a node averages it over its neighbours on the same
// path, as it does textures.
//
// The weights are the products of (1/8, 3/4, 1/8) with itself. Take a straight edge along a column of pixels,
// between the middle of one in the light and one in the shadow, e of a pixel from the first (0 to 1, any as
// likely). Over a box of one pixel the first has min(e + 1/2, 1) of the light, the second max(e - 1/2, 0). A
// weight w at the sides gives 1 - w and w: squared errors of 1/48 + (1/4 - w)^2 + w^2 for the two, on
// average. That is 1/12 for w = 0, which is no smoothing, and for w = 1/4, the weights of the paper's
// supersampling; and least, 5/96, for w = 1/8.

#include "shadow_edges.hpp"

#include <algorithm>
#include <array>

namespace sweepkit::render {
namespace {

constexpr std::array<double, 3> kWeights = {0.125, 0.75, 0.125};

// Normals less than this apart (26 degrees) are of one surface; the inside and the outside of a vase are not.
constexpr double kLeastCosine = 0.9;

// What of the light comes to the node, channel by channel.
const float* share_of(const Visibility& visibility, std::size_t node, std::size_t light) {
  return visibility.shares.data() + (node * visibility.lights + light) * visibility.channels;
}

glm::dvec3 color_of(const float* share, std::size_t channels) {
  return channels == 3 ? glm::dvec3(share[0], share[1], share[2]) : glm::dvec3(share[0]);
}

// Do all nodes of the path, on the same piece or not, say the same or are turned away?
bool all_agree(const RowWindow& rows, const Neighbourhood& nodes, std::size_t light) {
  const std::size_t channels = rows[1]->visibility.channels;
  const float* own = share_of(rows[1]->visibility, static_cast<std::size_t>(nodes[1][1]), light);
  for (std::size_t r = 0; r < 3; ++r) {
    for (const std::int32_t node : nodes[r]) {
      if (node < 0) continue;
      const float* there = share_of(rows[r]->visibility, static_cast<std::size_t>(node), light);
      if (there[0] != kTurnedAway && !std::equal(own, own + channels, there)) return false;
    }
  }
  return true;
}

}  // namespace

glm::dvec3 own_share(const RowWindow& rows, const Neighbourhood& nodes, std::size_t light) {
  const Visibility& visibility = rows[1]->visibility;
  return color_of(share_of(visibility, static_cast<std::size_t>(nodes[1][1]), light), visibility.channels);
}

glm::dvec3 smooth_share(const RowWindow& rows, const Neighbourhood& nodes, std::size_t light) {
  const glm::dvec3 own = own_share(rows, nodes, light);
  if (all_agree(rows, nodes, light)) return own;  // most pixels, for a fraction of the work
  const glm::dvec3& normal = rows[1]->visibility.points[static_cast<std::size_t>(nodes[1][1])].normal;
  double weights = 0;
  glm::dvec3 sum(0.0);  // of the differences, which are 0 where all say the same
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::optional<std::size_t> other = on_same_piece(rows, nodes, r, c);
      if (!other) continue;
      const Visibility& visibility = rows[r]->visibility;
      const glm::dvec3 there = color_of(share_of(visibility, *other, light), visibility.channels);
      if (there.x == kTurnedAway || glm::dot(visibility.points[*other].normal, normal) < kLeastCosine)
        continue;
      const double weight = kWeights[r] * kWeights[c];
      weights += weight;
      sum += weight * (there - own);
    }
  }
  return own + sum / weights;
}

}  // namespace sweepkit::render
