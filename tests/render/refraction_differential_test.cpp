// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Derivatives of rays through glass, and where a normal is bent, against differences of traced rays.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>

#include "draw.hpp"
#include "eye_rays.hpp"
#include "ray_differential.hpp"
#include "scattering.hpp"
#include "surface_point.hpp"

namespace sweepkit::render {
namespace {

using test::Stage;

struct Way {
  std::vector<std::uint32_t> triangles;
  HitDifferential at;
  glm::dvec3 place;
};

// Through the object 1, or by its mirror, to the floor, object 0.
std::optional<Way> follow(const Stage& stage, const Tracer& tracer, const EyeRays& rays, int x, int y,
                          bool mirrors) {
  const scene::Material& material = stage.model.scene.materials[0];
  Ray ray = rays.through(x, y);
  RayDifferential differential = rays.differential(x, y);
  Way way;
  for (int step = 0; step < 4; ++step) {
    const Hit hit = tracer.nearest(ray);
    if (!hit.is_hit()) return std::nullopt;
    way.at = at_hit(tracer, hit, ray.direction, differential);
    const SurfacePoint point = surface_point(tracer, hit, ray.direction);
    way.place = point.position;
    if (hit.object == 0) return step > 0 ? std::optional(way) : std::nullopt;
    way.triangles.push_back(hit.triangle);
    const glm::dvec3 normal = bent_normal(point, ray.direction);
    if (mirrors) {
      differential = reflected(tracer, hit, ray.direction, differential, way.at);
      ray = leave_surface(hit, point, point.position, glm::normalize(mirrored(ray.direction, normal)));
      continue;
    }
    if (!(shares_at(material, point, ray.direction, normal).refracted > 0)) return std::nullopt;
    differential = refracted(tracer, hit, ray.direction, differential, way.at, material);
    ray = pass_surface(hit, point,
                       refracted(point, ray.direction, normal, relative_index(material, point.is_inside)));
  }
  return std::nullopt;
}

struct Agreement {
  int count = 0;
  int close = 0;
};

// Pixels are so narrow that neighbours go through the same triangles.
Agreement compare(const Stage& stage, bool mirrors, int fine, int step) {
  const Tracer tracer(stage.model.scene, true, Accelerator::kSeads);
  const EyeRays rays(stage.model.scene.camera, fine, fine);
  Agreement agreement;
  for (int y = step / 3; y < fine; y += step) {
    for (int x = step / 3; x < fine; x += step) {
      const std::optional<Way> way = follow(stage, tracer, rays, x, y, mirrors);
      if (!way) continue;
      const auto difference = [&](int dx, int dy) -> std::optional<glm::dvec3> {
        const std::optional<Way> before = follow(stage, tracer, rays, x - dx, y - dy, mirrors);
        const std::optional<Way> after = follow(stage, tracer, rays, x + dx, y + dy, mirrors);
        if (!before || !after || before->triangles != way->triangles || after->triangles != way->triangles)
          return std::nullopt;
        return (after->place - before->place) / (2.0 * (dx + dy));
      };
      const auto expect_agreement = [&](const glm::dvec3& derivative, int dx, int dy) {
        const std::optional<glm::dvec3> near = difference(dx, dy);
        const std::optional<glm::dvec3> far = difference(2 * dx, 2 * dy);
        if (!near || !far) return;
        ++agreement.count;
        // A central difference is off by its step squared, so this one by a third of what twice the step
        // changes; the other two thirds are for the orders after. Places are good to 1e-12 metres.
        const double bound = glm::length(*far - *near) + 1e-6 * glm::length(*near);
        EXPECT_LE(glm::length(derivative - *near), bound) << x << ' ' << y;
        agreement.close += bound < 1e-3 * glm::length(*near) ? 1 : 0;
      };
      expect_agreement(way->at.x, 1, 0);
      expect_agreement(way->at.y, 0, 1);
    }
  }
  return agreement;
}

std::string scene_of(const std::string& cells) {
  return R"({"sweepkit": 1, "camera": {"eye": [0.3, 3, 5], "target": [0.2, 0.9, 0], "fov_deg": 30, "width": 200, "height": 200},
    "materials": {"glass": {"diffuse": [0, 0, 0], "transmit": 1, "ior": 1.5}},
    "objects": [{"name": "floor", "plane": {"size": [400, 400]}},
      {"name": "ball", "material": "glass", "translate": [0, 1.2, 0], "scale": [1, 0.8, 1.1], "tessellation": )" +
         cells + R"(, "revolve": {"contour": {"arc": {"radius": 1, "from_deg": -90, "to_deg": 90}}}}]})";
}

TEST(RefractionDifferential, AgreesWithTracedNeighboursThroughABall) {
  const Agreement agreement =
      compare(Stage(scene_of(R"({"contour": 48, "trajectory": 96})")), false, 20000, 193);
  EXPECT_GT(agreement.count, 500);
  EXPECT_GT(agreement.close, 0.8 * agreement.count);
}

TEST(RefractionDifferential, AgreesWithTracedNeighboursWhereNormalsAreBent) {
  // So coarse a ball has grazing rays that its normals would lead inside, nearly all round.
  const Stage coarse(scene_of(R"({"contour": 5, "trajectory": 7})"));
  for (const bool mirrors : {false, true}) {
    const Agreement agreement = compare(coarse, mirrors, 20000, 193);
    EXPECT_GT(agreement.count, 400);
    EXPECT_GT(agreement.close, 0.8 * agreement.count);
  }
}

}  // namespace
}  // namespace sweepkit::render
