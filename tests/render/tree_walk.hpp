// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "draw.hpp"
#include "eye_rays.hpp"
#include "intersection_tree.hpp"
#include "tracer.hpp"

namespace sweepkit::render::test {

/// The trees of a stage's rows, for tests that look at rays and not at colours.
struct Grove {
  explicit Grove(const Stage& from)
      : stage(from),
        plan(plan_for(from.document, {})),
        tracer(from.model.scene, plan.needs_part(scene::Part::kObjectTree), Accelerator::kSeads),
        builder(from.model.scene, plan, tracer),
        eye_rays(from.model.scene.camera, from.model.scene.width, from.model.scene.height) {}

  TreeRow row(int y) const {
    TreeRow row;
    RayCounts counts;
    builder.build(row, eye_rays, y, 0, stage.model.scene.width, counts);
    return row;
  }

  const Stage& stage;
  scene::Plan plan;
  Tracer tracer;
  TreeBuilder builder;
  EyeRays eye_rays;
};

/// The share of a pixel that the depth limit cuts off below `node`: what the nodes of the deepest level would
/// have handed on.
inline double share_cut_off(const Grove& grove, const TreeRow& row, std::int32_t node, int level = 0) {
  if (node < 0) return 0;
  const scene::Scene& scene = grove.stage.model.scene;
  const TreeNode& at = row.nodes[static_cast<std::size_t>(node)];
  const scene::Material& material = scene.materials[*scene.objects[at.hit.object].material];
  if (level == scene.depth) {
    const SurfacePoint point = surface_point(grove.tracer, at.hit, at.direction);
    const Shares shares = shares_at(material, point, at.direction, bent_normal(point, at.direction));
    return shares.mirrored + shares.refracted;
  }
  const Shares shares =
      row.shares.empty() ? Shares{material.reflect, 0} : row.shares[static_cast<std::size_t>(node)];
  return shares.mirrored * share_cut_off(grove, row, row.reflection(node), level + 1) +
         shares.refracted * share_cut_off(grove, row, row.refraction(node), level + 1);
}

}  // namespace sweepkit::render::test
