// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::scene {

/// The light that a scene with neither lights nor ambient gets: from over the viewer's left shoulder.
DirectionalLight default_light(const Camera& camera);
bool has_default_light(const Document& document);

/// The camera carried round its target about +Y, counter-clockwise as seen from above; exact at quarter
/// turns.
Camera turned(const Camera& camera, double degrees);

/// Looks at the scene, made of `document`, from another camera. Lights of the scene stay where they are; the
/// default light goes with the viewer.
void look_from(Scene& scene, const Document& document, const Camera& camera);

}  // namespace sweepkit::scene
