// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <variant>

namespace sweepkit::scene {

/// No fall-off with distance.
struct PointLight {
  glm::dvec3 position{0.0};
  glm::vec3 intensity{1.0f};
  double radius = 0;  ///< metres; over 0 a sphere, which throws soft shadows and is not seen itself
};

struct DirectionalLight {
  glm::dvec3 direction{0.0, -1.0, 0.0};  ///< the way the light travels; not zero, any length
  glm::vec3 intensity{1.0f};
};

using Light = std::variant<PointLight, DirectionalLight>;

}  // namespace sweepkit::scene
