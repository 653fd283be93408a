// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The formats are written here and not by OpenMesh, whose writers know one mesh, no materials beside it,
// float32 positions and six digits of text unless told, and report success for a full disk.

#include "sweepkit/scene/mesh_output.hpp"

#include <limits>

#include "mesh_writers.hpp"
#include "obj_materials.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/mesh_file.hpp"

namespace sweepkit::scene {
namespace {

// Readers count with int.
constexpr std::uint64_t kMostInAFile = std::numeric_limits<std::int32_t>::max();

void check_counts(const Scene& scene, const std::filesystem::path& file) {
  const auto [vertices, triangles] = count_meshes(scene);
  const std::uint64_t most = std::max(vertices, triangles);
  if (most <= kMostInAFile) return;
  throw InputError({.file = file.string()},
                   "would hold " + std::to_string(most) +
                       (triangles < vertices ? " vertices" : " triangles") + ", more than the " +
                       std::to_string(kMostInAFile) +
                       " that mesh files count in 32 bits; ask for fewer cells or instances, one object at a "
                       "time, or glTF, whose instances share their mesh");
}

}  // namespace

MeshCounts count_meshes(const Scene& scene) {
  MeshCounts counts;
  for (const Object& object : scene.objects) {
    counts.vertices += scene.meshes[object.mesh].positions.size();
    counts.triangles += scene.meshes[object.mesh].triangles.size();
  }
  return counts;
}

bool holds_textures(const std::filesystem::path& file) {
  return mesh_format(file) == MeshFormat::kObj;
}

bool holds_texcoords(const std::filesystem::path& file) {
  return holds_textures(file) || mesh_format(file) == MeshFormat::kPly;
}

MeshOutput make_mesh_output(const Scene& scene, const Plan& plan, const std::filesystem::path& file,
                            const MeshOutputOptions& options) {
  const MeshFormat format = mesh_format(file);
  check_counts(scene, file);
  const std::string title = "sweepkit " SWEEPKIT_VERSION;
  const auto write = [&](ObjMaterials& materials) {
    switch (format) {
      case MeshFormat::kObj:
        return write_obj(scene, title, materials);
      case MeshFormat::kPly:
        return write_ply(scene, title);
      case MeshFormat::kStl:
        return write_stl(scene, title);
      default:
        return write_off(scene);
    }
  };
  ObjMaterials materials(scene, plan, file.stem().string(), options);
  WrittenMesh mesh = write(materials);
  MeshOutput output{.files = {}, .triangles = mesh.triangles, .ledger = materials.ledger()};
  if (format == MeshFormat::kObj) output.files = materials.take_files(title);
  output.files.push_back({file.filename().string(), std::move(mesh.bytes)});
  return output;
}

}  // namespace sweepkit::scene
