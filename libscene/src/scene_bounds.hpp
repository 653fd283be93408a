// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <limits>

#include "sweepkit/scene/scene.hpp"

namespace sweepkit::scene {

struct Bounds {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  glm::dvec3 center() const { return 0.5 * (low + high); }
  double radius() const { return 0.5 * glm::length(high - low); }  ///< of the sphere about them
};

/// Of all objects in the world; of further instances that of their boxes, a little farther out.
Bounds bounds_of(const Scene& scene);

}  // namespace sweepkit::scene
