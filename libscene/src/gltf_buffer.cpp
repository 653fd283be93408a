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

constexpr int kVertices = TINYGLTF_TARGET_ARRAY_BUFFER;
constexpr int kIndices = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
constexpr int kFloat = TINYGLTF_COMPONENT_TYPE_FLOAT;

template <class Position>
auto& at(Position& position, int axis) {
  if constexpr (std::is_same_v<std::remove_const_t<Position>, ShortPosition>) {
    return position[static_cast<std::size_t>(axis)];
  } else {
    return position[axis];
  }
}

}  // namespace

int GltfBuffer::add_view(std::span<const std::byte> values) {
  return push_view(values, {});
}

int GltfBuffer::push_view(std::span<const std::byte> values, const Array& array) {
  const std::size_t start = (bytes.size() + 3) / 4 * 4;
  if (start >= kLargestBuffer || values.size() >= kLargestBuffer - start) {
    throw InputError(
        "the file would be over 2 GiB; ask for fewer cells, smaller images or one object at a time");
  }
  bytes.resize(start);
  bytes.insert(bytes.end(), values.begin(), values.end());
  views.push_back({.offset = start, .length = values.size(), .target = array.target, .stride = array.stride});
  return static_cast<int>(views.size()) - 1;
}

int GltfBuffer::add_array(const Array& array) {
  // A span that is over the limit may not be there to be read.
  if (array.bytes.size() < kLargestBuffer) {
    const std::uint64_t hash = XXH3_64bits(array.bytes.data(), array.bytes.size());
    for (auto [one, end] = accessors_.equal_range(hash); one != end; ++one) {
      const tinygltf::Accessor& known = model_.accessors[static_cast<std::size_t>(one->second)];
      const GltfView& view = views[static_cast<std::size_t>(known.bufferView)];
      const auto start = bytes.begin() + static_cast<std::ptrdiff_t>(view.offset);
      if (view.target == array.target && view.stride == array.stride &&
          known.componentType == array.component && known.type == array.type &&
          known.normalized == array.is_normalized && view.length == array.bytes.size() &&
          std::equal(array.bytes.begin(), array.bytes.end(), start)) {
        return one->second;
      }
    }
    accessors_.emplace(hash, static_cast<int>(model_.accessors.size()));
  }
  tinygltf::Accessor accessor;
  accessor.bufferView = push_view(array.bytes, array);
  accessor.componentType = array.component;
  accessor.type = array.type;
  accessor.count = array.count;
  accessor.normalized = array.is_normalized;
  model_.accessors.push_back(std::move(accessor));
  return static_cast<int>(model_.accessors.size()) - 1;
}

int GltfBuffer::add_vertices(std::span<const glm::vec2> texcoords) {
  if (encoding_.is_quantized) {
    if (const std::optional<std::vector<ShortTexcoord>> shorts = to_shorts(texcoords)) {
      return add_array({.bytes = std::as_bytes(std::span(*shorts)),
                        .count = shorts->size(),
                        .component = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                        .type = TINYGLTF_TYPE_VEC2,
                        .target = kVertices,
                        .is_normalized = true});
    }
  }
  return add_array({std::as_bytes(texcoords), texcoords.size(), kFloat, TINYGLTF_TYPE_VEC2, kVertices});
}

int GltfBuffer::add_vertices(std::span<const glm::vec3> normals) {
  if (!encoding_.is_quantized) {
    return add_array({std::as_bytes(normals), normals.size(), kFloat, TINYGLTF_TYPE_VEC3, kVertices});
  }
  const std::vector<ByteVector> vectors = to_bytes(normals);
  return add_array({.bytes = std::as_bytes(std::span(vectors)),
                    .count = vectors.size(),
                    .component = TINYGLTF_COMPONENT_TYPE_BYTE,
                    .type = TINYGLTF_TYPE_VEC3,
                    .target = kVertices,
                    .stride = sizeof(ByteVector),
                    .is_normalized = true});
}

int GltfBuffer::add_vertices(std::span<const glm::vec4> tangents) {
  if (!encoding_.is_quantized) {
    return add_array({std::as_bytes(tangents), tangents.size(), kFloat, TINYGLTF_TYPE_VEC4, kVertices});
  }
  const std::vector<ByteVector> vectors = to_bytes(tangents);
  return add_array({.bytes = std::as_bytes(std::span(vectors)),
                    .count = vectors.size(),
                    .component = TINYGLTF_COMPONENT_TYPE_BYTE,
                    .type = TINYGLTF_TYPE_VEC4,
                    .target = kVertices,
                    .is_normalized = true});
}

template <class Position>
int GltfBuffer::add_bounded(std::span<const Position> positions, const Array& array) {
  Position low = positions.front();
  Position high = low;
  for (const Position& position : positions) {
    for (const int axis : {0, 1, 2}) {
      at(low, axis) = std::min(at(low, axis), at(position, axis));
      at(high, axis) = std::max(at(high, axis), at(position, axis));
    }
  }
  const int index = add_array(array);
  tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
  for (const int axis : {0, 1, 2}) {
    accessor.minValues.push_back(at(low, axis));
    accessor.maxValues.push_back(at(high, axis));
  }
  return index;
}

int GltfBuffer::add_positions(std::span<const glm::vec3> positions) {
  return add_bounded(positions,
                     {std::as_bytes(positions), positions.size(), kFloat, TINYGLTF_TYPE_VEC3, kVertices});
}

int GltfBuffer::add_positions(std::span<const ShortPosition> positions) {
  return add_bounded(positions,
                     {std::as_bytes(positions), positions.size(), TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                      TINYGLTF_TYPE_VEC3, kVertices, sizeof(ShortPosition)});
}

int GltfBuffer::add_indices(std::span<const sweep::Triangle> triangles, std::size_t vertex_count) {
  const std::size_t count = 3 * triangles.size();
  if (vertex_count <= kMostShortVertices) {
    const std::vector<std::uint16_t> indices = short_indices(triangles);
    return add_array({std::as_bytes(std::span(indices)), count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                      TINYGLTF_TYPE_SCALAR, kIndices});
  }
  return add_array({std::as_bytes(triangles), count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                    TINYGLTF_TYPE_SCALAR, kIndices});
}

int GltfBuffer::add_key_times(std::span<const float> seconds) {
  const int index = add_array({std::as_bytes(seconds), seconds.size(), kFloat, TINYGLTF_TYPE_SCALAR});
  tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
  accessor.minValues = {seconds.front()};
  accessor.maxValues = {seconds.back()};
  return index;
}

int GltfBuffer::add_rotations(std::span<const glm::vec4> quaternions) {
  return add_array({std::as_bytes(quaternions), quaternions.size(), kFloat, TINYGLTF_TYPE_VEC4});
}

}  // namespace sweepkit::scene
