// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_primitive.hpp"

#include <span>

#include "strip_order.hpp"

namespace sweepkit::scene {

GltfPrimitive add_primitive(GltfBuffer& buffer, const MeshView& mesh, const GltfVertices& vertices,
                            const std::optional<PositionGrid>& grid, bool is_packed) {
  MeshOrder order = is_packed ? strip_order(mesh) : MeshOrder();
  std::span<const sweep::Triangle> triangles = is_packed ? std::span(order.triangles) : mesh.triangles;
  // Calls `use` with the items in the file's order.
  const auto ordered = [&]<class T>(std::span<const T> items, const auto& use) {
    if (!is_packed) return use(items);
    const std::vector<T> moved = in_order(items, order);
    return use(std::span<const T>(moved));
  };
  // What is in the mesh's own order is the mesh's own, and needs no copy.
  const auto lifetime =
      is_packed || !vertices.lasts ? GltfBuffer::Lifetime::kShort : GltfBuffer::Lifetime::kLasting;
  const auto add = [&](auto items) { return buffer.add_vertices(items); };
  const auto add_own = [&](auto items) { return buffer.add_vertices(items, lifetime); };

  GltfPrimitive primitive;
  primitive.entry.mode = TINYGLTF_MODE_TRIANGLES;
  std::vector<sweep::Triangle> kept;
  std::vector<ShortPosition> places;
  if (grid) {
    places = ordered(mesh.positions, [&](auto positions) { return to_grid(positions, *grid); });
    kept = with_area(triangles, places);
    primitive.without_area = triangles.size() - kept.size();
    triangles = kept;
    if (kept.empty()) return primitive;
    if (is_packed && primitive.without_area > 0) {
      order.triangles = std::move(kept);
      drop_unused_vertices(order);
      triangles = order.triangles;
      places = ordered(mesh.positions, [&](auto positions) { return to_grid(positions, *grid); });
    }
  }
  primitive.entry.indices =
      buffer.add_indices(triangles, is_packed ? order.vertices.size() : mesh.positions.size(),
                         grid ? GltfBuffer::Lifetime::kShort : lifetime);
  auto& attributes = primitive.entry.attributes;
  attributes["POSITION"] = grid ? buffer.add_positions(std::span<const ShortPosition>(places))
                                : ordered(mesh.positions, [&](auto positions) {
                                    return buffer.add_positions(positions, lifetime);
                                  });
  attributes["NORMAL"] = ordered(mesh.normals, add_own);
  if (!vertices.tangents.empty()) {
    attributes["TANGENT"] = ordered(std::span<const glm::vec4>(vertices.tangents), add);
  }
  if (!vertices.texcoords.empty()) {
    attributes["TEXCOORD_0"] = ordered(std::span<const glm::vec2>(vertices.texcoords), add);
  }
  if (!vertices.second_texcoords.empty()) {
    attributes["TEXCOORD_1"] = ordered(std::span<const glm::vec2>(vertices.second_texcoords), add);
  }
  return primitive;
}

}  // namespace sweepkit::scene
