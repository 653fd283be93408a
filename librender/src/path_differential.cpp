// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "path_differential.hpp"

#include "material_of.hpp"

namespace sweepkit::render {

RayDifferential arriving(const scene::Scene& scene, const Tracer& tracer, const NodePath& path) {
  return path.from == nullptr ? path.eye.eye_rays->differential(path.eye.place, path.eye.side)
                              : going_on(scene, tracer, *path.from, path.step);
}

RayDifferential going_on(const scene::Scene& scene, const Tracer& tracer, const NodePath& path, Step step) {
  const RayDifferential ray = arriving(scene, tracer, path);
  const Hit& hit = path.node->hit;
  const glm::dvec3& direction = path.node->direction;
  const HitDifferential at = at_hit(tracer, hit, direction, ray);
  return step == Step::kReflected
             ? reflected(tracer, hit, direction, ray, at)
             : refracted(tracer, hit, direction, ray, at, material_of(scene, hit.object));
}

}  // namespace sweepkit::render
