// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sweepkit/scene/gltf.hpp"

namespace sweepkit::scene {

/// The JSON that read_gltf_source() reads: {"sweepkit": {"scene": ..., "options": ...}}, of the options those
/// that are not the usual ones. "" where the options keep no scene.
std::string gltf_extras(const GltfOptions& options);

}  // namespace sweepkit::scene
