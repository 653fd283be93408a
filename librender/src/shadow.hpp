// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "ray.hpp"
#include "sweepkit/scene/scene.hpp"
#include "tracer.hpp"

namespace sweepkit::render {

/// The share of a light that comes along `ray` from 0 < t < end, by colour.
glm::dvec3 light_passing(const scene::Scene& scene, const Tracer& tracer, const Ray& ray, double end);

}  // namespace sweepkit::render
