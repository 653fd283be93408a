// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Akdemir98, 3.2.2, Fig. 4]. A textured node is filtered over what its neighbours' (u,v) say a
// pixel covers; neighbours are the nodes on the same reflection and refraction path that hit the same area of
// the same object. The trees of the nine pixels are descended together, so that nodes met together are on the
// same path. Departs from the paper in asking for one neighbour beside and one above or below, not for all
// eight, unless told to: a silhouette then is filtered as well. Where not even those are there (something one
// pixel wide), the footprint comes from the derivatives of the pixel's own ray (ray_differential.hpp).
//
// colour = ambient d + sum over lights of V I (d N.L + specular (N.H)^shininess) + reflect R, d = diffuse
// times texture.

#include "shading.hpp"

#include <cmath>

#include "material_of.hpp"
#include "surface_point.hpp"
#include "sweepkit/texmap/footprint.hpp"
#include "sweepkit/texmap/procedural.hpp"

namespace sweepkit::render {
namespace {

struct LightSample {
  glm::dvec3 direction;  ///< towards the light, unit
  double distance;       ///< in lengths of it
  glm::dvec3 intensity;
};

LightSample sample(const scene::Light& light, const glm::dvec3& from) {
  if (const auto* point = std::get_if<scene::PointLight>(&light)) {
    const glm::dvec3 to = point->position - from;
    const double distance = glm::length(to);
    return {distance > 0 ? to / distance : glm::dvec3(0.0), distance, glm::dvec3(point->intensity)};
  }
  const auto& directional = std::get<scene::DirectionalLight>(light);
  return {-glm::normalize(directional.direction), kNoEnd, glm::dvec3(directional.intensity)};
}

}  // namespace

glm::dvec3 Shader::pixel(const RowWindow& rows, const EyeRays& eye_rays, int x, int y,
                         texmap::FilterThread& filter, ShadingCounts& counts) const {
  const std::int32_t root = rows[1]->root(x);
  if (root < 0) return glm::dvec3(scene_.background);
  Neighbourhood nodes;
  nodes[1][1] = root;
  if (looks_round_) {
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) nodes[r][c] = rows[r]->root(x + static_cast<int>(c) - 1);
    }
  }
  const Path path{&rows[1]->nodes[static_cast<std::size_t>(root)], nullptr, &eye_rays, x, y};
  return node(rows, nodes, path, filter, counts);
}

glm::dvec3 Shader::node(const RowWindow& rows, const Neighbourhood& nodes, const Path& path,
                        texmap::FilterThread& filter, ShadingCounts& counts) const {
  const std::int32_t index = nodes[1][1];
  const TreeNode& at = rows[1]->nodes[static_cast<std::size_t>(index)];
  const scene::Material& material = material_of(scene_, at.hit.object);

  // The deeper node first. At the deepest level nothing comes; from outside, the background.
  glm::dvec3 reflection(0.0);
  const std::int32_t child = rows[1]->reflection(index);
  if (child == kEscaped) {
    reflection = glm::dvec3(scene_.background);
  } else if (child >= 0) {
    Neighbourhood children;
    children[1][1] = child;
    for (std::size_t r = 0; looks_round_ && r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c)
        children[r][c] = nodes[r][c] >= 0 ? rows[r]->reflection(nodes[r][c]) : kNotTraced;
    }
    const Path longer{&rows[1]->nodes[static_cast<std::size_t>(child)], &path, path.eye_rays, path.x, path.y};
    reflection = node(rows, children, longer, filter, counts);
  }
  ++counts.nodes;
  const glm::dvec3 color = diffuse(rows, nodes, path, material, filter, counts);
  return local_light(at, material, color, counts) + static_cast<double>(material.reflect) * reflection;
}

std::optional<std::size_t> Shader::on_same_piece(const RowWindow& rows, const Neighbourhood& nodes,
                                                 std::size_t r, std::size_t c) {
  if (nodes[r][c] < 0) return std::nullopt;
  const TreeNode& at = rows[1]->nodes[static_cast<std::size_t>(nodes[1][1])];
  const auto other = static_cast<std::size_t>(nodes[r][c]);
  const TreeNode& node = rows[r]->nodes[other];
  if (node.hit.object != at.hit.object || node.area != at.area) return std::nullopt;
  return other;
}

