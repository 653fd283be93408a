// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "ray_differential.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "draw.hpp"
#include "eye_rays.hpp"
#include "scattering.hpp"
#include "surface_point.hpp"
#include "sweepkit/texmap/image_error.hpp"

namespace sweepkit::render {
namespace {

using test::Stage;

constexpr int kSide = 200;  // pixels
const char* const kCamera =
    R"("camera": {"eye": [0.3, 1.5, 6], "target": [0.2, 0.6, 0], "fov_deg": 45, "width": 200, "height": 200})";

std::string scene_of(const std::string& objects) {
  return R"({"sweepkit": 1, )" + std::string(kCamera) + R"(, "objects": [)" + objects + "]}";
}
const char* const kFloor = R"({"name": "floor", "plane": {"size": [400, 400]}, "uv": {"repeat": [10, 10]}})";

// Where the unnormalised eye ray d = corner + x across + y down meets the plane y = 0, and by how much that
// moves with x and y: P = E - E.y d / d.y.
HitDifferential floor_closed_form(const scene::Camera& camera, double x, double y, bool is_mirrored) {
  const glm::dmat3 axes = scene::world_from_camera(camera);
  const double pixel = 2 * std::tan(0.5 * camera.fov_deg * std::numbers::pi / 180) / kSide;
  glm::dvec3 across = pixel * axes[0];
  glm::dvec3 down = -pixel * axes[1];
  glm::dvec3 d = -axes[2] + (x - 0.5 * kSide) * across + (y - 0.5 * kSide) * down;
  if (is_mirrored) across.z = -across.z, down.z = -down.z, d.z = -d.z;  // in the plane z = const
  const auto moved = [&](const glm::dvec3& step) {
    return -camera.eye.y * (step / d.y - d * (step.y / (d.y * d.y)));
  };
  return {moved(across), moved(down)};
}

void expect_near(const glm::dvec3& value, const glm::dvec3& expected, double share) {
  EXPECT_LE(glm::length(value - expected), share * glm::length(expected));
}

// Follows the ray of a pixel to the floor, by one mirror if it meets that first.
struct Way {
  Hit first, last;
  HitDifferential at;
  glm::dvec3 place;
};
std::optional<Way> follow(const Tracer& tracer, const EyeRays& rays, int x, int y) {
  Ray ray = rays.through(x, y);
  Way way;
  way.first = way.last = tracer.nearest(ray);
  if (!way.first.is_hit()) return std::nullopt;
  RayDifferential differential = rays.differential(x, y);
  way.at = at_hit(tracer, way.first, ray.direction, differential);
  if (way.first.object != 0) {
    const SurfacePoint point = surface_point(tracer, way.first, ray.direction);
    differential = reflected(tracer, way.first, ray.direction, differential, way.at);
    ray = leave_surface(way.first, point, point.position,
                        mirrored(ray.direction, bent_normal(point, ray.direction)));
    way.last = tracer.nearest(ray);
    if (!way.last.is_hit() || way.last.object != 0) return std::nullopt;
    way.at = at_hit(tracer, way.last, ray.direction, differential);
  }
  way.place = surface_point(tracer, way.last, ray.direction).position;
  return way;
}

TEST(RayDifferential, EqualsTheClosedFormOnAPlane) {
  const Stage stage(scene_of(kFloor));
  const Tracer tracer(stage.model.scene, false, Accelerator::kSeads);
  const EyeRays rays(stage.model.scene.camera, kSide, kSide);
  int count = 0;
  for (int y = 0; y < kSide; y += 7) {
    for (int x = 0; x < kSide; x += 7) {
      const std::optional<Way> way = follow(tracer, rays, x, y);
      if (!way) continue;
      ++count;
      const HitDifferential expected = floor_closed_form(stage.model.scene.camera, x + 0.5, y + 0.5, false);
      // Rounding is magnified by 1 / (D.N)^2, 1e4 at half a degree above the horizon.
      expect_near(way->at.x, expected.x, 1e-10);
      expect_near(way->at.y, expected.y, 1e-10);
      // (u,v) of the plane: u along x, v along -z, ten repeats over 400 metres.
      const texmap::Footprint f = footprint_of(tracer, way->last, way->at, {0, 0});
      EXPECT_NEAR(f.dx.x, expected.x.x / 40, 1e-9 * glm::length(expected.x));
      EXPECT_NEAR(f.dy.y, -expected.y.z / 40, 1e-9 * glm::length(expected.y));
    }
  }
  EXPECT_GT(count, 300);
}

TEST(RayDifferential, EqualsTheClosedFormInAPlaneMirror) {
  // The mirror stands upright in the plane z = -3; the floor in it is seen by the eye behind it.
  const Stage stage(scene_of(
      std::string(kFloor) +
      R"(, {"name": "mirror", "translate": [0, 5.01, -3], "rotate_deg": [90, 0, 0], "plane": {"size": [60, 10]}})"));
  const Tracer tracer(stage.model.scene, true, Accelerator::kSeads);
  const EyeRays rays(stage.model.scene.camera, kSide, kSide);
  int count = 0;
  for (int y = 0; y < kSide; y += 3) {
    for (int x = 0; x < kSide; x += 7) {
      const std::optional<Way> way = follow(tracer, rays, x, y);
      if (!way || way->first.object == 0) continue;
      ++count;
      const HitDifferential expected = floor_closed_form(stage.model.scene.camera, x + 0.5, y + 0.5, true);
      expect_near(way->at.x, expected.x, 1e-9);
      expect_near(way->at.y, expected.y, 1e-9);
    }
  }
  EXPECT_GT(count, 50);
}

TEST(RayDifferential, AgreesWithTracedNeighboursInAMirrorBall) {
  const Stage stage(scene_of(
      std::string(kFloor) +
      R"(, {"name": "ball", "translate": [0, 1, 0], "tessellation": {"contour": 48, "trajectory": 96},
        "revolve": {"contour": {"arc": {"radius": 1, "from_deg": -90, "to_deg": 90}}}})"));
  const Tracer tracer(stage.model.scene, true, Accelerator::kSeads);
  // Pixels a hundredth as wide, so that neighbours lie on one triangle and curvature does not tell.
  const int fine = 100 * kSide;
  const EyeRays rays(stage.model.scene.camera, fine, fine);
  int count = 0;
  int close = 0;
  for (int y = 30; y < fine; y += 97) {
    for (int x = 30; x < fine; x += 97) {
      const std::optional<Way> way = follow(tracer, rays, x, y);
      if (!way || way->first.object == 0) continue;
      const auto difference = [&](int dx, int dy) -> std::optional<glm::dvec3> {
        const std::optional<Way> before = follow(tracer, rays, x - dx, y - dy);
        const std::optional<Way> after = follow(tracer, rays, x + dx, y + dy);
        if (!before || !after || before->first.triangle != way->first.triangle ||
            after->first.triangle != way->first.triangle)
          return std::nullopt;
        return (after->place - before->place) / (2.0 * (dx + dy));
      };
      const auto expect_agreement = [&](const glm::dvec3& derivative, int dx, int dy) {
        const std::optional<glm::dvec3> near = difference(dx, dy);
        const std::optional<glm::dvec3> far = difference(2 * dx, 2 * dy);
        if (!near || !far) return;
        ++count;
        // A central difference is off by its step squared, so this one by a third of what twice the step
        // changes; the other two thirds are for the orders after. Places are good to 1e-12 metres.
        const double bound = glm::length(*far - *near) + 1e-6 * glm::length(*near);
        EXPECT_LE(glm::length(derivative - *near), bound) << x << ' ' << y;
        // At the ball's rim and at the horizon no step is small; elsewhere it is a close agreement.
        close += bound < 1e-3 * glm::length(*near) ? 1 : 0;
      };
      expect_agreement(way->at.x, 1, 0);
      expect_agreement(way->at.y, 0, 1);
    }
  }
  EXPECT_GT(count, 500);
  EXPECT_GT(close, 0.8 * count);
}

TEST(RayDifferential, DrawsTheSamePictureForAnyNumberOfThreads) {
  Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 1.5, 6], "target": [0, 0.6, 0], "width": 96, "height": 96},
    "ambient": [1, 1, 1], "depth": 3, "textures": {"t": {"procedural": "checker"}},
    "materials": {"floor": {"texture": "t", "reflect": 0.3}, "ball": {"texture": "t", "reflect": 0.7}},
    "objects": [{"name": "floor", "material": "floor", "plane": {"size": [40, 40]}, "uv": {"repeat": [10, 10]}},
      {"name": "ball", "material": "ball", "translate": [0, 1, 0], "revolve": {"contour": {"arc": {"radius": 1, "from_deg": -90, "to_deg": 90}}}}]})");
  texmap::Image image{64, 64, 1, std::vector<std::uint16_t>(64 * 64)};
  auto& values = std::get<std::vector<std::uint16_t>>(image.texels);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = (i / 8 + i / 512) % 2 != 0 ? 60000 : 3000;
  stage.set_texture(0, image);
  const Picture reference = stage.draw({.filter = Filter::kPoint, .supersampling = 8});
  const double point = texmap::rmse(stage.draw({.filter = Filter::kPoint}).image, reference.image);
  for (const Footprint footprint : {Footprint::kDifferentials, Footprint::kAuto}) {
    const Picture one = stage.draw({.footprint = footprint, .threads = 1});
    EXPECT_EQ(test::texels(one), test::texels(stage.draw({.footprint = footprint, .threads = 3})));
    EXPECT_LT(texmap::rmse(one.image, reference.image), 0.7 * point);
  }
}

