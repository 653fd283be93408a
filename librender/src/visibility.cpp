// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "visibility.hpp"

#include <cmath>
#include <variant>

#include "light_samples.hpp"
#include "position_hash.hpp"
#include "shadow.hpp"

namespace sweepkit::render {
namespace {

// The disc that a sphere shows to `from`: its rim is where the tangents touch.
struct Disc {
  glm::dvec3 middle;
  glm::dvec3 across;  // two radii at right angles
  glm::dvec3 up;
};

Disc disc_of(const scene::PointLight& light, const ToLight& to) {
  const double sine = light.radius / to.distance;  // of half the angle that it fills
  const double radius = light.radius * std::sqrt(1 - sine * sine);
  const glm::dvec3& w = to.direction;
  const glm::dvec3 axis = std::abs(w.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 across = glm::normalize(glm::cross(axis, w));
  return {light.position - light.radius * sine * w, radius * across, radius * glm::cross(w, across)};
}

}  // namespace

ToLight towards(const scene::Light& light, const glm::dvec3& from) {
  if (const auto* point = std::get_if<scene::PointLight>(&light)) {
    const glm::dvec3 to = point->position - from;
    const double distance = glm::length(to);
    return {distance > 0 ? to / distance : glm::dvec3(0.0), distance};
  }
  return {-glm::normalize(std::get<scene::DirectionalLight>(light).direction), kNoEnd};
}

void Visibility::clear() {
  points.clear();
  shares.clear();
}

std::size_t Visibility::bytes() const {
  return points.capacity() * sizeof(points[0]) + shares.capacity() * sizeof(shares[0]);
}

std::uint64_t add_visibility(Visibility& visibility, const scene::Scene& scene, const Tracer& tracer,
                             const Hit& hit, const SurfacePoint& point, const glm::dvec3& normal,
                             std::uint64_t seed) {
  const glm::dvec3 start = smooth_start(tracer, hit, point);
  visibility.points.push_back({start, point.shading_normal});
  std::uint64_t rays = 0;
  const auto passing = [&](const glm::dvec3& direction, double distance) {
    ++rays;
    return light_passing(scene, tracer, leave_surface(hit, point, start, direction), distance);
  };
  for (const scene::Light& light : scene.lights) {
    seed = scatter(seed);
    const ToLight to = towards(light, start);
    const bool is_turned_away = !(glm::dot(normal, to.direction) > 0);
    if (is_turned_away || !(glm::dot(point.shading_normal, to.direction) > 0)) {
      visibility.shares.insert(visibility.shares.end(), visibility.channels,
                               is_turned_away ? kTurnedAway : 0.0f);
      continue;
    }
    glm::dvec3 share(0.0);
    const auto* sphere = std::get_if<scene::PointLight>(&light);
    // A sphere shows no disc to a point inside it: there it is a point light.
    if (sphere != nullptr && sphere->radius > 0 && to.distance > sphere->radius) {
      const Disc disc = disc_of(*sphere, to);
      for (const glm::dvec2& at : disc_samples(seed)) {
        const glm::dvec3 way = disc.middle + at.x * disc.across + at.y * disc.up - start;
        const double distance = glm::length(way);
        share += passing(way / distance, distance);
      }
      share /= static_cast<double>(kLightSamples);
    } else {
      share = passing(to.direction, to.distance);
    }
    for (glm::length_t c = 0; c < static_cast<glm::length_t>(visibility.channels); ++c)
      visibility.shares.push_back(static_cast<float>(share[c]));
  }
  return rays;
}

}  // namespace sweepkit::render