std::optional<glm::vec3> Shader::filtered(const RowWindow& rows, const Neighbourhood& nodes,
                                          const texmap::TextureSampler& sampler,
                                          texmap::FilterThread& filter) const {
  const auto own = static_cast<std::size_t>(nodes[1][1]);
  const TreeNode& at = rows[1]->nodes[own];
  const glm::dvec2 hit = rows[1]->texcoords[own];
  const sweep::Area& area = tracer_.object(at.hit.object).mesh->areas[at.area];
  const glm::dvec2 period(area.u_period, area.v_period);
  const auto neighbour = [&](std::size_t r, std::size_t c) -> std::optional<glm::dvec2> {
    const std::optional<std::size_t> other = on_same_piece(rows, nodes, r, c);
    return other ? std::optional(rows[r]->texcoords[*other]) : std::nullopt;
  };
  if (footprint_ == Footprint::kNeighbours) {
    std::array<glm::dvec2, 8> around;
    std::size_t count = 0;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (r == 1 && c == 1) continue;
        const std::optional<glm::dvec2> uv = neighbour(r, c);
        if (!uv) return std::nullopt;
        around[count++] = *uv;
      }
    }
    if (texmap::reads_table(filter_))
      return sampler.over_box(texmap::neighbour_box(hit, around, period), filter);
  }
  const texmap::Beside beside{neighbour(1, 0), neighbour(1, 2), neighbour(0, 1), neighbour(2, 1)};
  const std::optional<texmap::Footprint> footprint = texmap::footprint_from(hit, beside, period);
  if (!footprint) return std::nullopt;
  return sampler.sample(*footprint, filter);
}

glm::dvec3 Shader::pattern_place(const TreeRow& row, std::size_t node, texmap::ProceduralOn on) const {
  if (on == texmap::ProceduralOn::kUv) return glm::dvec3(row.texcoords[node], 0);
  const Hit& hit = row.nodes[node].hit;
  const scene::MeshView& mesh = *tracer_.object(hit.object).mesh;
  const auto& [a, b, c] = mesh.triangles[hit.triangle];
  return mesh.origin + hit.a * glm::dvec3(mesh.positions[a]) + hit.b * glm::dvec3(mesh.positions[b]) +
         hit.c * glm::dvec3(mesh.positions[c]);
}

std::optional<texmap::PatternFootprint> Shader::pattern_footprint(const RowWindow& rows,
                                                                  const Neighbourhood& nodes,
                                                                  texmap::ProceduralOn on) const {
  const auto own = static_cast<std::size_t>(nodes[1][1]);
  const TreeNode& at = rows[1]->nodes[own];
  const glm::dvec3 here = pattern_place(*rows[1], own, on);
  glm::dvec3 period(0.0);
  if (on == texmap::ProceduralOn::kUv) {
    const sweep::Area& area = tracer_.object(at.hit.object).mesh->areas[at.area];
    period = {area.u_period, area.v_period, 0};
  }
  // The way to the neighbour; across a seam the short way.
  const auto way_to = [&](std::size_t r, std::size_t c) -> std::optional<glm::dvec3> {
    const std::optional<std::size_t> other = on_same_piece(rows, nodes, r, c);
    if (!other) return std::nullopt;
    glm::dvec3 way = pattern_place(*rows[r], *other, on) - here;
    for (glm::length_t k = 0; k < 2; ++k) {
      if (period[k] > 0) way[k] -= period[k] * std::nearbyint(way[k] / period[k]);
    }
    return way;
  };
  for (std::size_t at_index = 0; footprint_ == Footprint::kNeighbours && at_index < 9; ++at_index) {
    if (!way_to(at_index / 3, at_index % 3)) return std::nullopt;
  }
  // Half the way between the two beside, or to the one that is there.
  const auto step = [](const std::optional<glm::dvec3>& before, const std::optional<glm::dvec3>& after) {
    if (before && after) return std::optional(0.5 * (*after - *before));
    return before ? std::optional(-*before) : after;
  };
  const std::optional<glm::dvec3> dx = step(way_to(1, 0), way_to(1, 2));
  const std::optional<glm::dvec3> dy = step(way_to(0, 1), way_to(2, 1));
  if (!dx || !dy) return std::nullopt;
  return texmap::PatternFootprint{here, *dx, *dy};
}

