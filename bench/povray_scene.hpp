// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::bench {

/// The scene as POV-Ray 3.7 reads it, everything but the camera: the same triangles, normals and (u,v), the
/// same lights without fall-off, the same textures by their files, and materials whose terms are POV-Ray's
/// own (ambient, diffuse, its Blinn-Phong "specular", reflection). Throws std::runtime_error for what has no
/// such counterpart: procedural textures, wraps but "repeat", a texture or highlight that is tinted.
std::string povray_scene(const scene::Document& document, const scene::Scene& scene);

/// Its camera. `shift` moves every ray by a part of a pixel to the right and down.
std::string povray_camera(const scene::Scene& scene, glm::dvec2 shift);

}  // namespace sweepkit::bench
