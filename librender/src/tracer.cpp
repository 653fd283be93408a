// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Akdemir98, 3.3] and [Fujimoto86]: a grid an object, in the object's own space and so oriented to
// it, and a global one over the objects. The paper divides "with respect to the number of contour and
// trajectory curves" so that a voxel holds about six triangles at most. Here the counts give the mean area of
// a triangle and that the voxel's side: a voxel of side h that a surface passes holds about h^2 / area
// triangles and their neighbours.

#include "tracer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "triangle_box_overlap.hpp"
#include "triangle_intersection.hpp"

namespace sweepkit::render {
namespace {

// Measured on the paper's vase (median occupancy and time a ray, docs/algorithms/seads.md): a smaller voxel
// spends more on walking than it saves on triangles.
constexpr double kVoxelAreas = 1.5;
constexpr double kVoxelsPerTriangle = 8;

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

VoxelGrid grid_over(const scene::MeshView& mesh) {
  Box box;
  double area = 0;
  for (const sweep::Triangle& triangle : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[triangle[0]]);
    const glm::dvec3 b(mesh.positions[triangle[1]]);
    const glm::dvec3 c(mesh.positions[triangle[2]]);
    box.add(a);
    box.add(b);
    box.add(c);
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  const auto count = static_cast<double>(mesh.triangles.size());
  VoxelGrid grid = make_grid(box, std::sqrt(kVoxelAreas * area / count), kVoxelsPerTriangle * count + 8);
  fill_grid(
      grid, static_cast<std::uint32_t>(mesh.triangles.size()),
      [&](std::uint32_t t) {
        Box bounds;
        for (const std::uint32_t v : mesh.triangles[t]) bounds.add(glm::dvec3(mesh.positions[v]));
        return bounds;
      },
      [&](std::uint32_t t, const Box& voxel) {
        const auto& [a, b, c] = mesh.triangles[t];
        return overlaps(glm::dvec3(mesh.positions[a]), glm::dvec3(mesh.positions[b]),
                        glm::dvec3(mesh.positions[c]), voxel);
      });
  return grid;
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

bool test_triangle(const scene::MeshView& mesh, const ShearedRay& ray, std::uint32_t triangle, double end,
                   Hit& hit) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return ray.meets(mesh.positions[a], mesh.positions[b], mesh.positions[c], end, hit);
}

void keep_nearer(Hit& best, Hit found, std::uint32_t object, std::uint32_t triangle) {
  if (best.is_hit() && best.is_before(found.t, object, triangle)) return;
  found.object = object;
  found.triangle = triangle;
  best = found;
}

// The triangles tested last, so that one lying in several voxels is tested once. A small direct-mapped
// memory: a miss costs one more test and nothing else.
class Recent {
 public:
  bool add(std::uint32_t triangle) {
    std::uint32_t& slot = slots_[triangle % kSlots];
    if (slot == triangle) return false;
    slot = triangle;
    return true;
  }

 private:
  static constexpr std::size_t kSlots = 16;
  std::array<std::uint32_t, kSlots> slots_ = [] {
    std::array<std::uint32_t, kSlots> none{};
    none.fill(kNone);
    return none;
  }();
};

void nearest_in_grid(const TracedObject& object, std::uint32_t index, const Ray& world_ray, Hit& best) {
  const Ray ray = to_mesh_space(object, world_ray);
  const ShearedRay sheared(ray);
  const VoxelGrid& grid = object.grid;
  Recent recent;
  walk(grid, ray, best.t, [&](std::size_t voxel, double exit) {
    for (std::uint32_t i = grid.first[voxel]; i < grid.first[voxel + 1]; ++i) {
      const std::uint32_t triangle = grid.items[i];
      Hit found;
      if (recent.add(triangle) && test_triangle(*object.mesh, sheared, triangle, best.t, found) &&
          !ray.leaves(index, triangle)) {
        keep_nearer(best, found, index, triangle);
      }
    }
    return best.t < exit;  // what lies beyond this voxel is farther
  });
}

bool is_blocked_in_grid(const TracedObject& object, std::uint32_t index, const Ray& world_ray, double end) {
  const Ray ray = to_mesh_space(object, world_ray);
  const ShearedRay sheared(ray);
  const VoxelGrid& grid = object.grid;
  Recent recent;
  bool is_blocked = false;
  walk(grid, ray, end, [&](std::size_t voxel, double) {
    for (std::uint32_t i = grid.first[voxel]; i < grid.first[voxel + 1] && !is_blocked; ++i) {
      const std::uint32_t triangle = grid.items[i];
      Hit found;
      is_blocked = recent.add(triangle) && test_triangle(*object.mesh, sheared, triangle, end, found) &&
                   found.t < end && !ray.leaves(index, triangle);
    }
    return is_blocked;
  });
  return is_blocked;
}

}  // namespace

Tracer::Tracer(const scene::Scene& scene, bool has_global_grid, Search search)
    : has_global_grid_(has_global_grid && search == Search::kGrids), search_(search) {
  for (const scene::Object& entry : scene.objects) {
    TracedObject object;
    object.mesh = &scene.meshes[entry.mesh];
    glm::dmat4 from_origin(1.0);
    from_origin[3] = glm::dvec4(object.mesh->origin, 1);
    object.world_from_mesh = entry.world_from_object * from_origin;
    object.mesh_from_world = affine_inverse(object.world_from_mesh);
    object.normal_to_world = glm::transpose(glm::dmat3(object.mesh_from_world));
    if (search_ == Search::kGrids && !object.mesh->triangles.empty()) object.grid = grid_over(*object.mesh);
    objects_.push_back(std::move(object));
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
  if (search_ == Search::kLinear) {
    for (std::uint32_t i = 0; i < objects_.size(); ++i) {
      const ShearedRay sheared(to_mesh_space(objects_[i], ray));
      for (std::uint32_t t = 0; t < objects_[i].mesh->triangles.size(); ++t) {
        Hit found;
        if (test_triangle(*objects_[i].mesh, sheared, t, best.t, found) && !ray.leaves(i, t))
          keep_nearer(best, found, i, t);
      }
    }
    return best;
  }
  for_objects_along(ray, kNoEnd, [&](std::uint32_t object, double exit) {
    if (object != kNone) nearest_in_grid(objects_[object], object, ray, best);
    return object == kNone && best.t < exit;
  });
  return best;
}

bool Tracer::is_blocked(const Ray& ray, double end) const {
  bool is_blocked = false;
  if (search_ == Search::kLinear) {
    for (std::uint32_t i = 0; i < objects_.size() && !is_blocked; ++i) {
      const ShearedRay sheared(to_mesh_space(objects_[i], ray));
      for (std::uint32_t t = 0; t < objects_[i].mesh->triangles.size() && !is_blocked; ++t) {
        Hit found;
        is_blocked =
            test_triangle(*objects_[i].mesh, sheared, t, end, found) && found.t < end && !ray.leaves(i, t);
      }
    }
    return is_blocked;
  }
  for_objects_along(ray, end, [&](std::uint32_t object, double) {
    if (object != kNone) is_blocked = is_blocked_in_grid(objects_[object], object, ray, end);
    return is_blocked;
  });
  return is_blocked;
}

}  // namespace sweepkit::render
