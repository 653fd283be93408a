// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Akdemir98, 3.2.2, Fig. 4]. A textured node is filtered over what its neighbours' (u,v) say a
// pixel covers; neighbours are the nodes on the same reflection and refraction path that hit the same area of
// the same object. Departs from the paper in asking for one neighbour beside and one above or below, not for
// all eight, unless told to: a silhouette then is filtered as well. Where not even those are there (something
// one pixel wide), the footprint comes from the derivatives of the pixel's own ray (ray_differential.hpp).

#include "texture_lookup.hpp"

#include <array>
#include <cmath>

#include "path_differential.hpp"

namespace sweepkit::render {

namespace {

std::optional<glm::dvec2> texcoord_beside(const RowWindow& rows, const Neighbourhood& nodes, std::size_t r,
                                          std::size_t c) {
  const std::optional<std::size_t> other = on_same_piece(rows, nodes, r, c);
  return other ? std::optional(rows[r]->texcoords[*other]) : std::nullopt;
}

}  // namespace

std::optional<glm::vec3> TextureLookup::filtered(const RowWindow& rows, const Neighbourhood& nodes,
                                                 double side, const texmap::TextureSampler& sampler,
                                                 texmap::FilterThread& filter) const {
  const auto own = static_cast<std::size_t>(nodes[1][1]);
  const TreeNode& at = rows[1]->nodes[own];
  const glm::dvec2 hit = rows[1]->texcoords[own];
  const sweep::Area& area = tracer_.object(at.hit.object).mesh->areas[at.area];
  const glm::dvec2 period(area.u_period, area.v_period);
  if (footprint_ == Footprint::kNeighbours) {
    std::array<glm::dvec2, 8> around;
    std::size_t count = 0;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (r == 1 && c == 1) continue;
        const std::optional<glm::dvec2> uv = texcoord_beside(rows, nodes, r, c);
        if (!uv) return std::nullopt;
        around[count++] = *uv;
      }
    }
    if (texmap::reads_table(filter_))
      return sampler.over_box(texmap::neighbour_box(hit, around, period), filter);
  }
  std::optional<texmap::Footprint> footprint = footprint_beside(rows, nodes);
  if (!footprint) return std::nullopt;
  footprint->dx *= side;
  footprint->dy *= side;
  return sampler.sample(*footprint, filter);
}

std::optional<texmap::Footprint> TextureLookup::footprint_beside(const RowWindow& rows,
                                                                 const Neighbourhood& nodes) const {
  const auto own = static_cast<std::size_t>(nodes[1][1]);
  const TreeNode& at = rows[1]->nodes[own];
  const sweep::Area& area = tracer_.object(at.hit.object).mesh->areas[at.area];
  const auto neighbour = [&](std::size_t r, std::size_t c) { return texcoord_beside(rows, nodes, r, c); };
  const texmap::Beside beside{neighbour(1, 0), neighbour(1, 2), neighbour(0, 1), neighbour(2, 1)};
  return texmap::footprint_from(rows[1]->texcoords[own], beside, glm::dvec2(area.u_period, area.v_period));
}

void TextureLookup::look_in_vain(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path,
                                 LookupCounts& counts) const {
  if (looks_round_ && footprint_beside(rows, nodes)) ++counts.filtered;
  if (!has_differentials_) return;
  const glm::dvec2 uv = rows[1]->texcoords[static_cast<std::size_t>(nodes[1][1])];
  const texmap::Footprint footprint = footprint_of(tracer_, path.node->hit, moved_hit(path), uv);
  if (footprint.uv == uv) ++counts.differentials;
}

glm::dvec3 TextureLookup::pattern_place(const TreeRow& row, std::size_t node, texmap::ProceduralOn on) const {
  if (on == texmap::ProceduralOn::kUv) return glm::dvec3(row.texcoords[node], 0);
  const Hit& hit = row.nodes[node].hit;
  const scene::MeshView& mesh = *tracer_.object(hit.object).mesh;
  const auto& [a, b, c] = mesh.triangles[hit.triangle];
  return mesh.origin + hit.a * glm::dvec3(mesh.positions[a]) + hit.b * glm::dvec3(mesh.positions[b]) +
         hit.c * glm::dvec3(mesh.positions[c]);
}

std::optional<texmap::PatternFootprint> TextureLookup::pattern_footprint(const RowWindow& rows,
                                                                         const Neighbourhood& nodes,
                                                                         double side,
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
  return texmap::PatternFootprint{here, side * *dx, side * *dy};
}

HitDifferential TextureLookup::moved_hit(const NodePath& path) const {
  return at_hit(tracer_, path.node->hit, path.node->direction, arriving(scene_, tracer_, path));
}

DiffuseColor TextureLookup::diffuse(const RowWindow& rows, const Neighbourhood& nodes, const NodePath& path,
                                    const scene::Material& material, texmap::FilterThread& filter,
                                    LookupCounts& counts) const {
  const glm::dvec3 base(material.diffuse);
  if (!material.texture) {
    if (!leaves_out_) look_in_vain(rows, nodes, path, counts);
    return {base, base};
  }
  const auto seen_by_filter = [&](const glm::vec3& texel) -> DiffuseColor {
    const glm::dvec3 color = base * glm::dvec3(texel);
    return {color, filter_ == texmap::Filter::kBox ? base : color};
  };
  const auto seen_at_a_point = [&](const glm::vec3& texel) -> DiffuseColor {
    const glm::dvec3 color = base * glm::dvec3(texel);
    return {color, color};
  };
  ++counts.textured;
  // The paper's neighbours or nothing; but a ray without any has nothing else.
  const bool uses_differentials =
      has_differentials_ && (footprint_ != Footprint::kNeighbours || path.eye.is_alone);
  const auto own = static_cast<std::size_t>(nodes[1][1]);
  const glm::dvec2 uv = rows[1]->texcoords.empty() ? glm::dvec2(0.0) : rows[1]->texcoords[own];
  if (const std::optional<texmap::TextureSampler>& sampler = samplers_[*material.texture]) {
    if (looks_round_ && texmap::reads_footprint(filter_)) {
      if (const std::optional<glm::vec3> color = filtered(rows, nodes, path.eye.side, *sampler, filter)) {
        ++counts.filtered;
        return seen_by_filter(*color);
      }
    }
    if (uses_differentials && texmap::reads_footprint(filter_)) {
      ++counts.differentials;
      return seen_by_filter(
          sampler->sample(footprint_of(tracer_, path.node->hit, moved_hit(path), uv), filter));
    }
    // Nothing tells how large the pixel is here: as large as a texel, then.
    return seen_at_a_point(sampler->sample({uv}, filter));
  }
  const auto& procedural = std::get<texmap::Procedural>(scene_.textures[*material.texture]);
  if (looks_round_) {
    if (const auto footprint = pattern_footprint(rows, nodes, path.eye.side, procedural.on)) {
      ++counts.filtered;
      return seen_at_a_point(texmap::evaluate(procedural, *footprint));
    }
  }
  texmap::PatternFootprint footprint{pattern_place(*rows[1], own, procedural.on)};
  if (uses_differentials) {
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
  return seen_at_a_point(texmap::evaluate(procedural, footprint));
}

}  // namespace sweepkit::render
