// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "neighbourhood.hpp"
#include "sweepkit/render/render.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::render {

/// The light that lights and ambient throw on the node nodes[1][1]: ambient d + sum over lights of V I (d N.L
/// + specular (N.H)^shininess), d the diffuse colour, V the share of the light that its row has found. A
/// light with a radius shines from its middle, as far as its disc is seen.
glm::dvec3 local_light(const scene::Scene& scene, Shadows shadows, const RowWindow& rows,
                       const Neighbourhood& nodes, const scene::Material& material,
                       const glm::dvec3& diffuse);

}  // namespace sweepkit::render
