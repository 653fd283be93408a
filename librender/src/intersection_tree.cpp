// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "intersection_tree.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "material_of.hpp"
#include "object_tree.hpp"
#include "position_hash.hpp"
#include "surface_point.hpp"
#include "sweepkit/texmap/area_ratio_mapping.hpp"
#include "sweepkit/texmap/right_triangle.hpp"

namespace sweepkit::render {
namespace {

// What is too small to be followed on its own goes with the other part.
Shares merged(const Shares& shares, double weight) {
  const auto& [mirrored, refracted] = shares;
  const bool splits = mirrored > 0 && refracted > 0;
  if (!splits || weight * std::min(mirrored, refracted) >= kLeastWeight) return shares;
  return mirrored > refracted ? Shares{mirrored + refracted, 0} : Shares{0, mirrored + refracted};
}

}  // namespace

void RayCounts::add(const RayCounts& other) {
  eye += other.eye;
  reflected += other.reflected;
  refracted += other.refracted;
  shadow += other.shadow;
  texcoords += other.texcoords;
  shares += other.shares;
  normals += other.normals;
}

std::size_t TreeRow::bytes() const {
  return roots.capacity() * sizeof(roots[0]) + nodes.capacity() * sizeof(nodes[0]) +
         texcoords.capacity() * sizeof(texcoords[0]) + reflections.capacity() * sizeof(reflections[0]) +
         refractions.capacity() * sizeof(refractions[0]) + shares.capacity() * sizeof(shares[0]) +
         places.capacity() * sizeof(places[0]) + visibility.bytes() + normal_bytes();
}

std::size_t TreeRow::normal_bytes() const {
  return normals.capacity() * sizeof(normals[0]) + differentials.capacity() * sizeof(differentials[0]);
}

TreeBuilder::TreeBuilder(const scene::Scene& scene, const scene::Plan& plan, const Tracer& tracer,
                         const NormalMaps* maps)
    : scene_(scene),
      tracer_(tracer),
      maps_(maps),
      needs_texcoords_(plan.needs_part(scene::Part::kTexcoords)),
      leaves_out_(plan.leaves_out),
      needs_trees_(plan.needs_part(scene::Part::kTrees)),
      needs_refractions_(plan.needs_part(scene::Part::kRefractions)),
      needs_shares_(plan.needs_part(scene::Part::kShares)),
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

std::int32_t TreeBuilder::add_node(TreeRow& row, const Hit& hit, const Ray& ray, std::uint32_t medium,
                                   RayCounts& counts) const {
  const scene::Material& material = material_of(scene_, hit.object);
  // What is seen from inside was run through, wherever the ray came in.
  if (needs_refractions_ && material.transmit > 0 && is_on_inner_side(tracer_, hit, ray.direction))
    medium = hit.object;
  row.nodes.push_back({hit, ray.direction, area_of(hit), medium});
  if (needs_trees_) row.reflections.push_back(kNotTraced);
  if (needs_refractions_) row.refractions.push_back(kNotTraced);
  if (needs_shares_) row.shares.emplace_back();
  if (needs_texcoords_) {
    const bool is_textured = material.texture.has_value() || !leaves_out_;
    row.texcoords.push_back(is_textured ? texcoord_of(hit) : glm::dvec2(0.0));
    counts.texcoords += is_textured ? 1 : 0;
  }
  if (maps_ != nullptr) {
    row.normals.emplace_back(0.0);
    row.differentials.emplace_back();
  }
  return static_cast<std::int32_t>(row.nodes.size()) - 1;
}

glm::dvec3 TreeBuilder::normal_of(TreeRow& row, std::int32_t node, const SurfacePoint& point,
                                  const Growth& growth) const {
  if (maps_ == nullptr) return point.shading_normal;
  const auto index = static_cast<std::size_t>(node);
  const TreeNode& at = row.nodes[index];
  glm::dvec3& normal = row.normals[index];
  normal = point.shading_normal;
  if (material_of(scene_, at.hit.object).normal_map) {
    ++growth.counts.normals;
    normal = maps_->normal(at.hit, at.direction, point, row.differentials[index], texcoord_of(at.hit),
                           *growth.filter);
  }
  return normal;
}

void TreeBuilder::visit(TreeRow& row, std::int32_t node, int level, double weight, std::uint64_t seed,
                        const Growth& growth) const {
  const TreeNode& at = row.nodes[static_cast<std::size_t>(node)];
  const bool is_followed =
      needs_trees_ && level < scene_.depth && scatters(material_of(scene_, at.hit.object));
  if (!is_followed && !needs_shadows_) return;
  const SurfacePoint point = surface_point(tracer_, at.hit, at.direction);
  const glm::dvec3 normal = normal_of(row, node, point, growth);
  if (needs_shadows_) {
    growth.counts.shadow += add_visibility(row.visibility, scene_, tracer_, at.hit, point, normal, seed);
  }
  if (!is_followed) return;
  growth.pending.push_back({node, level, weight, point});
  growth.pending.back().point.shading_normal = normal;
}

void TreeBuilder::add_children(TreeRow& row, const Pending& parent, std::uint64_t seed,
                               const Growth& growth) const {
  const auto index = static_cast<std::size_t>(parent.node);
  const TreeNode node = row.nodes[index];
  const SurfacePoint& point = parent.point;
  const scene::Material& material = material_of(scene_, node.hit.object);
  const glm::dvec3 normal = bent_normal(point, node.direction);
  Shares shares{material.reflect, 0};
  if (needs_shares_) {
    shares = merged(shares_at(material, point, node.direction, normal), parent.weight);
    row.shares[index] = shares;
    ++growth.counts.shares;
  }
  const auto trace = [&](const Ray& ray, std::uint32_t medium, double share, Step step) {
    const Hit hit = tracer_.nearest(ray);
    if (!hit.is_hit()) return kEscaped;
    const std::int32_t child = add_node(row, hit, ray, medium, growth.counts);
    if (maps_ != nullptr) {
      const MetSurface met{node.hit, node.direction, &row.normals[index]};
      row.differentials[static_cast<std::size_t>(child)] =
          going_on(tracer_, met, material, row.differentials[index], step);
    }
    // Another number for each node of the tree.
    const std::uint64_t own_seed = seed + static_cast<std::uint64_t>(child);
    visit(row, child, parent.level + 1, parent.weight * share, own_seed, growth);
    return child;
  };
  if (shares.refracted > 0) {
    const double eta = relative_index(material, point.is_inside);
    const Ray ray = pass_surface(node.hit, point, refracted(point, node.direction, normal, eta));
    ++growth.counts.refracted;
    const std::int32_t child =
        trace(ray, point.is_inside ? kNone : node.hit.object, shares.refracted, Step::kRefracted);
    row.refractions[index] = child;
  }
  if (shares.mirrored > 0) {
    const Ray ray =
        leave_surface(node.hit, point, point.position, glm::normalize(mirrored(node.direction, normal)));
    ++growth.counts.reflected;
    const std::int32_t child = trace(ray, node.medium, shares.mirrored, Step::kReflected);
    row.reflections[index] = child;
  }
}

void TreeBuilder::grow(TreeRow& row, std::int32_t root, std::uint64_t seed, const Growth& growth) const {
  if (root < 0) return;
  visit(row, root, 0, 1, seed, growth);
  while (!growth.pending.empty()) {
    const Pending parent = growth.pending.back();
    growth.pending.pop_back();
    add_children(row, parent, seed - static_cast<std::uint64_t>(root), growth);
  }
}

void TreeBuilder::build(TreeRow& row, const EyeRays& eye_rays, int y, int first, int end, RayCounts& counts,
                        texmap::FilterThread* filter) const {
  row.first_pixel = first;
  row.places.clear();
  for (int x = first; x < end; ++x) row.places.push_back(middle_of(x, y));
  build(row, eye_rays, counts, filter);
}

void TreeBuilder::build(TreeRow& row, const EyeRays& eye_rays, RayCounts& counts,
                        texmap::FilterThread* filter, double side) const {
  constexpr std::size_t kPacket = ObjectTree::kMostRays;
  row.roots.clear();
  row.nodes.clear();
  row.texcoords.clear();
  row.reflections.clear();
  row.refractions.clear();
  row.shares.clear();
  row.visibility.clear();
  row.normals.clear();
  row.differentials.clear();
  row.visibility.channels = scene_.has_dimmed_shadows ? 3 : 1;
  row.visibility.lights = scene_.lights.size();
  std::vector<Pending> pending;
  std::array<Ray, kPacket> rays;
  std::array<Hit, kPacket> hits;
  const Growth growth{pending, counts, filter};
  for (std::size_t first = 0; first < row.places.size(); first += kPacket) {
    const std::size_t count = std::min(kPacket, row.places.size() - first);
    for (std::size_t i = 0; i < count; ++i) rays[i] = eye_rays.through(row.places[first + i]);
    tracer_.nearest(std::span(rays).first(count), std::span(hits).first(count));
    counts.eye += count;
    for (std::size_t i = 0; i < count; ++i) {
      const std::int32_t root = hits[i].is_hit() ? add_node(row, hits[i], rays[i], kNone, counts) : kEscaped;
      row.roots.push_back(root);
      if (maps_ != nullptr && root >= 0)
        row.differentials[static_cast<std::size_t>(root)] =
            eye_rays.differential(row.places[first + i], side);
      grow(row, root, seed_of(row.places[first + i]), growth);
    }
  }
}

}  // namespace sweepkit::render
