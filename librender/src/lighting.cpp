// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "lighting.hpp"

#include <cmath>
#include <variant>

#include "shadow_edges.hpp"

namespace sweepkit::render {

LocalLight local_light(const scene::Scene& scene, Shadows shadows, const RowWindow& rows,
                       const Neighbourhood& nodes, const scene::Material& material) {
  LocalLight light{.on_diffuse = glm::dvec3(scene.ambient)};
  const auto own = static_cast<std::size_t>(nodes[1][1]);
  if (rows[1]->visibility.points.empty()) return light;
  const LitPoint& at = rows[1]->visibility.points[own];
  const glm::dvec3& normal = rows[1]->normals.empty() ? at.normal : rows[1]->normals[own];
  const glm::dvec3& direction = rows[1]->nodes[own].direction;
  const glm::dvec3 specular(material.specular);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const ToLight to_light = towards(scene.lights[i], at.start);
    const double cosine = glm::dot(normal, to_light.direction);
    if (!(cosine > 0)) continue;
    const glm::dvec3 passing =
        shadows == Shadows::kSmooth ? smooth_share(rows, nodes, i) : own_share(rows, nodes, i);
    if (passing == glm::dvec3(0.0)) continue;
    const glm::dvec3 intensity(
        std::visit([](const auto& source) { return source.intensity; }, scene.lights[i]));
    const glm::dvec3 coming = passing * intensity;
    light.on_diffuse += cosine * coming;
    if (specular == glm::dvec3(0.0)) continue;
    const glm::dvec3 half = to_light.direction - direction;
    const double length = glm::length(half);
    const double highlight = length > 0 ? glm::dot(normal, half) / length : 0;
    if (highlight > 0)
      light.highlights += std::pow(highlight, static_cast<double>(material.shininess)) * specular * coming;
  }
  return light;
}

}  // namespace sweepkit::render
