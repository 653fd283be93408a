// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace sweepkit::scene {

/// What a glTF 2.0 file says that it holds. Names are empty where the file gives none.
struct GltfInfo {
  struct Mesh {
    std::string name;
    std::uint64_t triangles = 0;
    std::uint64_t vertices = 0;
    std::string material;  ///< of its first primitive
    std::uint64_t targets = 0;
    std::uint64_t vertex_bytes = 0;  ///< as its accessors count, what meshes share for each; with targets
    std::uint64_t index_bytes = 0;
  };
  struct Material {
    std::string name;
    bool is_textured = false;
  };
  struct Image {
    std::string name;
    std::string file;  ///< beside the glTF file; empty for one inside it
    int width = 0;     ///< pixels; 0 where the image is not there or is neither PNG nor JPEG
    int height = 0;
    std::uint64_t bytes = 0;
    std::string format;  ///< "png", "jpeg" by its content, else what the file calls it, or empty
    bool is_missing = false;
  };
  struct Texture {
    std::string name;
    std::string image;  ///< its name, or its number where it has none; empty where an extension holds it
  };
  struct Camera {
    std::string name;
    std::string type;
  };
  struct Light {
    std::string name;
    std::string type;
    double intensity = 1;
  };
  struct Animation {
    std::string name;
    double seconds = 0;  ///< of its last key
    std::uint64_t channels = 0;
  };
  struct Buffer {
    std::string file;  ///< beside the glTF file; empty for one inside it
    std::uint64_t bytes = 0;
    bool is_missing = false;
  };
  /// Of the views that EXT_meshopt_compression packs.
  struct Packed {
    std::uint64_t views = 0;
    std::uint64_t bytes = 0;           ///< in the file
    std::uint64_t unpacked_bytes = 0;  ///< what they become
  };
  std::string generator;
  std::string copyright;
  bool has_scene = false;  ///< that it was made from (read_gltf_source() reads it)
  std::vector<std::string> extensions_used;
  std::vector<std::string> extensions_required;
  std::vector<Texture> textures;
  std::vector<Camera> cameras;
  std::vector<Light> lights;
  std::vector<Animation> animations;
  std::vector<Buffer> buffers;
  Packed packed;
  std::uint64_t bytes = 0;  ///< of the file itself
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Image> images;
};

/// Reads a .glb or .gltf, whoever wrote it, as far as its JSON and the headers of its images. Buffers and
/// images that should lie beside it and do not are told as missing. Throws
/// InputError naming the file: missing, no glTF, cut short, an index that points nowhere.
GltfInfo read_gltf_info(const std::filesystem::path& file);

}  // namespace sweepkit::scene
