// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "draw.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::render {
namespace {

using test::Stage;
using test::texels;

const char* const kStillLife = R"({"sweepkit": 1,
  "camera": {"eye": [1, 1.5, 4], "target": [0, 0.5, 0], "width": 97, "height": 75},
  "background": [0.2, 0.3, 0.4], "ambient": [0.1, 0.1, 0.1], "depth": 3,
  "lights": [{"point": [2, 4, 3], "intensity": [0.8, 0.8, 0.8]}, {"directional": [-1, -1, -1], "intensity": [0.2, 0.2, 0.3]}],
  "textures": {"checker": {"procedural": "checker", "scale": 8}},
  "materials": {"floor": {"texture": "checker", "reflect": 0.3}, "shiny": {"diffuse": [0.5, 0.2, 0.1], "specular": [0.5, 0.5, 0.5], "reflect": 0.4}},
  "objects": [
    {"name": "floor", "material": "floor", "plane": {"size": [10, 10]}},
    {"name": "torus", "material": "shiny", "translate": [0, 0.7, 0], "rotate_deg": [60, 0, 0], "tessellation": {"contour": 24, "trajectory": 48},
     "sweep": {"contour": {"circle": {"radius": 0.25}}, "trajectory": {"circle": {"radius": 0.6}}}}]})";

texmap::Image checker_image() {
  texmap::Image image{64, 64, 1, std::vector<std::uint16_t>(64 * 64)};
  auto& values = std::get<std::vector<std::uint16_t>>(image.texels);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = ((i / 8 + i / 512) % 2 == 0) ? 60000 : 4000;
  return image;
}

TEST(Picture, IsTheSameForAnyNumberOfThreads) {
  Stage stage(kStillLife);
  stage.set_texture(0, checker_image());
  for (const int n : {1, 3}) {
    const Picture one = stage.draw({.supersampling = n, .threads = 1});
    for (const int threads : {2, 7})
      EXPECT_EQ(texels(one), texels(stage.draw({.supersampling = n, .threads = threads})));
  }
  const Picture refined = stage.draw({.adaptive = Adaptive{}, .threads = 1});
  for (const int threads : {2, 7})
    EXPECT_EQ(texels(refined), texels(stage.draw({.adaptive = Adaptive{}, .threads = threads})));
}

TEST(Picture, IsTheSameForALinearScan) {
  Stage stage(kStillLife);
  stage.set_texture(0, checker_image());
  EXPECT_EQ(texels(stage.draw()), texels(stage.draw({.accelerator = Accelerator::kLinear})));
  const Region part{40, 30, 24, 16};
  EXPECT_EQ(texels(stage.draw({.adaptive = Adaptive{}, .crop = part})),
            texels(stage.draw({.adaptive = Adaptive{}, .crop = part, .accelerator = Accelerator::kLinear})));
}

TEST(Picture, IsTheSameAtScalesOfPowersOfTwo) {
  Stage stage(kStillLife);
  stage.set_texture(0, checker_image());
  const Picture one = stage.draw();
  for (const double scale : {0x1p-10, 0x1p10}) {
    Stage scaled(kStillLife);
    scaled.set_texture(0, checker_image());
    scene::Scene& scene = scaled.model.scene;
    scene.camera.eye *= scale;
    scene.camera.target *= scale;
    std::get<scene::PointLight>(scene.lights[0]).position *= scale;
    for (scene::Object& object : scene.objects) {
      glm::dmat4 by(scale);
      by[3][3] = 1;
      object.world_from_object = by * object.world_from_object;
    }
    EXPECT_EQ(texels(one), texels(scaled.draw()));
  }
}

TEST(Picture, ShowsTheBackgroundWhereNothingIs) {
  const Stage stage(kStillLife);
  EXPECT_EQ(stage.draw().image.color(0, 0), glm::vec3(0.2f, 0.3f, 0.4f));
}

