// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Akdemir98, 3.2.2]. The trees of the nine pixels about one are descended together, so that nodes
// met together are on the same path of reflections and refractions.
//
// colour = ambient d + sum over lights of V I (d N.L + specular (N.H)^shininess) + reflect R + transmit T,
// d = diffuse times texture; what comes from inside an object is dimmed by its absorption on the way.

#include "shading.hpp"

#include "lighting.hpp"
#include "material_of.hpp"
#include "path_differential.hpp"
#include "scattering.hpp"
#include "surface_point.hpp"

namespace sweepkit::render {
namespace {

std::int32_t child_of(const TreeRow& row, std::int32_t node, Step step) {
  return step == Step::kReflected ? row.reflection(node) : row.refraction(node);
}

}  // namespace

glm::dvec3 Shader::pixel(const RowWindow& rows, const EyeRays& eye_rays, int x, int y,
                         texmap::FilterThread& filter, ShadingCounts& counts) const {
  const std::int32_t root = rows[1]->root(x);
  if (root < 0) {
    if (!environment_.is_picture()) return glm::dvec3(scene_.background);
    return background(eye_rays.through(x, y).direction, eye_rays.differential(x, y), filter, counts);
  }
  Neighbourhood nodes;
  nodes[1][1] = root;
  if (looks_round_) {
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) nodes[r][c] = rows[r]->root(x + static_cast<int>(c) - 1);
    }
  }
  const NodePath path{
      &rows[1]->nodes[static_cast<std::size_t>(root)], nullptr, Step::kReflected, &eye_rays, x, y};
  return dimmed_node(rows, nodes, path, filter, counts);
}

glm::dvec3 Shader::node(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path,
                        texmap::FilterThread& filter, ShadingCounts& counts) const {
  const std::int32_t index = nodes[1][1];
  const TreeNode& at = *path.node;
  const scene::Material& material = material_of(scene_, at.hit.object);
  const Shares shares = rows[1]->shares.empty() ? Shares{material.reflect, 0}
                                                : rows[1]->shares[static_cast<std::size_t>(index)];
  // The deeper nodes first.
  glm::dvec3 from_deeper(0.0);
  if (shares.mirrored > 0)
    from_deeper += shares.mirrored * child(rows, nodes, path, Step::kReflected, filter, counts);
  if (shares.refracted > 0)
    from_deeper += shares.refracted * child(rows, nodes, path, Step::kRefracted, filter, counts);
  ++counts.nodes;
  const glm::dvec3 color = textures_.diffuse(rows, nodes, path, material, filter, counts.lookups);
  return local_light(scene_, tracer_, at, material, color, counts.shadow_rays) + from_deeper;
}

glm::dvec3 Shader::dimmed_node(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path,
                               texmap::FilterThread& filter, ShadingCounts& counts) const {
  const glm::dvec3 color = node(rows, nodes, path, filter, counts);
  const std::uint32_t medium = path.node->medium;
  return medium == kNone ? color : color * absorbed(material_of(scene_, medium), path.node->hit.t);
}

glm::dvec3 Shader::child(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path, Step step,
                         texmap::FilterThread& filter, ShadingCounts& counts) const {
  const std::int32_t index = child_of(*rows[1], nodes[1][1], step);
  // At the deepest level nothing comes; from outside, the background.
  if (index == kNotTraced) return glm::dvec3(0.0);
  if (index == kEscaped) return escaped(path, step, filter, counts);
  Neighbourhood children;
  children[1][1] = index;
  for (std::size_t r = 0; looks_round_ && r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c)
      children[r][c] = nodes[r][c] >= 0 ? child_of(*rows[r], nodes[r][c], step) : kNotTraced;
  }
  const NodePath longer{
      &rows[1]->nodes[static_cast<std::size_t>(index)], &path, step, path.eye_rays, path.x, path.y};
  return dimmed_node(rows, children, longer, filter, counts);
}

glm::dvec3 Shader::escaped(const NodePath& path, Step step, texmap::FilterThread& filter,
                           ShadingCounts& counts) const {
  if (!environment_.is_picture()) return glm::dvec3(scene_.background);
  // The ray's direction, worked out again as the tree's builder did.
  const TreeNode& at = *path.node;
  const SurfacePoint point = surface_point(tracer_, at.hit, at.direction);
  const glm::dvec3 normal = bent_normal(point, at.direction);
  const double eta = relative_index(material_of(scene_, at.hit.object), point.is_inside);
  const glm::dvec3 direction = step == Step::kReflected ? glm::normalize(mirrored(at.direction, normal))
                                                        : refracted(point, at.direction, normal, eta);
  const RayDifferential ray =
      environment_.reads_differentials() ? going_on(scene_, tracer_, path, step) : RayDifferential{};
  return background(direction, ray, filter, counts);
}

glm::dvec3 Shader::background(const glm::dvec3& direction, const RayDifferential& ray,
                              texmap::FilterThread& filter, ShadingCounts& counts) const {
  ++counts.environment_lookups;
  return environment_.color(direction, ray.direction_x, ray.direction_y, filter);
}

}  // namespace sweepkit::render
