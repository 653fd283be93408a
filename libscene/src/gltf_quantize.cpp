// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on the glTF extension KHR_mesh_quantization (Khronos). Departs from what other writers do: positions
// are rounded in double, from the box of their own mesh.

#include "gltf_quantize.hpp"

#include <algorithm>
#include <cmath>

namespace sweepkit::scene {
namespace {

template <class To>
To rounded(double value) {
  return static_cast<To>(std::lround(value));
}

template <class Vector>
ByteVector byte_vector(const Vector& vector) {
  ByteVector bytes = {};
  for (int i = 0; i < Vector::length(); ++i) {
    // A unit vector's parts may be over 1 by their rounding.
    bytes[static_cast<std::size_t>(i)] = rounded<std::int8_t>(std::clamp(127.0 * vector[i], -127.0, 127.0));
  }
  return bytes;
}

template <class Vector>
std::vector<ByteVector> byte_vectors(std::span<const Vector> vectors) {
  std::vector<ByteVector> bytes(vectors.size());
  std::transform(vectors.begin(), vectors.end(), bytes.begin(), byte_vector<Vector>);
  return bytes;
}

}  // namespace

PositionGrid position_grid(std::span<const glm::vec3> positions, int bits) {
  glm::dvec3 low(positions.front());
  glm::dvec3 high = low;
  for (const glm::vec3& position : positions) {
    low = glm::min(low, glm::dvec3(position));
    high = glm::max(high, glm::dvec3(position));
  }
  const glm::dvec3 sides = high - low;
  const double extent = std::max({sides.x, sides.y, sides.z});
  return {low, extent > 0 ? extent / ((1 << bits) - 1) : 1};
}

int bits_for_cells(std::span<const glm::vec3> positions, std::span<const sweep::Triangle> triangles) {
  double sum = 0;
  for (const sweep::Triangle& triangle : triangles) {
    const glm::dvec3 a(positions[triangle[0]]);
    const glm::dvec3 b(positions[triangle[1]]);
    const glm::dvec3 c(positions[triangle[2]]);
    sum += std::min({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
  }
  const double edge = sum / static_cast<double>(triangles.size());
  int bits = 8;
  while (bits < 14 && position_grid(positions, bits).step > edge / 32) ++bits;
  return bits;
}

std::vector<ShortPosition> to_grid(std::span<const glm::vec3> positions, const PositionGrid& grid) {
  std::vector<ShortPosition> places(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::dvec3 place = (glm::dvec3(positions[i]) - grid.offset) / grid.step;
    for (int axis = 0; axis < 3; ++axis) {
      places[i][static_cast<std::size_t>(axis)] = rounded<std::uint16_t>(place[axis]);
    }
  }
  return places;
}

std::vector<sweep::Triangle> with_area(std::span<const sweep::Triangle> triangles,
                                       std::span<const ShortPosition> positions) {
  std::vector<sweep::Triangle> kept;
  kept.reserve(triangles.size());
  for (const sweep::Triangle& triangle : triangles) {
    const ShortPosition& a = positions[triangle[0]];
    const ShortPosition& b = positions[triangle[1]];
    const ShortPosition& c = positions[triangle[2]];
    if (a != b && b != c && c != a) kept.push_back(triangle);
  }
  return kept;
}

std::vector<ByteVector> to_bytes(std::span<const glm::vec3> vectors) {
  return byte_vectors(vectors);
}

std::vector<ByteVector> to_bytes(std::span<const glm::vec4> vectors) {
  return byte_vectors(vectors);
}

std::optional<std::vector<ShortTexcoord>> to_shorts(std::span<const glm::vec2> texcoords) {
  const auto is_inside = [](const glm::vec2& uv) { return uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1; };
  if (!std::all_of(texcoords.begin(), texcoords.end(), is_inside)) return std::nullopt;
  std::vector<ShortTexcoord> shorts(texcoords.size());
  std::transform(texcoords.begin(), texcoords.end(), shorts.begin(), [](const glm::vec2& uv) {
    return ShortTexcoord{rounded<std::uint16_t>(65535.0 * uv.x), rounded<std::uint16_t>(65535.0 * uv.y)};
  });
  return shorts;
}

}  // namespace sweepkit::scene
