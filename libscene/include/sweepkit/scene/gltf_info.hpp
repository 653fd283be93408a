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
  };
  std::string generator;
  std::uint64_t bytes = 0;  ///< of the file itself
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Image> images;
};

/// Reads a .glb or .gltf, whoever wrote it, as far as its JSON and the headers of its images. Throws
/// InputError naming the file: missing, no glTF, cut short, an index that points nowhere.
GltfInfo read_gltf_info(const std::filesystem::path& file);

}  // namespace sweepkit::scene
