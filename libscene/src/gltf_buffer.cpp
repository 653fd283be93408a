// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_buffer.hpp"

#include <xxhash.h>

#include <algorithm>

#include "gltf_arrays.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

// A .glb over 4 GiB wraps its length round without a word, and 2 GiB is what readers can be trusted with.
constexpr std::size_t kLargestBuffer = std::size_t{1} << 31;

}  // namespace

int GltfBuffer::add_view(std::span<const std::byte> values, int target) {
  const std::size_t start = (bytes.size() + 3) / 4 * 4;
  if (start >= kLargestBuffer || values.size() >= kLargestBuffer - start) {
    throw InputError(
        "the file would be over 2 GiB; ask for fewer cells, smaller images or one object at a time");
  }
  bytes.resize(start);
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = start;
  view.byteLength = values.size();
  view.target = target;
  bytes.insert(bytes.end(), values.begin(), values.end());
  model_.bufferViews.push_back(std::move(view));
  return static_cast<int>(model_.bufferViews.size()) - 1;
}

int GltfBuffer::add_accessor(std::span<const std::byte> values, int target, int component, int type,
                             std::size_t count) {
  // A span that is over the limit may not be there to be read.
  if (values.size() < kLargestBuffer) {
    const std::uint64_t hash = XXH3_64bits(values.data(), values.size());
    for (auto [one, end] = accessors_.equal_range(hash); one != end; ++one) {
      const tinygltf::Accessor& known = model_.accessors[static_cast<std::size_t>(one->second)];
      const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(known.bufferView)];
      const auto start = bytes.begin() + static_cast<std::ptrdiff_t>(view.byteOffset);
      if (view.target == target && known.componentType == component && known.type == type &&
          view.byteLength == values.size() && std::equal(values.begin(), values.end(), start)) {
        return one->second;
      }
    }
    accessors_.emplace(hash, static_cast<int>(model_.accessors.size()));
  }
  tinygltf::Accessor accessor;
  accessor.bufferView = add_view(values, target);
  accessor.componentType = component;
  accessor.type = type;
  accessor.count = count;
  model_.accessors.push_back(std::move(accessor));
  return static_cast<int>(model_.accessors.size()) - 1;
}

int GltfBuffer::add_vertices(std::span<const glm::vec2> values) {
  return add_accessor(std::as_bytes(values), TINYGLTF_TARGET_ARRAY_BUFFER, TINYGLTF_COMPONENT_TYPE_FLOAT,
                      TINYGLTF_TYPE_VEC2, values.size());
}

int GltfBuffer::add_vertices(std::span<const glm::vec3> values) {
  return add_accessor(std::as_bytes(values), TINYGLTF_TARGET_ARRAY_BUFFER, TINYGLTF_COMPONENT_TYPE_FLOAT,
                      TINYGLTF_TYPE_VEC3, values.size());
}

int GltfBuffer::add_vertices(std::span<const glm::vec4> values) {
  return add_accessor(std::as_bytes(values), TINYGLTF_TARGET_ARRAY_BUFFER, TINYGLTF_COMPONENT_TYPE_FLOAT,
                      TINYGLTF_TYPE_VEC4, values.size());
}

int GltfBuffer::add_positions(std::span<const glm::vec3> positions) {
  glm::vec3 low = positions.front();
  glm::vec3 high = low;
  for (const glm::vec3& position : positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  const int index = add_vertices(positions);
  tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
  accessor.minValues = {low.x, low.y, low.z};
  accessor.maxValues = {high.x, high.y, high.z};
  return index;
}

int GltfBuffer::add_indices(std::span<const sweep::Triangle> triangles, std::size_t vertex_count) {
  const std::size_t count = 3 * triangles.size();
  if (vertex_count <= kMostShortVertices) {
    const std::vector<std::uint16_t> indices = short_indices(triangles);
    return add_accessor(std::as_bytes(std::span(indices)), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER,
                        TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR, count);
  }
  return add_accessor(std::as_bytes(triangles), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER,
                      TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, count);
}

int GltfBuffer::add_key_times(std::span<const float> seconds) {
  const int index = add_accessor(std::as_bytes(seconds), 0, TINYGLTF_COMPONENT_TYPE_FLOAT,
                                 TINYGLTF_TYPE_SCALAR, seconds.size());
  tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
  accessor.minValues = {seconds.front()};
  accessor.maxValues = {seconds.back()};
  return index;
}

int GltfBuffer::add_weights(std::span<const float> weights) {
  return add_accessor(std::as_bytes(weights), 0, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_SCALAR,
                      weights.size());
}

int GltfBuffer::add_rotations(std::span<const glm::vec4> quaternions) {
  return add_accessor(std::as_bytes(quaternions), 0, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC4,
                      quaternions.size());
}

}  // namespace sweepkit::scene
