// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include "scene_bounds.hpp"

namespace sweepkit::scene {

/// A light as KHR_lights_punctual has it: colours of at most 1, and how much of them. None where it is black.
///
/// Whitted's diffuse surface sends back d I, glTF's d E / pi: a directional light is pi I lux. A point light
/// of the scene shines alike at every distance and glTF's by E = candela / distance^2, so that one distance
/// is chosen at which both agree: from the light to the bounds' centre, but no less than half the bounds'
/// radius.
std::optional<tinygltf::Light> to_gltf(const Light& light, const Bounds& bounds);

/// Adds the lights and a node for each. Returns those nodes.
std::vector<int> add_lights(tinygltf::Model& model, const std::vector<Light>& lights, const Bounds& bounds);

}  // namespace sweepkit::scene
