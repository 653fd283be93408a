// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Akdemir98, 3.3]: a global grid over the objects' bounding boxes.

#include "tracer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "recent.hpp"

namespace sweepkit::render {
namespace {

glm::dmat4 affine_inverse(const glm::dmat4& matrix) {
  // Cofactors of a lopsided matrix lose digits; a step of Newton's brings them back.
  const glm::dmat3 rough = glm::inverse(glm::dmat3(matrix));
  const glm::dmat3 linear = rough + rough * (glm::dmat3(1.0) - glm::dmat3(matrix) * rough);
  glm::dmat4 inverse(linear);
  inverse[3] = glm::dvec4(-(linear * glm::dvec3(matrix[3])), 1);
  return inverse;
}

Ray to_mesh_space(const TracedObject& object, const Ray& ray) {
  // Direction not normalized: t is the same in both spaces.
  return {glm::dvec3(object.mesh_from_world * glm::dvec4(ray.origin, 1)),
          glm::dmat3(object.mesh_from_world) * ray.direction, ray.from_object, ray.from_triangle};
}

Box world_box(const TracedObject& object) {
  Box local;
  for (const glm::vec3& position : object.mesh->positions) local.add(glm::dvec3(position));
  Box world;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p((corner & 1) != 0 ? local.high.x : local.low.x,
                       (corner & 2) != 0 ? local.high.y : local.low.y,
                       (corner & 4) != 0 ? local.high.z : local.low.z);
    world.add(glm::dvec3(object.world_from_mesh * glm::dvec4(p, 1)));
  }
  return world;
}

}  // namespace

Tracer::Tracer(const scene::Scene& scene, bool has_global_grid, Accelerator accelerator)
    : has_global_grid_(has_global_grid && accelerator != Accelerator::kLinear) {
  accelerators_.resize(scene.meshes.size());
  for (const scene::Object& entry : scene.objects) {
    TracedObject object;
    object.mesh = &scene.meshes[entry.mesh];
    glm::dmat4 from_origin(1.0);
    from_origin[3] = glm::dvec4(object.mesh->origin, 1);
    object.world_from_mesh = entry.world_from_object * from_origin;
    object.mesh_from_world = affine_inverse(object.world_from_mesh);
    object.normal_to_world = glm::transpose(glm::dmat3(object.mesh_from_world));
    auto& shared = accelerators_[entry.mesh];
    if (!shared && !object.mesh->triangles.empty())
      shared = make_accelerator(*object.mesh,
                                accelerator == Accelerator::kAuto ? Accelerator::kSeads : accelerator);
    object.accelerator = shared.get();
    objects_.push_back(object);
  }
  if (!has_global_grid_) return;
  std::vector<Box> boxes;
  Box all;
  for (const TracedObject& object : objects_) {
    boxes.push_back(world_box(object));
    all.add(boxes.back().low);
    all.add(boxes.back().high);
  }
  const glm::dvec3 size = all.high - all.low;
  // A few voxels an object; their shape follows the whole box's.
  const double wanted = 8.0 * static_cast<double>(objects_.size()) + 56;
  global_ = make_grid(all, std::max({size.x, size.y, size.z}) / std::cbrt(wanted) / 2, wanted);
  fill_grid(
      global_, static_cast<std::uint32_t>(objects_.size()), [&](std::uint32_t i) { return boxes[i]; },
      [](std::uint32_t, const Box&) { return true; });
}

// Calls on_object(index, t where the voxel ends) for the objects whose boxes the ray may meet; it returns
// true to stop.
template <class OnObject>
void Tracer::for_objects_along(const Ray& ray, double end, OnObject&& on_object) const {
  if (!has_global_grid_) {
    for (std::uint32_t i = 0; i < objects_.size(); ++i) {
      if (on_object(i, kNoEnd)) return;
    }
    return;
  }
  Recent recent;
  walk(global_, ray, end, [&](std::size_t voxel, double exit) {
    bool stops = false;
    for (std::uint32_t i = global_.first[voxel]; i < global_.first[voxel + 1] && !stops; ++i) {
      if (recent.add(global_.items[i])) stops = on_object(global_.items[i], kNoEnd);
    }
    return stops || on_object(kNone, exit);
  });
}

Hit Tracer::nearest(const Ray& ray) const {
  Hit best;
  for_objects_along(ray, kNoEnd, [&](std::uint32_t index, double exit) {
    if (index == kNone) return best.t < exit;
    const TracedObject& object = objects_[index];
    if (object.accelerator != nullptr)
      object.accelerator->find_nearest(to_mesh_space(object, ray), index, best);
    return false;
  });
  return best;
}

void Tracer::nearest(std::span<const Ray> rays, std::span<Hit> hits) const {
  if (has_global_grid_) {
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = nearest(rays[i]);
    return;
  }
  std::fill(hits.begin(), hits.end(), Hit{});
  std::array<Ray, kPacket> moved;
  for (std::uint32_t index = 0; index < objects_.size(); ++index) {
    const TracedObject& object = objects_[index];
    if (object.accelerator == nullptr) continue;
    for (std::size_t first = 0; first < rays.size(); first += kPacket) {
      const std::size_t count = std::min(kPacket, rays.size() - first);
      for (std::size_t i = 0; i < count; ++i) moved[i] = to_mesh_space(object, rays[first + i]);
      object.accelerator->find_nearest(std::span<const Ray>(moved).first(count), index,
                                       hits.subspan(first, count));
    }
  }
}

bool Tracer::is_blocked(const Ray& ray, double end) const {
  bool is_blocked = false;
  for_objects_along(ray, end, [&](std::uint32_t index, double) {
    if (index == kNone) return false;
    const TracedObject& object = objects_[index];
    is_blocked = object.accelerator != nullptr &&
                 object.accelerator->is_blocked(to_mesh_space(object, ray), index, end);
    return is_blocked;
  });
  return is_blocked;
}

}  // namespace sweepkit::render
