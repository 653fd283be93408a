// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "ray.hpp"
#include "sweepkit/scene/scene.hpp"
#include "tracer.hpp"

namespace sweepkit::render {

/// The share of a light that comes along `ray` from 0 < t < end, by colour: `transmit` of each surface on the
/// way, and what absorption leaves inside. The way is straight whatever is refracted. A ray that is inside of
/// what it first leaves was so from the start. Precondition: the direction is unit; `end` may be kNoEnd.
glm::dvec3 light_passing(const scene::Scene& scene, const Tracer& tracer, const Ray& ray, double end);

}  // namespace sweepkit::render
