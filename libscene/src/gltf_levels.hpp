// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <span>

#include "sweepkit/scene/scene.hpp"

namespace sweepkit::scene {

inline constexpr const char* kLevelsExtension = "MSFT_lod";

/// Makes the model's `node`, of levels[0], point at the nodes that follow it, those of the other levels, with
/// the least share of the picture that a viewer is to show each one at. Precondition: more than one level.
void point_at_levels(tinygltf::Model& model, std::size_t node, std::span<const CoarserMesh> levels);

}  // namespace sweepkit::scene
