// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "intersection_tree.hpp"
#include "sweepkit/scene/scene.hpp"
#include "tracer.hpp"

namespace sweepkit::render {

/// The light that lights and ambient throw on a node: ambient d + sum over lights of V I (d N.L + specular
/// (N.H)^shininess), d the diffuse colour. Counts shadow rays.
glm::dvec3 local_light(const scene::Scene& scene, const Tracer& tracer, const TreeNode& at,
                       const scene::Material& material, const glm::dvec3& diffuse,
                       std::uint64_t& shadow_rays);

}  // namespace sweepkit::render
