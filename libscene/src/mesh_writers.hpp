// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "obj_materials.hpp"
#include "sweepkit/scene/mesh_output.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::scene {

/// The writers, one a format: the bytes of the file, and how many triangles it has. `title` is the line that
/// tells who wrote it. They throw as place_surface() does.
/// What a scene's objects have together, an instance as much as another.
struct MeshCounts {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
};
MeshCounts count_meshes(const Scene& scene);

struct WrittenMesh {
  std::vector<std::byte> bytes;
  std::uint64_t triangles = 0;
};
WrittenMesh write_obj(const Scene& scene, const std::string& title, ObjMaterials& materials);
WrittenMesh write_ply(const Scene& scene, const std::string& title);
WrittenMesh write_stl(const Scene& scene, const std::string& title);
WrittenMesh write_off(const Scene& scene);

}  // namespace sweepkit::scene
