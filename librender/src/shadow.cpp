// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "shadow.hpp"

namespace sweepkit::render {

glm::dvec3 light_passing(const scene::Scene& /*scene*/, const Tracer& tracer, const Ray& ray, double end) {
  return glm::dvec3(tracer.is_blocked(ray, end) ? 0.0 : 1.0);
}

}  // namespace sweepkit::render
