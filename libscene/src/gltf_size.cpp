// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/gltf_size.hpp"

#include <algorithm>
#include <cstdio>

#include "expected_counts.hpp"
#include "gltf_quantize.hpp"
#include "message_text.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

constexpr double kSure = 0.95;  // expected_counts() may be off by the rest

// The least that an item takes in the file, before it is packed.
struct ItemBytes {
  std::uint64_t vertex = 0;
  std::uint64_t triangle = 0;
};

ItemBytes item_bytes(const GltfOptions& options) {
  const bool has_texcoords = !options.is_minimal && !options.is_packed;
  if (options.is_quantized) {
    // Triangles that lose their area are left out.
    return {sizeof(ShortPosition) + sizeof(ByteVector) + (has_texcoords ? sizeof(ShortTexcoord) : 0), 0};
  }
  return {2 * sizeof(glm::vec3) + (has_texcoords ? sizeof(glm::vec2) : 0), sizeof(sweep::Triangle)};
}

}  // namespace

void check_gltf_size(Document& document, const GltfOptions& options) {
  const ItemBytes item = item_bytes(options);
  // Arrays that pack well count in the buffer that they unpack into, others in the file's own.
  const std::uint64_t most = options.is_packed ? 2 * kMostGltfBytes : kMostGltfBytes;
  for (ObjectEntry& object : document.objects) {
    std::uint64_t bytes = 0;
    for (Piece& piece : object.pieces) {
      const ExpectedCounts counts = expected_counts(piece);
      bytes += counts.vertices * item.vertex + counts.triangles * item.triangle;
      if (!piece.tessellation.tolerance) continue;
      // A grid has a vertex for two triangles.
      const std::uint64_t most_triangles = 2 * most / (item.vertex + 2 * item.triangle);
      piece.tessellation.most_triangles = std::min(piece.tessellation.most_triangles, most_triangles);
    }
    if (kSure * static_cast<double>(bytes) < static_cast<double>(most)) continue;
    char size[32];
    std::snprintf(size, sizeof size, "%.1f", static_cast<double>(bytes) / (std::uint64_t{1} << 30));
    throw InputError(
        object.pieces.front().place,
        "the object " + in_quotes(object.name) + " would take " + size +
            " GiB, and a glTF file holds less than 2; ask for fewer cells, or for another format");
  }
}

}  // namespace sweepkit::scene
