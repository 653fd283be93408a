// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_camera.hpp"

#include <algorithm>
#include <numbers>

#include "gltf_transform.hpp"

namespace sweepkit::scene {

int add_camera(tinygltf::Model& model, const Scene& scene, const Bounds& bounds) {
  const Camera& from = scene.camera;
  tinygltf::Camera camera;
  camera.type = "perspective";
  camera.name = "camera";
  camera.perspective.yfov = from.fov_deg * (std::numbers::pi / 180);
  camera.perspective.aspectRatio = static_cast<double>(scene.width) / scene.height;
  // Everything is in the sphere about the bounds, however it is turned; twice that on either side leaves
  // room. Where the eye is within, a thousandth of the way to its target is near enough.
  const double distance = glm::distance(bounds.center(), from.eye);
  camera.perspective.znear =
      std::max(0.5 * (distance - bounds.radius()), 1e-3 * glm::distance(from.target, from.eye));
  camera.perspective.zfar = 2 * (distance + bounds.radius());
  tinygltf::Node node;
  node.name = "camera";
  node.camera = static_cast<int>(model.cameras.size());
  model.cameras.push_back(std::move(camera));
  glm::dmat4 placement(world_from_camera(from));
  placement[3] = glm::dvec4(from.eye, 1);
  place(node, *decompose(placement));
  node.scale.clear();  // 1 but for rounding; a camera has none
  model.nodes.push_back(std::move(node));
  return static_cast<int>(model.nodes.size()) - 1;
}

}  // namespace sweepkit::scene
