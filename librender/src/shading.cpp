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

const glm::dvec3* normal_at(const TreeRow& row, std::int32_t node) {
  return row.normals.empty() ? nullptr : &row.normals[static_cast<std::size_t>(node)];
}

}  // namespace

void ShadingCounts::add(const ShadingCounts& other) {
  nodes += other.nodes;
  smoothed += other.smoothed;
  environment_lookups += other.environment_lookups;
  lookups.textured += other.lookups.textured;
  lookups.filtered += other.lookups.filtered;
  lookups.differentials += other.lookups.differentials;
}

TreeColor Shader::seen(const RowWindow& rows, const Neighbourhood& nodes, const EyeSample& eye,
                       texmap::FilterThread& filter, ShadingCounts& counts) const {
  const std::int32_t root = nodes[1][1];
  if (root >= 0) {
    const NodePath path{&rows[1]->nodes[static_cast<std::size_t>(root)], nullptr, Step::kReflected, eye,
                        normal_at(*rows[1], root)};
    const TreeLight light = dimmed_node(rows, nodes, path, filter, counts);
    return {glm::dvec4(light.color, 1), light.plain};
  }
  if (leaves_background_out_) return {glm::dvec4(0.0), glm::dvec3(0.0)};
  const glm::dvec3 color = environment_.is_picture()
                               ? background(eye.eye_rays->through(eye.place).direction,
                                            eye.eye_rays->differential(eye.place, eye.side), filter, counts)
                               : glm::dvec3(scene_.background);
  return {glm::dvec4(color, 0), color};
}

TreeColor Shader::pixel(const RowWindow& rows, const EyeRays& eye_rays, int x, texmap::FilterThread& filter,
                        ShadingCounts& counts) const {
  Neighbourhood nodes;
  nodes[1][1] = rows[1]->root(x);
  if (looks_round_) {
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) nodes[r][c] = rows[r]->root(x + static_cast<int>(c) - 1);
    }
  }
  const glm::dvec2& place = rows[1]->places[static_cast<std::size_t>(x - rows[1]->first_pixel)];
  return seen(rows, nodes, {&eye_rays, place}, filter, counts);
}

TreeColor Shader::sample(const TreeRow& row, const EyeRays& eye_rays, std::size_t index, double side,
                         texmap::FilterThread& filter, ShadingCounts& counts) const {
  Neighbourhood nodes;
  for (auto& beside : nodes) beside.fill(kNotTraced);
  nodes[1][1] = row.roots[index];
  return seen({&row, &row, &row}, nodes, {&eye_rays, row.places[index], side, true}, filter, counts);
}

TreeLight Shader::node(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path,
                       texmap::FilterThread& filter, ShadingCounts& counts) const {
  const std::int32_t index = nodes[1][1];
  const TreeNode& at = *path.node;
  const scene::Material& material = material_of(scene_, at.hit.object);
  const Shares shares = rows[1]->shares.empty() ? Shares{material.reflect, 0}
                                                : rows[1]->shares[static_cast<std::size_t>(index)];
  // The deeper nodes first.
  TreeLight deeper;
  const auto add = [&](double share, Step step) {
    if (!(share > 0)) return;
    const TreeLight light = child(rows, nodes, path, step, filter, counts);
    deeper.color += share * light.color;
    deeper.plain += share * light.plain;
  };
  add(shares.mirrored, Step::kReflected);
  add(shares.refracted, Step::kRefracted);
  ++counts.nodes;
  if (shadows_ == Shadows::kSmooth) ++counts.smoothed;
  const DiffuseColor diffuse = textures_.diffuse(rows, nodes, path, material, filter, counts.lookups);
  const LocalLight light = local_light(scene_, shadows_, rows, nodes, material);
  return {diffuse.color * light.on_diffuse + light.highlights + deeper.color,
          diffuse.plain * light.on_diffuse + light.highlights + deeper.plain};
}

TreeLight Shader::dimmed_node(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path,
                              texmap::FilterThread& filter, ShadingCounts& counts) const {
  const TreeLight light = node(rows, nodes, path, filter, counts);
  const std::uint32_t medium = path.node->medium;
  if (medium == kNone) return light;
  const glm::dvec3 left = absorbed(material_of(scene_, medium), path.node->hit.t);
  return {light.color * left, light.plain * left};
}

TreeLight Shader::child(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path, Step step,
                        texmap::FilterThread& filter, ShadingCounts& counts) const {
  const std::int32_t index = child_of(*rows[1], nodes[1][1], step);
  // At the deepest level nothing comes; from outside, the background.
  if (index == kNotTraced) return {};
  if (index == kEscaped) {
    const glm::dvec3 color = escaped(path, step, filter, counts);
    return {color, color};
  }
  Neighbourhood children;
  children[1][1] = index;
  for (std::size_t r = 0; looks_round_ && r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c)
      children[r][c] = nodes[r][c] >= 0 ? child_of(*rows[r], nodes[r][c], step) : kNotTraced;
  }
  const NodePath longer{&rows[1]->nodes[static_cast<std::size_t>(index)], &path, step, path.eye,
                        normal_at(*rows[1], index)};
  return dimmed_node(rows, children, longer, filter, counts);
}

glm::dvec3 Shader::escaped(const NodePath& path, Step step, texmap::FilterThread& filter,
                           ShadingCounts& counts) const {
  if (!environment_.is_picture()) return glm::dvec3(scene_.background);
  // The ray's direction, worked out again as the tree's builder did.
  const TreeNode& at = *path.node;
  SurfacePoint point = surface_point(tracer_, at.hit, at.direction);
  if (path.normal != nullptr) point.shading_normal = *path.normal;
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
