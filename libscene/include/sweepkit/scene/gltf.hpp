// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sweepkit/scene/plan.hpp"
#include "sweepkit/scene/scene.hpp"
#include "sweepkit/texmap/image_file.hpp"

namespace sweepkit::scene {

class ImageStore;

/// What the file asks of viewers. Nothing is required: a viewer without an extension shows less.
enum class GltfLook {
  kFull,        ///< mirrors, glass and indices of refraction by the KHR_materials extensions
  kUnlit,       ///< colours and textures as they are, without light: KHR_materials_unlit
  kCompatible,  ///< no extension at all; glass is blended with what is behind it
};

enum class GltfImages {
  kByContainer,  ///< inside a .glb, beside a .gltf
  kEmbedded,
  kSeparate,
};

struct GltfOptions {
  std::optional<std::string> object;    ///< this object alone
  int bake_size = 1024;                 ///< texels on the longer side of a baked procedural texture
  std::optional<double> texel_density;  ///< in place of it: texels a metre (texel_density.hpp)
  bool has_tangents = false;            ///< TANGENT for every vertex (sweepkit/sweep/tangents.hpp)
  GltfLook look = GltfLook::kFull;
  GltfImages images_in = GltfImages::kByContainer;
  /// PNG or JPEG for every image. None: a PNG or JPEG file that fits is copied as it is, others become PNG.
  std::optional<texmap::ImageFormat> image_format;
  int max_texture = 0;           ///< larger images are made smaller; texels on a side, 0: as they are
  double turntable_seconds = 0;  ///< that a turn of everything about +Y takes, as an animation; 0: none
  int levels = 0;                ///< of detail that the scene was given by add_levels(), for the extras
  double grow_seconds = 0;       ///< in which what is swept grows from start to end, as one; 0: none
  std::string copyright;         ///< UTF-8; empty: none
  /// Positions in 16 bits, normals and tangents in 8, (u,v) between 0 and 1 in 16: KHR_mesh_quantization,
  /// which viewers are then required to know. Positions are off by half of (longest side of the mesh's box) /
  /// (2^position_bits - 1) an axis at most, parts of normals by 1/254, (u,v) by 1/131070.
  bool is_quantized = false;
  /// 8 to 16, where quantized. None: 16; where packed, 8 to 14, the fewest with steps of at most 1/32 of the
  /// triangles' shortest edges on average.
  std::optional<int> position_bits;
  /// EXT_meshopt_compression, required too: vertices and triangles in another order and packed, of
  /// unquantized ones the same bits; (u,v) and tangents only where something is textured.
  bool is_packed = false;
  /// No name, no camera, no extras; (u,v) and tangents as in a packed file.
  bool is_minimal = false;
  /// The scene's JSON (SceneFile::text()), kept in the file's extras with these options, where
  /// read_gltf_source() finds them. Empty: nothing is kept.
  std::string scene;
  ImageStore* images = nullptr;  ///< keeps encoded and baked images for the files to come
  int threads = 0;               ///< that bake a texture; 0: as many as the machine has. The file is the same
};

struct NamedBytes {
  std::string name;  ///< file name without folder
  std::vector<std::byte> bytes;
};

struct GltfFile {
  std::vector<NamedBytes> files;  ///< what stands beside (.bin, images), then the .glb or .gltf itself
  Ledger ledger;                  ///< bakes, thicknesses
  std::size_t triangles_without_area = 0;  ///< left out, since quantizing made them an edge or a point
  std::size_t targets = 0;                 ///< the most morph targets that a mesh grows by
  double grow_error = 0;  ///< metres that a growing end is from where it should be, the most in an object
};

/// A GltfFile whose bytes are in pieces, many of them the scene's own arrays: the scene must outlive it.
struct GltfPieces {
  struct File {
    std::string name;
    std::vector<std::span<const std::byte>> pieces;
  };
  std::vector<File> files;
  std::deque<std::vector<std::byte>> kept;  ///< what pieces point to beside the scene
  Ledger ledger;
  std::size_t triangles_without_area = 0;
  std::size_t targets = 0;  ///< the most morph targets that a mesh grows by
  double grow_error = 0;    ///< metres that a growing end is from where it should be, the most in an object
};

/// The scene as glTF 2.0: one node, one mesh and one primitive for each object, named for it; where an
/// object has several instances the node has a child for each, and they share the mesh. .glb holds
/// everything; .gltf has its buffer and images beside it, named for `file`. Positions are relative to each
/// mesh's origin, which is in its node in double. Coarser meshes have nodes of their own, which the
/// finest's node points at by MSFT_lod; viewers that do not know it show the finest. Arrays, images and
/// materials that are equal are written once, and a PNG or JPEG that needs no change is copied byte for
/// byte. The same scene gives the same bytes. Throws InputError for an unknown object, one without
/// triangles or with none left when quantized, one that an instance shears, a copyright that is no UTF-8,
/// growing where nothing is swept, with vertices that are quantized or packed, or with levels of detail,
/// or a file over 2 GiB.
GltfPieces make_gltf_pieces(const Scene& scene, const Plan& plan, const std::filesystem::path& file,
                            const GltfOptions& options);

/// The same, each file in one piece.
GltfFile make_gltf(const Scene& scene, const Plan& plan, const std::filesystem::path& file,
                   const GltfOptions& options);

}  // namespace sweepkit::scene
