// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "sweepkit/sweep/grid_patch.hpp"

namespace sweepkit::scene {

/// A model's one buffer as it grows, with the views and accessors into it. What add_ returns is an index into
/// the model's views or accessors. Everything is aligned to four bytes. Arrays of equal bytes and kind are
/// one accessor, so that objects of one shape share it, whatever their names and materials. Throws InputError
/// where the buffer would be over 2 GiB.
class GltfBuffer {
 public:
  explicit GltfBuffer(tinygltf::Model& model) : model_(model) {}

  int add_view(std::span<const std::byte> bytes, int target = 0);
  int add_vertices(std::span<const glm::vec2> values);
  int add_vertices(std::span<const glm::vec3> values);
  int add_vertices(std::span<const glm::vec4> values);
  int add_positions(std::span<const glm::vec3> positions);  ///< with their bounds
  int add_indices(std::span<const sweep::Triangle> triangles, std::size_t vertex_count);
  int add_key_times(std::span<const float> seconds);  ///< rising; with their bounds
  int add_weights(std::span<const float> weights);
  int add_rotations(std::span<const glm::vec4> quaternions);

  std::vector<std::byte> bytes;

 private:
  int add_accessor(std::span<const std::byte> values, int target, int component, int type, std::size_t count);

  tinygltf::Model& model_;
  std::unordered_multimap<std::uint64_t, int> accessors_;  // by hash of their bytes
};

}  // namespace sweepkit::scene
