// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "gltf_buffer.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::scene {

/// What the file has at a mesh's vertices beside positions and normals.
struct GltfVertices {
  std::vector<glm::vec2> texcoords;         ///< empty: none
  std::vector<glm::vec2> second_texcoords;  ///< those of a normal map; empty: none
  std::vector<glm::vec4> tangents;          ///< empty: none
  bool lasts = true;                        ///< the mesh lasts as long as the file is being made
};

struct GltfPrimitive {
  tinygltf::Primitive entry;  ///< without its material; no triangle is left where indices is -1
  std::size_t without_area = 0;
};

/// A mesh's vertices and triangles as a primitive, its positions on `grid` if there is one and then without
/// the triangles that lose their area; `is_packed`: in strip_order().
GltfPrimitive add_primitive(GltfBuffer& buffer, const MeshView& mesh, const GltfVertices& vertices,
                            const std::optional<PositionGrid>& grid, bool is_packed);

}  // namespace sweepkit::scene
