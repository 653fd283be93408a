// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_lights.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sweepkit::scene {
namespace {

constexpr const char* kExtension = "KHR_lights_punctual";

// The turn of -Z, the way a glTF light shines, to `direction`: its quaternion is (Z' x d, 1 + Z'.d) made of
// length 1, and where that is 0 - the two are opposite - half a turn about Y.
std::vector<double> turn_to(const glm::dvec3& direction) {
  const glm::dvec3 ahead(0, 0, -1);
  const glm::dvec3 way = glm::normalize(direction);
  const glm::dvec4 turn(glm::cross(ahead, way), 1 + glm::dot(ahead, way));
  const double length = glm::length(turn);
  if (length < 1e-9) return {0, 1, 0, 0};
  return {turn.x / length, turn.y / length, turn.z / length, turn.w / length};
}

double brightness_factor(const DirectionalLight&, const Bounds&) {
  return std::numbers::pi;
}

double brightness_factor(const PointLight& light, const Bounds& bounds) {
  const double distance = std::max(glm::distance(light.position, bounds.center()), 0.5 * bounds.radius());
  return std::numbers::pi * distance * distance;
}

void place(tinygltf::Node& node, const DirectionalLight& light) {
  node.rotation = turn_to(light.direction);
}

void place(tinygltf::Node& node, const PointLight& light) {
  node.translation = {light.position.x, light.position.y, light.position.z};
}

}  // namespace

std::optional<tinygltf::Light> to_gltf(const Light& light, const Bounds& bounds) {
  return std::visit(
      [&](const auto& source) -> std::optional<tinygltf::Light> {
        const glm::dvec3 intensity(source.intensity);
        const double most = std::max({intensity.x, intensity.y, intensity.z});
        if (!(most > 0)) return std::nullopt;
        tinygltf::Light entry;
        entry.type = std::holds_alternative<PointLight>(light) ? "point" : "directional";
        entry.color = {intensity.x / most, intensity.y / most, intensity.z / most};
        entry.intensity = most * brightness_factor(source, bounds);
        return entry;
      },
      light);
}

std::vector<int> add_lights(tinygltf::Model& model, const std::vector<Light>& lights, const Bounds& bounds) {
  std::vector<int> nodes;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    std::optional<tinygltf::Light> light = to_gltf(lights[i], bounds);
    if (!light) continue;
    const std::string name = "light " + std::to_string(i + 1);
    light->name = name;
    tinygltf::Node node;
    node.name = name;
    node.extensions[kExtension] =
        tinygltf::Value({{"light", tinygltf::Value(static_cast<int>(model.lights.size()))}});
    std::visit([&](const auto& source) { place(node, source); }, lights[i]);
    model.lights.push_back(*std::move(light));
    nodes.push_back(static_cast<int>(model.nodes.size()));
    model.nodes.push_back(std::move(node));
  }
  return nodes;
}

}  // namespace sweepkit::scene
