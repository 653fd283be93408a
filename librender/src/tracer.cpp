// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "tracer.hpp"

#include "sweepkit/strict_math.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <limits>

namespace sweepkit::render {
namespace {

glm::dmat3 inverse_of(const glm::dmat3& matrix) {
  // Cofactors of a lopsided matrix lose digits; a step of Newton's brings them back.
  const glm::dmat3 rough = glm::inverse(matrix);
  return rough + rough * (glm::dmat3(1.0) - matrix * rough);
}

Ray to_mesh_space(const TracedObject& object, const Ray& ray) {
  // Direction not normalized: t is the same in both spaces.
  return {object.mesh_from_world * glm::dvec4(ray.origin, 1),
          glm::dmat3(object.mesh_from_world) * ray.direction, ray.from_object, ray.from_triangle};
}

Box box_of(const scene::MeshView& mesh) {
  Box box;
  for (const glm::vec3& position : mesh.positions) box.add(glm::dvec3(position));
  return box;
}

Box to_world(const Box& local, const glm::dmat4x3& world_from_mesh) {
  Box world;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 p((corner & 1) != 0 ? local.high.x : local.low.x,
                       (corner & 2) != 0 ? local.high.y : local.low.y,
                       (corner & 4) != 0 ? local.high.z : local.low.z, 1);
    world.add(world_from_mesh * p);
  }
  return world;
}

bool is_flat(const scene::MeshView& mesh) {
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    if (std::ranges::all_of(mesh.positions, [&](const glm::vec3& position) {
          return position[axis] == mesh.positions[0][axis];
        }))
      return true;
  }
  return false;
}

double largest(const glm::dvec3& vector) {
  const glm::dvec3 size = glm::abs(vector);
  return std::max({size.x, size.y, size.z});
}

// By how much the way to the mesh's space and back enlarges a relative error: 1 to 3 for turns and for scales
// that are the same in all directions.
double amplification(const TracedObject& object) {
  glm::dmat3 there(object.mesh_from_world);
  glm::dmat3 back(object.world_from_mesh);
  for (int axis = 0; axis < 3; ++axis) {
    there[axis] = glm::abs(there[axis]);
    back[axis] = glm::abs(back[axis]);
  }
  return largest(back * there * glm::dvec3(1.0));
}

}  // namespace

Tracer::Tracer(const scene::Scene& scene, bool has_object_tree, Accelerator accelerator)
    : has_object_tree_(has_object_tree && accelerator != Accelerator::kLinear) {
  accelerators_.resize(scene.meshes.size());
  objects_.reserve(scene.objects.size());
  for (const scene::Object& entry : scene.objects) {
    TracedObject object;
    object.mesh = &scene.meshes[entry.mesh];
    const glm::dmat3 linear(entry.world_from_object);
    const glm::dmat3 inverse = inverse_of(linear);
    object.world_from_mesh = glm::dmat4x3(linear);
    object.world_from_mesh[3] = glm::dvec3(entry.world_from_object * glm::dvec4(object.mesh->origin, 1));
    object.mesh_from_world = glm::dmat4x3(inverse);
    object.mesh_from_world[3] = -(inverse * object.world_from_mesh[3]);
    object.normal_to_world = glm::transpose(inverse);
    auto& shared = accelerators_[entry.mesh];
    if (!shared && !object.mesh->triangles.empty()) {
      shared = make_accelerator(
          *object.mesh, accelerator == Accelerator::kAuto ? choose_accelerator(*object.mesh) : accelerator);
    }
    object.accelerator = shared.get();
    object.is_flat = is_flat(*object.mesh);
    objects_.push_back(object);
  }
  if (!has_object_tree_) return;
  std::vector<Box> local(scene.meshes.size());
  for (std::size_t i = 0; i < local.size(); ++i) {
    if (accelerators_[i]) local[i] = box_of(scene.meshes[i]);
  }
  std::vector<Box> boxes(objects_.size());
  std::vector<std::uint32_t> met;
  met.reserve(objects_.size());
  double reach = 0;
  double amplified = 1;
  for (std::uint32_t i = 0; i < objects_.size(); ++i) {
    const TracedObject& object = objects_[i];
    if (object.accelerator == nullptr) continue;
    boxes[i] = to_world(local[scene.objects[i].mesh], object.world_from_mesh);
    reach =
        std::max({reach, largest(boxes[i].low), largest(boxes[i].high), largest(object.world_from_mesh[3])});
    amplified = std::max(amplified, amplification(object));
    met.push_back(i);
  }
  // A ray comes to the mesh by sums of 4 products of numbers no larger than these, through an inverse that is
  // good to as many roundings, and the triangle test is good to a few more: 64 bound them all with room.
  const double rounding = 64 * std::numeric_limits<double>::epsilon() * amplified;
  tree_ = ObjectTree(boxes, std::move(met), rounding, reach);
}

Hit Tracer::nearest(const Ray& ray) const {
  Hit best;
  const auto look_in = [&](std::uint32_t index) {
    const TracedObject& object = objects_[index];
    if (object.can_be_met_by(ray, index))
      object.accelerator->find_nearest(to_mesh_space(object, ray), index, best);
    return false;
  };
  if (has_object_tree_) {
    tree_.walk(ray, best.t, look_in);
  } else {
    for (std::uint32_t i = 0; i < objects_.size(); ++i) look_in(i);
  }
  return best;
}

void Tracer::nearest(std::span<const Ray> rays, std::span<Hit> hits) const {
  assert(rays.size() <= ObjectTree::kMostRays && hits.size() >= rays.size());
  std::fill_n(hits.begin(), rays.size(), Hit());
  std::array<Ray, ObjectTree::kMostRays> moved;
  std::array<Hit, ObjectTree::kMostRays> best;
  const auto look_in = [&](std::uint32_t index, std::uint32_t mask) {
    const TracedObject& object = objects_[index];
    if (object.accelerator == nullptr) return;
    std::size_t count = 0;
    for (std::uint32_t left = mask; left != 0; left &= left - 1, ++count) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      moved[count] = to_mesh_space(object, rays[i]);
      best[count] = hits[i];
    }
    object.accelerator->find_nearest(std::span(moved).first(count), index, std::span(best).first(count));
    count = 0;
    for (std::uint32_t left = mask; left != 0; left &= left - 1, ++count)
      hits[static_cast<std::size_t>(std::countr_zero(left))] = best[count];
  };
  if (has_object_tree_) {
    tree_.walk(
        rays, [&](std::size_t i) { return hits[i].t; }, look_in);
  } else {
    const auto all = static_cast<std::uint32_t>((std::uint64_t{1} << rays.size()) - 1);
    for (std::uint32_t i = 0; i < objects_.size(); ++i) look_in(i, all);
  }
}

bool Tracer::is_blocked(const Ray& ray, double end) const {
  const auto blocks = [&](std::uint32_t index) {
    const TracedObject& object = objects_[index];
    return object.can_be_met_by(ray, index) &&
           object.accelerator->is_blocked(to_mesh_space(object, ray), index, end);
  };
  if (!has_object_tree_) {
    for (std::uint32_t i = 0; i < objects_.size(); ++i) {
      if (blocks(i)) return true;
    }
    return false;
  }
  bool is_blocked = false;
  tree_.walk(ray, end, [&](std::uint32_t index) { return is_blocked = blocks(index); });
  return is_blocked;
}

}  // namespace sweepkit::render