TEST(RayDifferential, FiltersWhatIsOnePixelWide) {
  // Upright strips a pixel wide with a gap of two between, each texel black or white and a fifth of a pixel
  // high: no pixel has a neighbour beside it on the same strip.
  std::string strips;
  for (int i = 0; i < 5; ++i) {
    strips +=
        std::string(i > 0 ? "," : "") + R"({"name": "s)" + std::to_string(i) +
        R"(", "material": "m", "rotate_deg": [90, 0, 0], "plane": {"size": [0.1, 10]}, "translate": [)" +
        std::to_string(0.3 * (i - 2) + 0.05) + ", 0, 0]}";
  }
  // 20 pixels over 2 metres at a distance of 10.
  Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 0, 10], "target": [0, 0, 0], "fov_deg": 11.42119, "width": 20, "height": 20},
    "ambient": [1, 1, 1], "textures": {"t": {"procedural": "checker"}}, "materials": {"m": {"diffuse": [1, 1, 1], "texture": "t"}},
    "objects": [)" +
      strips + "]}");
  texmap::Image image{1, 512, 1, std::vector<std::uint16_t>(512)};
  auto& values = std::get<std::vector<std::uint16_t>>(image.texels);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = i % 2 != 0 ? 65535 : 0;
  stage.set_texture(0, image);
  const Picture picture = stage.draw();
  EXPECT_GT(picture.statistics.differential_nodes, 50u);
  int count = 0;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) {
      const float value = picture.image.color(x, y).r;
      if (value == 0) continue;  // the background
      ++count;
      EXPECT_NEAR(value, 0.5, 0.02) << x << ' ' << y;
    }
  }
  EXPECT_GE(count, 60);
}

}  // namespace
}  // namespace sweepkit::render
