// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "intersection_tree.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "material_of.hpp"
#include "position_hash.hpp"
#include "surface_point.hpp"
#include "sweepkit/texmap/area_ratio_mapping.hpp"
#include "sweepkit/texmap/right_triangle.hpp"

namespace sweepkit::render {
namespace {

Ray reflected(const Hit& hit, const SurfacePoint& point, const glm::dvec3& direction) {
  const glm::dvec3 out = mirrored(direction, mirror_normal(point, direction).normal);
  return leave_surface(hit, point, point.position, glm::normalize(out));
}

}  // namespace

std::size_t TreeRow::bytes() const {
  return roots.capacity() * sizeof(roots[0]) + nodes.capacity() * sizeof(nodes[0]) +
         texcoords.capacity() * sizeof(texcoords[0]) + links.capacity() * sizeof(links[0]) +
         visibility.bytes();
}

TreeBuilder::TreeBuilder(const scene::Scene& scene, const scene::Plan& plan, const Tracer& tracer)
    : scene_(scene),
      tracer_(tracer),
      needs_texcoords_(plan.needs_part(scene::Part::kTexcoords)),
      needs_trees_(plan.needs_part(scene::Part::kTrees)),
      needs_shadows_(plan.needs_part(scene::Part::kShadows)) {}

std::uint32_t TreeBuilder::area_of(const Hit& hit) const {
  const std::span<const sweep::Area> areas = tracer_.object(hit.object).mesh->areas;
  const auto after = std::upper_bound(
      areas.begin(), areas.end(), hit.triangle,
      [](std::uint32_t triangle, const sweep::Area& area) { return triangle < area.first_triangle; });
  return after == areas.begin() ? 0 : static_cast<std::uint32_t>(after - areas.begin()) - 1;
}

glm::dvec2 TreeBuilder::texcoord_of(const Hit& hit) const {
  const scene::MeshView& mesh = *tracer_.object(hit.object).mesh;
  const auto& triangle = mesh.triangles[hit.triangle];
  const glm::dvec2 a(mesh.texcoords[triangle[0]]);
  const glm::dvec2 b(mesh.texcoords[triangle[1]]);
  const glm::dvec2 c(mesh.texcoords[triangle[2]]);
  // The paper's case, a right triangle of the texture: two products. Caps have other triangles.
  if (a.x == b.x && c.y == b.y) return texmap::area_ratio_map(texmap::right_triangle(a, b, c), hit.a, hit.c);
  return b + hit.a * (a - b) + hit.c * (c - b);
}

std::int32_t TreeBuilder::add_node(TreeRow& row, const Hit& hit, const Ray& ray, RayCounts& counts) const {
  row.nodes.push_back({hit, ray.direction, area_of(hit)});
  if (needs_trees_) row.links.emplace_back();
  if (needs_texcoords_) {
    const bool is_textured = material_of(scene_, hit.object).texture.has_value();
    row.texcoords.push_back(is_textured ? texcoord_of(hit) : glm::dvec2(0.0));
    counts.texcoords += is_textured ? 1 : 0;
  }
  return static_cast<std::int32_t>(row.nodes.size()) - 1;
}

void TreeBuilder::grow(TreeRow& row, std::int32_t root, std::uint64_t seed, RayCounts& counts) const {
  std::int32_t node = root;
  for (int level = 0; node >= 0; ++level) {
    const TreeNode at = row.nodes[static_cast<std::size_t>(node)];
    const bool is_followed =
        needs_trees_ && level < scene_.depth && material_of(scene_, at.hit.object).reflect > 0;
    if (!is_followed && !needs_shadows_) return;
    const SurfacePoint point = surface_point(tracer_, at.hit, at.direction);
    if (needs_shadows_) {
      counts.shadow += add_visibility(row.visibility, scene_, tracer_, at.hit, point,
                                      seed + static_cast<std::uint64_t>(level));
    }
    if (!is_followed) return;
    const Ray ray = reflected(at.hit, point, at.direction);
    const Hit hit = tracer_.nearest(ray);
    ++counts.reflected;
    const std::int32_t child = hit.is_hit() ? add_node(row, hit, ray, counts) : kEscaped;
    row.links[static_cast<std::size_t>(node)].reflection = child;
    node = child;
  }
}

void TreeBuilder::build(TreeRow& row, const EyeRays& eye_rays, int y, int first, int end,
                        RayCounts& counts) const {
  row.first_pixel = first;
  row.places.clear();
  for (int x = first; x < end; ++x) row.places.push_back(middle_of(x, y));
  build(row, eye_rays, counts);
}

void TreeBuilder::build(TreeRow& row, const EyeRays& eye_rays, RayCounts& counts) const {
  row.roots.clear();
  row.nodes.clear();
  row.texcoords.clear();
  row.links.clear();
  row.visibility.clear();
  std::array<Ray, kPacket> rays;
  std::array<Hit, kPacket> hits;
  for (std::size_t first = 0; first < row.places.size(); first += kPacket) {
    const std::size_t count = std::min(kPacket, row.places.size() - first);
    for (std::size_t i = 0; i < count; ++i) rays[i] = eye_rays.through(row.places[first + i]);
    tracer_.nearest(std::span(rays).first(count), std::span(hits).first(count));
    counts.eye += count;
    for (std::size_t i = 0; i < count; ++i) {
      const std::int32_t root = hits[i].is_hit() ? add_node(row, hits[i], rays[i], counts) : kEscaped;
      row.roots.push_back(root);
      grow(row, root, seed_of(row.places[first + i]), counts);
    }
  }
}

}  // namespace sweepkit::render
