// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_buffer.hpp"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <utility>

#include "gltf_arrays.hpp"
#include "gltf_meshopt.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/gltf_size.hpp"

namespace sweepkit::scene {
namespace {

constexpr int kVertices = TINYGLTF_TARGET_ARRAY_BUFFER;
constexpr int kIndices = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
constexpr int kFloat = TINYGLTF_COMPONENT_TYPE_FLOAT;

// What an array packed has more in the JSON: else small ones would make the file larger.
constexpr std::size_t kPackingText = 150;

constexpr std::size_t aligned(std::size_t size) {
  return (size + 3) / 4 * 4;
}

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
  return push_view(values, {}, std::nullopt);
}

void GltfBuffer::push_piece(std::span<const std::byte> piece) {
  if (piece.empty()) return;
  pieces.push_back(piece);
  size += piece.size();
}

int GltfBuffer::push_view(std::span<const std::byte> values, const Array& array,
                          const std::optional<GltfPacking>& packing) {
  static constexpr std::array<std::byte, 3> kPadding = {};
  const std::size_t start = aligned(size);
  if (start >= kMostGltfBytes || values.size() >= kMostGltfBytes - start ||
      (packing && packing->count * packing->item_bytes >= kMostGltfBytes - unpacked_bytes)) {
    throw InputError(
        "the file would be over 2 GiB; ask for fewer cells, smaller images or one object at a time");
  }
  push_piece(std::span(kPadding).first(start - size));
  piece_of_view_.push_back(pieces.size());
  if (array.lifetime == Lifetime::kLasting && !packing) {
    push_piece(values);
  } else {
    push_piece(kept.emplace_back(values.begin(), values.end()));
  }
  views.push_back({start, values.size(), array.target, array.stride, packing});
  if (packing) {
    views.back().packing->unpacked_offset = unpacked_bytes;
    unpacked_bytes = aligned(unpacked_bytes + packing->count * packing->item_bytes);
  }
  return static_cast<int>(views.size()) - 1;
}

int GltfBuffer::add_array(const Array& array, Packed packed) {
  std::span<const std::byte> values = array.bytes;
  std::optional<GltfPacking> packing;
  if (!packed.bytes.empty() && packed.bytes.size() + kPackingText < values.size()) {
    values = packed.bytes;
    packing = std::move(packed.packing);
  }
  // A span that is over the limit may not be there to be read.
  if (values.size() < kMostGltfBytes) {
    const std::uint64_t hash = XXH3_64bits(values.data(), values.size());
    for (auto [one, end] = accessors_.equal_range(hash); one != end; ++one) {
      const tinygltf::Accessor& known = model_.accessors[static_cast<std::size_t>(one->second)];
      const GltfView& view = views[static_cast<std::size_t>(known.bufferView)];
      if (packing && view.packing) packing->unpacked_offset = view.packing->unpacked_offset;
      if (view.target == array.target && view.stride == array.stride && view.packing == packing &&
          known.componentType == array.component && known.type == array.type &&
          known.normalized == array.is_normalized && view.length == values.size() &&
          std::ranges::equal(values, pieces[piece_of_view_[static_cast<std::size_t>(known.bufferView)]])) {
        return one->second;
      }
    }
    accessors_.emplace(hash, static_cast<int>(model_.accessors.size()));
  }
  tinygltf::Accessor accessor;
  accessor.bufferView = push_view(values, array, packing);
  accessor.componentType = array.component;
  accessor.type = array.type;
  accessor.count = array.count;
  accessor.normalized = array.is_normalized;
  model_.accessors.push_back(std::move(accessor));
  return static_cast<int>(model_.accessors.size()) - 1;
}

template <class Item>
GltfBuffer::Packed GltfBuffer::pack(std::span<const Item> items, const char* filter) const {
  if (!encoding_.is_packed) return {};
  return {pack_vertices(std::as_bytes(items), sizeof(Item)),
          {.mode = "ATTRIBUTES", .filter = filter, .count = items.size(), .item_bytes = sizeof(Item)}};
}

int GltfBuffer::add_vertices(std::span<const glm::vec2> texcoords, Lifetime lifetime) {
  const Array floats = {
      std::as_bytes(texcoords), texcoords.size(), kFloat, TINYGLTF_TYPE_VEC2, kVertices, 0, false, lifetime};
  if (!encoding_.is_quantized) return add_array(floats, pack(texcoords));
  Packed exponential;
  if (encoding_.is_packed) {
    if (const auto words = to_exponential(texcoords)) {
      exponential = pack(std::span(std::as_const(*words)), "EXPONENTIAL");
    }
  }
  const std::optional<std::vector<ShortTexcoord>> shorts = to_shorts(texcoords);
  if (!shorts) return add_array(floats, std::move(exponential));
  // Even steps of cells stay even in a fraction of whole bits.
  if (!exponential.bytes.empty() &&
      exponential.bytes.size() + kPackingText < sizeof(ShortTexcoord) * shorts->size()) {
    return add_array(floats, std::move(exponential));
  }
  return add_array({.bytes = std::as_bytes(std::span(*shorts)),
                    .count = shorts->size(),
                    .component = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                    .type = TINYGLTF_TYPE_VEC2,
                    .target = kVertices,
                    .is_normalized = true});
}

int GltfBuffer::add_vertices(std::span<const glm::vec3> normals, Lifetime lifetime) {
  if (!encoding_.is_quantized) {
    return add_array(
        {std::as_bytes(normals), normals.size(), kFloat, TINYGLTF_TYPE_VEC3, kVertices, 0, false, lifetime},
        pack(normals));
  }
  const std::vector<ByteVector> vectors = to_bytes(normals);
  return add_array({.bytes = std::as_bytes(std::span(vectors)),
                    .count = vectors.size(),
                    .component = TINYGLTF_COMPONENT_TYPE_BYTE,
                    .type = TINYGLTF_TYPE_VEC3,
                    .target = kVertices,
                    .stride = sizeof(ByteVector),
                    .is_normalized = true},
                   pack_octahedral(normals));
}

int GltfBuffer::add_vertices(std::span<const glm::vec4> tangents, Lifetime lifetime) {
  if (!encoding_.is_quantized) {
    return add_array(
        {std::as_bytes(tangents), tangents.size(), kFloat, TINYGLTF_TYPE_VEC4, kVertices, 0, false, lifetime},
        pack(tangents));
  }
  const std::vector<ByteVector> vectors = to_bytes(tangents);
  return add_array({.bytes = std::as_bytes(std::span(vectors)),
                    .count = vectors.size(),
                    .component = TINYGLTF_COMPONENT_TYPE_BYTE,
                    .type = TINYGLTF_TYPE_VEC4,
                    .target = kVertices,
                    .is_normalized = true},
                   pack_octahedral(tangents));
}

template <class Vector>
GltfBuffer::Packed GltfBuffer::pack_octahedral(std::span<const Vector> vectors) const {
  if (!encoding_.is_packed) return {};
  const std::vector<ByteVector> octahedral = to_octahedron(vectors);
  return pack(std::span(octahedral), "OCTAHEDRAL");
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
  const int index = add_array(array, pack(positions));
  tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
  // Not added to: the accessor may be another mesh's, with the same bytes.
  accessor.minValues = {1.0 * at(low, 0), 1.0 * at(low, 1), 1.0 * at(low, 2)};
  accessor.maxValues = {1.0 * at(high, 0), 1.0 * at(high, 1), 1.0 * at(high, 2)};
  return index;
}

int GltfBuffer::add_positions(std::span<const glm::vec3> positions, Lifetime lifetime) {
  return add_bounded(positions, {std::as_bytes(positions), positions.size(), kFloat, TINYGLTF_TYPE_VEC3,
                                 kVertices, 0, false, lifetime});
}

int GltfBuffer::add_positions(std::span<const ShortPosition> positions) {
  return add_bounded(positions,
                     {std::as_bytes(positions), positions.size(), TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                      TINYGLTF_TYPE_VEC3, kVertices, sizeof(ShortPosition)});
}

GltfBuffer::Packed GltfBuffer::pack_indices(std::span<const sweep::Triangle> triangles,
                                            std::size_t vertex_count) const {
  if (!encoding_.is_packed) return {};
  const bool is_short = vertex_count <= kMostShortVertices;
  return {pack_triangles(triangles, vertex_count),
          {.mode = "TRIANGLES",
           .count = 3 * triangles.size(),
           .item_bytes = is_short ? sizeof(std::uint16_t) : sizeof(std::uint32_t)}};
}

int GltfBuffer::add_indices(std::span<const sweep::Triangle> triangles, std::size_t vertex_count,
                            Lifetime lifetime) {
  const std::size_t count = 3 * triangles.size();
  if (vertex_count <= kMostShortVertices) {
    const std::vector<std::uint16_t> indices = short_indices(triangles);
    return add_array({std::as_bytes(std::span(indices)), count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                      TINYGLTF_TYPE_SCALAR, kIndices},
                     pack_indices(triangles, vertex_count));
  }
  return add_array({std::as_bytes(triangles), count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                    TINYGLTF_TYPE_SCALAR, kIndices, 0, false, lifetime},
                   pack_indices(triangles, vertex_count));
}

int GltfBuffer::add_key_times(std::span<const float> seconds) {
  const int index = add_array({std::as_bytes(seconds), seconds.size(), kFloat, TINYGLTF_TYPE_SCALAR});
  tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
  accessor.minValues = {seconds.front()};
  accessor.maxValues = {seconds.back()};
  return index;
}

int GltfBuffer::add_weights(std::span<const float> weights) {
  return add_array({std::as_bytes(weights), weights.size(), kFloat, TINYGLTF_TYPE_SCALAR});
}

int GltfBuffer::add_rotations(std::span<const glm::vec4> quaternions) {
  return add_array({std::as_bytes(quaternions), quaternions.size(), kFloat, TINYGLTF_TYPE_VEC4});
}

}  // namespace sweepkit::scene