TEST(Picture, LightsAPlaneByLambertsLaw) {
  // A light straight above the middle at height 1: at distance d on the plane the cosine is 1 / sqrt(1 +
  // d^2).
  const Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 3, 0], "target": [0, 0, 0], "up": [0, 0, -1], "fov_deg": 90, "width": 33, "height": 33},
    "lights": [{"point": [0, 1, 0], "intensity": [1, 1, 1]}], "materials": {"white": {"diffuse": [1, 1, 1]}},
    "objects": [{"name": "plane", "material": "white", "plane": {"size": [20, 20]}}]})");
  const Picture picture = stage.draw();
  for (int x = 0; x < 33; ++x) {
    const double d = 3 * ((x + 0.5) / 33 * 2 - 1);
    EXPECT_NEAR(picture.image.color(x, 16).r, 1 / std::sqrt(1 + d * d), 1e-6) << x;  // float32 of the result
  }
}

TEST(Picture, ThrowsAShadowWhereGeometrySaysSo) {
  // A plate 1 x 1 at height 1 under a light at height 2 shades 2 x 2 of the floor.
  const Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 0.9, 0], "target": [0, 0, 0], "up": [0, 0, -1], "fov_deg": 120, "width": 101, "height": 101},
    "lights": [{"point": [0, 2, 0]}],
    "objects": [{"name": "floor", "plane": {"size": [20, 20]}}, {"name": "plate", "translate": [0, 1, 0], "plane": {"size": [1, 1]}}]})");
  const Picture picture = stage.draw({.shadows = Shadows::kHard});
  const double half_width = 0.9 * std::tan(60 * 3.14159265358979 / 180);
  for (int x = 0; x < 101; ++x) {
    const double at = half_width * ((x + 0.5) / 101 * 2 - 1);
    if (std::abs(std::abs(at) - 1) < 1e-6) continue;
    EXPECT_EQ(picture.image.color(x, 50).r == 0, std::abs(at) < 1) << at;
  }
}

TEST(Picture, HasNoAcneAndNoTerminatorOfFacets) {
  // A coarse sphere lit from the side: every pixel is what Lambert's law gives for its interpolated normal,
  // so no facet shades itself or its neighbour.
  const Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 0, 8], "target": [0, 0, 0], "fov_deg": 16, "width": 128, "height": 128},
    "lights": [{"directional": [-1, 0, -0.2]}], "materials": {"white": {"diffuse": [1, 1, 1]}},
    "objects": [{"name": "ball", "material": "white", "tessellation": {"contour": 16, "trajectory": 32},
      "revolve": {"contour": {"free": [[0, -1], [0.70710678, -0.70710678], [1, 0], [0.70710678, 0.70710678], [0, 1]]}}}]})");
  const Picture lit = stage.draw();
  int dark = 0;
  int seen = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      const double px = (x + 0.5 - 64) / 64 * 8 * std::tan(8 * 3.14159265 / 180);
      const double py = (y + 0.5 - 64) / 64 * 8 * std::tan(8 * 3.14159265 / 180);
      const double r2 = px * px + py * py;
      if (r2 > 0.8) continue;
      const double cosine = (px + 0.2 * std::sqrt(1 - r2)) / std::sqrt(1.04);
      if (cosine < 0.15) continue;  // the terminator of a coarse sphere lies within a facet of the true one
      ++seen;
      dark += lit.image.color(x, y).r < 0.5 * cosine ? 1 : 0;
    }
  }
  EXPECT_GT(seen, 2000);
  EXPECT_EQ(dark, 0);
}

TEST(Picture, CanBeCancelledAndRefusesOptionsOutOfRange) {
  const Stage stage(kStillLife);
  const std::atomic<bool> cancelled = true;
  EXPECT_THROW(stage.draw({.is_cancelled = &cancelled}), Cancelled);
  EXPECT_THROW(stage.draw({.supersampling = 0}), InputError);
  EXPECT_THROW(stage.draw({.threads = -1}), InputError);
}

TEST(Picture, TellsItsProgressUpToOne) {
  const Stage stage(kStillLife);
  double last = 0;
  stage.draw({.on_progress = [&](double done) {
    EXPECT_GT(done, last);
    last = done;
  }});
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace sweepkit::render
