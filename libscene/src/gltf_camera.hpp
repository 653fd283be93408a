// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include "scene_bounds.hpp"

namespace sweepkit::scene {

/// Adds the scene's camera, with depths that hold everything however it is turned, and a node for it. Returns
/// that node.
int add_camera(tinygltf::Model& model, const Scene& scene, const Bounds& bounds);

}  // namespace sweepkit::scene
