// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "neighbourhood.hpp"
#include "ray_differential.hpp"
#include "sweepkit/scene/scene.hpp"
#include "tracer.hpp"

namespace sweepkit::render {

/// Of the ray that arrives at the path's last node. Carried from the eye on; no further ray is traced.
RayDifferential arriving(const scene::Scene& scene, const Tracer& tracer, const NodePath& path);

/// Of the ray that goes on from there.
RayDifferential going_on(const scene::Scene& scene, const Tracer& tracer, const NodePath& path, Step step);

}  // namespace sweepkit::render
