// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "object_reader.hpp"
#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {

/// How things look: textures, materials, lights.
std::vector<TextureEntry> read_textures(const Node& node, const std::filesystem::path& folder);
Material read_material(const std::string& name, const Node& node, const std::vector<TextureEntry>& textures);
Light read_light(const Node& node);

}  // namespace sweepkit::scene
