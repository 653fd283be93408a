// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "gltf_quantize.hpp"
#include "gltf_view.hpp"
#include "sweepkit/sweep/grid_patch.hpp"

namespace sweepkit::scene {

/// How arrays become bytes.
struct GltfEncoding {
  bool is_quantized = false;  ///< KHR_mesh_quantization
  bool is_packed = false;     ///< EXT_meshopt_compression, where it makes an array smaller
};

/// A model's one buffer as it grows, with the views and accessors into it. What add_ returns is an index into
/// the views or the model's accessors. Everything is aligned to four bytes. Arrays of equal bytes and kind
/// are one accessor, so that objects of one shape share it, whatever their names and materials. Throws
/// InputError where the buffer would be over 2 GiB.
class GltfBuffer {
 public:
  explicit GltfBuffer(tinygltf::Model& model, const GltfEncoding& encoding = {})
      : model_(model), encoding_(encoding) {}

  enum class Lifetime { kShort, kLasting };

  int add_view(std::span<const std::byte> bytes);
  int add_vertices(std::span<const glm::vec2> texcoords, Lifetime lifetime = Lifetime::kShort);
  int add_vertices(std::span<const glm::vec3> normals, Lifetime lifetime = Lifetime::kShort);
  int add_vertices(std::span<const glm::vec4> tangents, Lifetime lifetime = Lifetime::kShort);
  int add_positions(std::span<const glm::vec3> positions,
                    Lifetime lifetime = Lifetime::kShort);      ///< with their bounds
  int add_positions(std::span<const ShortPosition> positions);  ///< with their bounds
  int add_indices(std::span<const sweep::Triangle> triangles, std::size_t vertex_count,
                  Lifetime lifetime = Lifetime::kShort);
  int add_key_times(std::span<const float> seconds);  ///< rising; with their bounds
  int add_weights(std::span<const float> weights);
  int add_rotations(std::span<const glm::vec4> quaternions);

  /// What the pieces point to that nobody else keeps. Moving it moves no bytes.
  std::deque<std::vector<std::byte>> kept;
  std::vector<std::span<const std::byte>> pieces;
  std::size_t size = 0;  ///< of all pieces
  std::vector<GltfView> views;
  std::size_t unpacked_bytes = 0;  ///< of the buffer that packed views unpack into

 private:
  struct Array {
    std::span<const std::byte> bytes;
    std::size_t count = 0;
    int component = 0;
    int type = 0;
    int target = 0;
    std::size_t stride = 0;  ///< where items are padded; 0: packed
    bool is_normalized = false;
    Lifetime lifetime = Lifetime::kShort;
  };

  struct Packed {
    std::vector<std::byte> bytes;
    GltfPacking packing;
  };

  /// As it is, or packed if that is smaller.
  int add_array(const Array& array, Packed packed = {});
  int push_view(std::span<const std::byte> values, const Array& array,
                const std::optional<GltfPacking>& packing);
  void push_piece(std::span<const std::byte> piece);
  /// Nothing unless this buffer packs.
  template <class Item>
  Packed pack(std::span<const Item> items, const char* filter = "") const;
  template <class Vector>
  Packed pack_octahedral(std::span<const Vector> vectors) const;
  Packed pack_indices(std::span<const sweep::Triangle> triangles, std::size_t vertex_count) const;
  template <class Position>
  int add_bounded(std::span<const Position> positions, const Array& array);

  tinygltf::Model& model_;
  GltfEncoding encoding_;
  std::unordered_multimap<std::uint64_t, int> accessors_;  // by hash of their bytes
  std::vector<std::size_t> piece_of_view_;
};

}  // namespace sweepkit::scene
