// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "lighting.hpp"

#include <cmath>
#include <variant>

#include "shadow_edges.hpp"

namespace sweepkit::render {

glm::dvec3 local_light(const scene::Scene& scene, Shadows shadows, const RowWindow& rows,
                       const Neighbourhood& nodes, const scene::Material& material,
                       const glm::dvec3& diffuse) {
  glm::dvec3 color = glm::dvec3(scene.ambient) * diffuse;
  const auto own = static_cast<std::size_t>(nodes[1][1]);
  if (rows[1]->visibility.points.empty()) return color;
  const LitPoint& at = rows[1]->visibility.points[own];
  const glm::dvec3& direction = rows[1]->nodes[own].direction;
  const glm::dvec3 specular(material.specular);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const ToLight to_light = towards(scene.lights[i], at.start);
    const double cosine = glm::dot(at.normal, to_light.direction);
    if (!(cosine > 0)) continue;
    const glm::dvec3 passing =
        shadows == Shadows::kSmooth ? smooth_share(rows, nodes, i) : own_share(rows, nodes, i);
    if (passing == glm::dvec3(0.0)) continue;
    glm::dvec3 share = diffuse * cosine;
    if (specular != glm::dvec3(0.0)) {
      const glm::dvec3 half = to_light.direction - direction;
      const double length = glm::length(half);
      const double highlight = length > 0 ? glm::dot(at.normal, half) / length : 0;
      if (highlight > 0) share += specular * std::pow(highlight, static_cast<double>(material.shininess));
    }
    const glm::dvec3 intensity(
        std::visit([](const auto& light) { return light.intensity; }, scene.lights[i]));
    color += passing * intensity * share;
  }
  return color;
}

}  // namespace sweepkit::render
