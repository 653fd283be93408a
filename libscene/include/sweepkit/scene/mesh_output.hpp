// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "sweepkit/scene/gltf.hpp"
#include "sweepkit/scene/plan.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::scene {

class ImageStore;

/// What a mesh file of that name (mesh_file.hpp: is_mesh_name()) can hold: textures .obj alone, (u,v) .obj
/// and .ply. The request for the plan takes its answers from here.
bool holds_textures(const std::filesystem::path& file);
bool holds_texcoords(const std::filesystem::path& file);

struct MeshOutputOptions {
  int bake_size = 1024;                 ///< texels on the longer side of a baked procedural texture
  ImageStore* images = nullptr;         ///< keeps encoded and baked images for the files to come
  std::optional<double> texel_density;  ///< in place of bake_size: texels a metre (texel_density.hpp)
  int threads = 0;                      ///< that bake a texture; 0: as many as the machine has
};

struct MeshOutput {
  std::vector<NamedBytes> files;  ///< what stands beside (images, .mtl), then the mesh file itself
  std::uint64_t triangles = 0;    ///< in the file: each instance's
  Ledger ledger;                  ///< bakes
};

/// The scene's objects in the world as one mesh file, each instance written out:
///   .obj  an `o` for each, faces of v/vt/vn, a material library and its images beside it
///   .ply  binary little endian, positions, normals and (u,v) (s, t) at vertices
///   .stl  binary, the facets' own normals
///   .off  positions alone
/// In .obj and .off vertices in the same place are one, so that a closed surface is closed in the file too; a
/// triangle with two corners in one place is left out of all. In text each number is the shortest that reads
/// back the same: as float32 where it is one, else as double. .ply holds float32 unless an object is so far
/// from the origin for its size that float32 would blur it (then double), .stl always float32. The same scene
/// gives the same bytes. Throws InputError for an object without triangles, more than 2^31 - 1 vertices or
/// triangles, a name that ends otherwise.
MeshOutput make_mesh_output(const Scene& scene, const Plan& plan, const std::filesystem::path& file,
                            const MeshOutputOptions& options = {});

}  // namespace sweepkit::scene
