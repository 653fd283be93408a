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
  const MetSurface met{path.node->hit, path.node->direction, path.normal};
  return going_on(tracer, met, material_of(scene, met.hit.object), arriving(scene, tracer, path), step);
}

}  // namespace sweepkit::render
