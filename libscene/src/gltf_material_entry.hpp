// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include <optional>
#include <set>
#include <string>

#include "gltf_material.hpp"

namespace sweepkit::scene {

/// The terms as an entry of the file, with the base colour's texture if there is one. Adds to `extensions`
/// those that it uses.
tinygltf::Material material_entry(const std::string& name, const GltfMaterial& terms,
                                  std::optional<int> texture, std::set<std::string>& extensions);

}  // namespace sweepkit::scene
