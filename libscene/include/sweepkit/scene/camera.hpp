// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

namespace sweepkit::scene {

struct Camera {
  glm::dvec3 eye{0.0, 0.0, 1.0};
  glm::dvec3 target{0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  double fov_deg = 40;  ///< vertical
};

/// The camera's axes as columns: right, up, and back towards the eye (it looks along -Z, as glTF's does).
/// Where it looks along `up` itself the picture's top is -Z, or +Y where the view is along -Z or +Z.
/// Precondition: eye and target differ, up is not zero.
glm::dmat3 world_from_camera(const Camera& camera);

}  // namespace sweepkit::scene