RayDifferential Shader::differential(const Path& path) const {
  if (path.from == nullptr) return path.eye_rays->differential(path.x, path.y);
  const RayDifferential ray = differential(*path.from);
  const TreeNode& mirror = *path.from->node;
  return reflected(tracer_, mirror.hit, mirror.direction, ray,
                   at_hit(tracer_, mirror.hit, mirror.direction, ray));
}

HitDifferential Shader::moved_hit(const Path& path) const {
  return at_hit(tracer_, path.node->hit, path.node->direction, differential(path));
}

glm::dvec3 Shader::diffuse(const RowWindow& rows, const Neighbourhood& nodes, const Path& path,
                           const scene::Material& material, texmap::FilterThread& filter,
                           ShadingCounts& counts) const {
  const glm::dvec3 base(material.diffuse);
  if (!material.texture) return base;
  ++counts.textured;
  const auto own = static_cast<std::size_t>(nodes[1][1]);
  const glm::dvec2 uv = rows[1]->texcoords.empty() ? glm::dvec2(0.0) : rows[1]->texcoords[own];
  if (const std::optional<texmap::TextureSampler>& sampler = samplers_[*material.texture]) {
    if (looks_round_ && texmap::reads_footprint(filter_)) {
      if (const std::optional<glm::vec3> color = filtered(rows, nodes, *sampler, filter)) {
        ++counts.filtered;
        return base * glm::dvec3(*color);
      }
    }
    if (uses_differentials_ && texmap::reads_footprint(filter_)) {
      ++counts.differentials;
      return base *
             glm::dvec3(sampler->sample(footprint_of(tracer_, path.node->hit, moved_hit(path), uv), filter));
    }
    // Nothing tells how large the pixel is here: as large as a texel, then.
    return base * glm::dvec3(sampler->sample({uv}, filter));
  }
  const auto& procedural = std::get<texmap::Procedural>(scene_.textures[*material.texture]);
  if (looks_round_) {
    if (const auto footprint = pattern_footprint(rows, nodes, procedural.on)) {
      ++counts.filtered;
      return base * glm::dvec3(texmap::evaluate(procedural, *footprint));
    }
  }
  texmap::PatternFootprint footprint{pattern_place(*rows[1], own, procedural.on)};
  if (uses_differentials_) {
    ++counts.differentials;
    const HitDifferential moved = moved_hit(path);
    if (procedural.on == texmap::ProceduralOn::kUv) {
      const texmap::Footprint on_uv = footprint_of(tracer_, path.node->hit, moved, uv);
      footprint.dx = glm::dvec3(on_uv.dx, 0);
      footprint.dy = glm::dvec3(on_uv.dy, 0);
    } else {
      const glm::dmat3 to_mesh(tracer_.object(path.node->hit.object).mesh_from_world);
      footprint.dx = to_mesh * moved.x;
      footprint.dy = to_mesh * moved.y;
    }
  }
  return base * glm::dvec3(texmap::evaluate(procedural, footprint));
}

glm::dvec3 Shader::local_light(const TreeNode& at, const scene::Material& material, const glm::dvec3& diffuse,
                               ShadingCounts& counts) const {
  glm::dvec3 color = glm::dvec3(scene_.ambient) * diffuse;
  if (scene_.lights.empty()) return color;
  const SurfacePoint point = surface_point(tracer_, at.hit, at.direction);
  const glm::dvec3 start = smooth_start(tracer_, at.hit, point);
  const glm::dvec3 specular(material.specular);
  for (const scene::Light& light : scene_.lights) {
    const LightSample to_light = sample(light, start);
    const double cosine = glm::dot(point.shading_normal, to_light.direction);
    if (!(cosine > 0)) continue;
    ++counts.shadow_rays;
    if (tracer_.is_blocked(leave_surface(at.hit, point, start, to_light.direction), to_light.distance))
      continue;
    glm::dvec3 share = diffuse * cosine;
    if (specular != glm::dvec3(0.0)) {
      const glm::dvec3 half = to_light.direction - at.direction;
      const double length = glm::length(half);
      const double highlight = length > 0 ? glm::dot(point.shading_normal, half) / length : 0;
      if (highlight > 0) share += specular * std::pow(highlight, static_cast<double>(material.shininess));
    }
    color += to_light.intensity * share;
  }
  return color;
}

}  // namespace sweepkit::render
