// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "lighting.hpp"

#include <cmath>
#include <variant>

#include "shadow.hpp"
#include "surface_point.hpp"

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

glm::dvec3 local_light(const scene::Scene& scene, const Tracer& tracer, const TreeNode& at,
                       const scene::Material& material, const glm::dvec3& diffuse,
                       std::uint64_t& shadow_rays) {
  glm::dvec3 color = glm::dvec3(scene.ambient) * diffuse;
  if (scene.lights.empty()) return color;
  const SurfacePoint point = surface_point(tracer, at.hit, at.direction);
  const glm::dvec3 start = smooth_start(tracer, at.hit, point);
  const glm::dvec3 specular(material.specular);
  for (const scene::Light& light : scene.lights) {
    const LightSample to_light = sample(light, start);
    const double cosine = glm::dot(point.shading_normal, to_light.direction);
    if (!(cosine > 0)) continue;
    ++shadow_rays;
    const glm::dvec3 passing = light_passing(
        scene, tracer, leave_surface(at.hit, point, start, to_light.direction), to_light.distance);
    if (passing == glm::dvec3(0.0)) continue;
    glm::dvec3 share = diffuse * cosine;
    if (specular != glm::dvec3(0.0)) {
      const glm::dvec3 half = to_light.direction - at.direction;
      const double length = glm::length(half);
      const double highlight = length > 0 ? glm::dot(point.shading_normal, half) / length : 0;
      if (highlight > 0) share += specular * std::pow(highlight, static_cast<double>(material.shininess));
    }
    color += passing * to_light.intensity * share;
  }
  return color;
}

}  // namespace sweepkit::render
