// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "neighbourhood.hpp"
#include "sweepkit/render/render.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::render {

/// What lights and ambient throw on a node, for a diffuse colour that is not known yet: its own is diffuse
/// times the one and the other added.
struct LocalLight {
  glm::dvec3 on_diffuse{0.0};
  glm::dvec3 highlights{0.0};
};

/// Of the node nodes[1][1]: ambient d + sum over lights of V I (d N.L + specular (N.H)^shininess), d the
/// diffuse colour, V the share of the light that its row has found. A light with a radius shines from its
/// middle, as far as its disc is seen.
LocalLight local_light(const scene::Scene& scene, Shadows shadows, const RowWindow& rows,
                       const Neighbourhood& nodes, const scene::Material& material);

}  // namespace sweepkit::render
