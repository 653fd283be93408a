// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace sweepkit::scene {

/// The two parts of a .glb; of a .gltf all is JSON.
struct GltfChunks {
  std::string json;
  std::string binary;
};

/// Throws InputError naming the file: a .glb of another version or cut short. What is no .glb is taken as
/// JSON.
GltfChunks split_gltf(std::string content, const std::string& name);

/// A file's content. Throws InputError naming it.
std::string read_whole_file(const std::filesystem::path& file);

}  // namespace sweepkit::scene
