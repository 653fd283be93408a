// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/turntable.hpp"

namespace sweepkit::scene {

DirectionalLight default_light(const Camera& camera) {
  const glm::dmat3 axes = world_from_camera(camera);
  return {axes * glm::normalize(glm::dvec3(0.5, -0.7, -1.0)), glm::vec3(1.0f)};
}

bool has_default_light(const Document& document) {
  return document.lights.empty() && !document.has_ambient;
}

Camera turned(const Camera& camera, double degrees) {
  const glm::dmat3 turn(to_matrix({.rotate_deg = glm::dvec3(0, degrees, 0)}));
  Camera result = camera;
  if (degrees == 0) return result;
  result.eye = camera.target + turn * (camera.eye - camera.target);
  result.up = turn * camera.up;
  return result;
}

void look_from(Scene& scene, const Document& document, const Camera& camera) {
  scene.camera = camera;
  scene.has_default_light = has_default_light(document);
  if (scene.has_default_light) scene.lights = {default_light(camera)};
}

}  // namespace sweepkit::scene
