// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "scene_bounds.hpp"

namespace sweepkit::scene {
namespace {

void add(Bounds& bounds, const glm::dvec3& point) {
  bounds.low = glm::min(bounds.low, point);
  bounds.high = glm::max(bounds.high, point);
}

}  // namespace

Bounds bounds_of(const Scene& scene) {
  Bounds bounds;
  Bounds local;  // of the mesh whose further instances follow
  for (const Object& object : scene.objects) {
    const MeshView& mesh = scene.meshes[object.mesh];
    if (object.instance == 0) {
      local = Bounds();
      for (const glm::vec3& position : mesh.positions) {
        const glm::dvec3 at = glm::dvec3(position) + mesh.origin;
        add(local, at);
        add(bounds, glm::dvec3(object.world_from_object * glm::dvec4(at, 1)));
      }
    } else {
      // Every vertex of a million instances would take minutes; the corners of their boxes are a little
      // farther out.
      for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 at((corner & 1) != 0 ? local.high.x : local.low.x,
                            (corner & 2) != 0 ? local.high.y : local.low.y,
                            (corner & 4) != 0 ? local.high.z : local.low.z);
        add(bounds, glm::dvec3(object.world_from_object * glm::dvec4(at, 1)));
      }
    }
  }
  return bounds;
}

}  // namespace sweepkit::scene
