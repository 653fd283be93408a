// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/memory_estimate.hpp"

#include <algorithm>
#include <system_error>

#include "sweepkit/scene/scene.hpp"
#include "sweepkit/sweep/mesh.hpp"

namespace sweepkit::scene {
namespace {

struct Counts {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  std::uint64_t bytes = 0;  // where they are known otherwise
};

// A mesh's text takes this many bytes at least in a file for a byte of the arrays that it becomes, all kept
// while it is read: positions in double, corners, welded places, triangles.
constexpr std::uint64_t kMeshFileFactor = 3;
constexpr std::uint64_t kBytesATriangle = sizeof(sweep::Triangle);
// Position, normal, (u,v), OpenMesh's handle and its byte of item data.
constexpr std::uint64_t kBytesAVertex = 2 * sizeof(glm::vec3) + sizeof(glm::vec2) + 4 + 1;

std::uint64_t cells_along(std::span<const sweep::Curve2> contour, int wanted) {
  std::uint64_t corners = 0;
  for (const sweep::Curve2& outline : contour) corners += outline.is_closed() ? 3 : 1;
  return std::max<std::uint64_t>(corners, static_cast<std::uint64_t>(wanted));
}

Counts grid(std::uint64_t columns, std::uint64_t rows) {
  return {(columns + 1) * (rows + 1), 2 * columns * rows};
}

Counts counts_of(const Piece& piece) {
  if (const auto* mesh = std::get_if<MeshShape>(&piece.shape)) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(mesh->file, error);
    return {.bytes = error ? 0 : kMeshFileFactor * size};
  }
  if (piece.tessellation.tolerance) return {};
  const auto along = static_cast<std::uint64_t>(piece.tessellation.trajectory);
  if (const auto* swept = std::get_if<SweepShape>(&piece.shape))
    return grid(cells_along(swept->contour, piece.tessellation.contour), along);
  if (const auto* revolved = std::get_if<RevolveShape>(&piece.shape))
    return grid(cells_along(revolved->contour, piece.tessellation.contour), along);
  return grid(static_cast<std::uint64_t>(piece.tessellation.contour), along);
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
