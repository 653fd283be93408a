// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Akdemir98, 3.2.2]. The trees of the nine pixels about one are descended together, so that nodes
// met together are on the same path.
//
// colour = ambient d + sum over lights of V I (d N.L + specular (N.H)^shininess) + reflect R, d = diffuse
// times texture.

#include "shading.hpp"

#include "lighting.hpp"
#include "material_of.hpp"

namespace sweepkit::render {

TreeColor Shader::pixel(const RowWindow& rows, const EyeRays& eye_rays, int x, texmap::FilterThread& filter,
                        ShadingCounts& counts) const {
  const std::int32_t root = rows[1]->root(x);
  if (root < 0) return {glm::dvec3(scene_.background), glm::dvec3(scene_.background)};
  Neighbourhood nodes;
  nodes[1][1] = root;
  if (looks_round_) {
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) nodes[r][c] = rows[r]->root(x + static_cast<int>(c) - 1);
    }
  }
  const glm::dvec2& place = rows[1]->places[static_cast<std::size_t>(x - rows[1]->first_pixel)];
  const NodePath path{&rows[1]->nodes[static_cast<std::size_t>(root)], nullptr, {&eye_rays, place}};
  return node(rows, nodes, path, filter, counts);
}

TreeColor Shader::sample(const TreeRow& row, const EyeRays& eye_rays, std::size_t index, double side,
                         texmap::FilterThread& filter, ShadingCounts& counts) const {
  const std::int32_t root = row.roots[index];
  if (root < 0) return {glm::dvec3(scene_.background), glm::dvec3(scene_.background)};
  Neighbourhood nodes;
  for (auto& beside : nodes) beside.fill(kNotTraced);
  nodes[1][1] = root;
  const NodePath path{
      &row.nodes[static_cast<std::size_t>(root)], nullptr, {&eye_rays, row.places[index], side, true}};
  return node({&row, &row, &row}, nodes, path, filter, counts);
}

TreeColor Shader::node(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path,
                       texmap::FilterThread& filter, ShadingCounts& counts) const {
  const std::int32_t index = nodes[1][1];
  const TreeNode& at = rows[1]->nodes[static_cast<std::size_t>(index)];
  const scene::Material& material = material_of(scene_, at.hit.object);

  // The deeper node first. At the deepest level nothing comes; from outside, the background.
  TreeColor reflection{glm::dvec3(0.0), glm::dvec3(0.0)};
  const std::int32_t child = rows[1]->reflection(index);
  if (child == kEscaped) {
    reflection.color = reflection.plain = glm::dvec3(scene_.background);
  } else if (child >= 0) {
    Neighbourhood children;
    children[1][1] = child;
    for (std::size_t r = 0; looks_round_ && r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c)
        children[r][c] = nodes[r][c] >= 0 ? rows[r]->reflection(nodes[r][c]) : kNotTraced;
    }
    const NodePath longer{&rows[1]->nodes[static_cast<std::size_t>(child)], &path, path.eye};
    reflection = node(rows, children, longer, filter, counts);
  }
  ++counts.nodes;
  if (shadows_ == Shadows::kSmooth) ++counts.smoothed;
  const DiffuseColor diffuse = textures_.diffuse(rows, nodes, path, material, filter, counts.lookups);
  const LocalLight light = local_light(scene_, shadows_, rows, nodes, material);
  const auto share = static_cast<double>(material.reflect);
  return {diffuse.color * light.on_diffuse + light.highlights + share * reflection.color,
          diffuse.plain * light.on_diffuse + light.highlights + share * reflection.plain};
}

}  // namespace sweepkit::render
