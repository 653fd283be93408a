// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// meshoptimizer is known to this file alone. Based on the glTF extension EXT_meshopt_compression (A.
// Kapoulkine), which fixes the versions of both codecs. Departs from the library's own filter for floats: all
// have one exponent, so that an even grid of (u,v) keeps even steps, which pack better.

#include "gltf_meshopt.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>

namespace sweepkit::scene {
namespace {

constexpr int kFraction = 12;  // bits after the point of to_exponential()

std::vector<unsigned int> flat(std::span<const sweep::Triangle> triangles) {
  std::vector<unsigned int> indices;
  indices.reserve(3 * triangles.size());
  for (const sweep::Triangle& triangle : triangles)
    indices.insert(indices.end(), triangle.begin(), triangle.end());
  return indices;
}

template <class Fill>
std::vector<std::byte> packed(std::size_t most, const Fill& fill) {
  std::vector<std::byte> bytes(most);
  bytes.resize(fill(reinterpret_cast<unsigned char*>(bytes.data()), most));
  bytes.shrink_to_fit();
  return bytes;
}

template <class Vector>
std::vector<ByteVector> octahedral(std::span<const Vector> vectors) {
  std::vector<glm::vec4> wide(vectors.size(), glm::vec4(0.0f));
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    for (int part = 0; part < Vector::length(); ++part) wide[i][part] = vectors[i][part];
  }
  std::vector<ByteVector> bytes(vectors.size());
  meshopt_encodeFilterOct(bytes.data(), bytes.size(), sizeof(ByteVector), 8, &wide.data()->x);
  return bytes;
}

}  // namespace

std::vector<std::byte> pack_vertices(std::span<const std::byte> items, std::size_t item_bytes) {
  static const bool is_version_set = (meshopt_encodeVertexVersion(0), true);
  static_cast<void>(is_version_set);
  const std::size_t count = items.size() / item_bytes;
  return packed(meshopt_encodeVertexBufferBound(count, item_bytes), [&](unsigned char* to, std::size_t most) {
    return meshopt_encodeVertexBuffer(to, most, items.data(), count, item_bytes);
  });
}

std::vector<std::byte> pack_triangles(std::span<const sweep::Triangle> triangles, std::size_t vertex_count) {
  static const bool is_version_set = (meshopt_encodeIndexVersion(1), true);
  static_cast<void>(is_version_set);
  const std::vector<unsigned int> indices = flat(triangles);
  return packed(meshopt_encodeIndexBufferBound(indices.size(), vertex_count),
                [&](unsigned char* to, std::size_t most) {
                  return meshopt_encodeIndexBuffer(to, most, indices.data(), indices.size());
                });
}

std::vector<ByteVector> to_octahedron(std::span<const glm::vec3> vectors) {
  return octahedral(vectors);
}

std::vector<ByteVector> to_octahedron(std::span<const glm::vec4> vectors) {
  return octahedral(vectors);
}

std::optional<std::vector<std::array<std::uint32_t, 2>>> to_exponential(std::span<const glm::vec2> values) {
  constexpr std::uint32_t kExponent = static_cast<std::uint32_t>(-kFraction) << 24;
  constexpr std::uint32_t kMantissa = (1u << 24) - 1;
  constexpr double kMost = 8388607.0 / (1 << kFraction);
  std::vector<std::array<std::uint32_t, 2>> words(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (int part = 0; part < 2; ++part) {
      const double value = values[i][part];
      if (!(std::abs(value) <= kMost)) return std::nullopt;
      const auto whole = static_cast<std::uint32_t>(std::lround(std::ldexp(value, kFraction)));
      words[i][static_cast<std::size_t>(part)] = kExponent | (whole & kMantissa);
    }
  }
  return words;
}

std::vector<sweep::Triangle> in_cache_order(std::span<const sweep::Triangle> triangles,
                                            std::size_t vertex_count) {
  const std::vector<unsigned int> indices = flat(triangles);
  std::vector<unsigned int> ordered(indices.size());
  meshopt_optimizeVertexCache(ordered.data(), indices.data(), indices.size(), vertex_count);
  std::vector<sweep::Triangle> result(triangles.size());
  for (std::size_t i = 0; i < ordered.size(); ++i) result[i / 3][i % 3] = ordered[i];
  return result;
}

}  // namespace sweepkit::scene
