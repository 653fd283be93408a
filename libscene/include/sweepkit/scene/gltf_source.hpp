// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "sweepkit/scene/gltf.hpp"

namespace sweepkit::scene {

/// What a glTF file was made from.
struct GltfSource {
  std::string scene;    ///< a scene's JSON
  GltfOptions options;  ///< but for `images` and `scene`
};

/// Does the name end in .glb or .gltf?
bool is_gltf_name(const std::filesystem::path& file);

/// Reads what make_gltf() keeps in a file's extras: made anew from it the file has the same bytes, as long as
/// the files that the scene names are the same. Those are not in it, and their names are as they stood.
/// Throws InputError naming the file: missing, no glTF, cut short, without a scene (another program's, or one
/// that was not to keep it), options out of range.
GltfSource read_gltf_source(const std::filesystem::path& file);

}  // namespace sweepkit::scene
