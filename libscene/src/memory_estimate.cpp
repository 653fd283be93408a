// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/memory_estimate.hpp"

#include <algorithm>
#include <system_error>

#include "expected_counts.hpp"
#include "sweepkit/scene/scene.hpp"
#include "sweepkit/sweep/mesh.hpp"

namespace sweepkit::scene {
namespace {

struct Counts : ExpectedCounts {
  std::uint64_t bytes = 0;  // where they are known otherwise
};

// A mesh's text takes this many bytes at least in a file for a byte of the arrays that it becomes, all kept
// while it is read: positions in double, corners, welded places, triangles.
constexpr std::uint64_t kMeshFileFactor = 3;
constexpr std::uint64_t kBytesATriangle = sizeof(sweep::Triangle);
// Position, normal, (u,v), OpenMesh's handle and its byte of item data.
constexpr std::uint64_t kBytesAVertex = 2 * sizeof(glm::vec3) + sizeof(glm::vec2) + 4 + 1;

Counts counts_of(const Piece& piece) {
  if (const auto* mesh = std::get_if<MeshShape>(&piece.shape)) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(mesh->file, error);
    return {{}, error ? 0 : kMeshFileFactor * size};
  }
  return {expected_counts(piece), 0};
}

}  // namespace

MemoryEstimate estimate_memory(const Document& document) {
  MemoryEstimate estimate;
  for (const ObjectEntry& object : document.objects) {
    const bool has_tangents = object.material && document.materials[*object.material].normal_map;
    std::uint64_t largest = 0;
    for (const Piece& piece : object.pieces) {
      const Counts counts = counts_of(piece);
      try {
        sweep::check_triangle_count(counts.triangles);
      } catch (const InputError& error) {
        throw InputError(piece.place, error.problem());
      }
      const std::uint64_t bytes =
          counts.bytes + counts.vertices * kBytesAVertex + counts.triangles * kBytesATriangle;
      estimate.triangles += counts.triangles;
      estimate.bytes += bytes + (has_tangents ? counts.vertices * sizeof(glm::vec4) : 0);
      largest = std::max(largest, bytes);
    }
    // Parts, and what is placed, are made by themselves and then copied.
    const bool is_copied =
        object.pieces.size() > 1 || to_matrix(object.pieces.front().placement) != glm::dmat4(1.0);
    if (is_copied) estimate.bytes += largest;
    estimate.objects += std::max(object.instances.size(), std::size_t{1});
  }
  estimate.bytes += estimate.objects * sizeof(Object);
  return estimate;
}

}  // namespace sweepkit::scene
