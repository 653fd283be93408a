// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include <array>
#include <glm/glm.hpp>

#include "gltf_buffer.hpp"
#include "growth.hpp"

namespace sweepkit::scene {

/// One turn about +Y, counter-clockwise from above, in keys of 30 degrees. A viewer goes from key to key by
/// slerp, and is right by any keys less than 180 degrees apart; one that goes straight (nlerp) is off by
/// 0.034 degrees at most between these, less than a pixel at the rim of a picture 1000 pixels wide. The last
/// key is minus the first: the same place, reached without a sign that jumps.
std::array<glm::vec4, 13> turn_keys();

/// Turns a node so, once in `seconds`.
void add_turntable(tinygltf::Model& model, GltfBuffer& buffer, int node, double seconds);

/// The states as a primitive's morph targets.
void add_targets(tinygltf::Primitive& primitive, GltfBuffer& buffer, const Growth& growth);

/// A node whose mesh grows, and by what.
struct GrowingNode {
  int node = 0;
  const Growth* growth = nullptr;
};

/// One animation of the nodes' weights, in which one or two targets count at a time. Precondition: there are
/// nodes.
void add_growing(tinygltf::Model& model, GltfBuffer& buffer, const std::vector<GrowingNode>& nodes,
                 double seconds);

}  // namespace sweepkit::scene
