// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "environment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "draw.hpp"
#include "eye_rays.hpp"

namespace sweepkit::render {
namespace {

using test::Stage;

constexpr Filter kFilters[] = {Filter::kPoint,     Filter::kBilinear,  Filter::kTrilinear, Filter::kIntegral1,
                               Filter::kIntegral2, Filter::kIntegral3, Filter::kEwa,       Filter::kAuto};

// An image whose texels are a function of the direction of their middles, said again here: the middle is -Z,
// +X to the right of it, +Y on top.
texmap::Image image_of(int width, int height, const std::function<glm::dvec3(const glm::dvec3&)>& color) {
  texmap::Image image{width, height, 3, std::vector<float>()};
  auto& texels = std::get<std::vector<float>>(image.texels);
  for (int y = 0; y < height; ++y) {
    const double latitude = std::numbers::pi * (0.5 - (y + 0.5) / height);
    for (int x = 0; x < width; ++x) {
      const double longitude = 2 * std::numbers::pi * ((x + 0.5) / width - 0.5);
      const glm::dvec3 c = color({std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                  -std::cos(latitude) * std::cos(longitude)});
      for (glm::length_t k = 0; k < 3; ++k) texels.push_back(static_cast<float>(c[k]));
    }
  }
  return image;
}

// A scene of almost nothing, or of `objects`, under a picture.
struct Sky {
  Sky(texmap::Image image, const std::string& camera,
      const std::string& objects =
          R"({"name": "speck", "translate": [0, -1e6, 0], "plane": {"size": [1e-6, 1e-6]}})")
      : stage(R"({"sweepkit": 1, "camera": {)" + camera +
              R"(, "fov_deg": 60, "width": 48, "height": 48}, "ambient": [0, 0, 0],
          "materials": {"mirror": {"diffuse": [0, 0, 0], "reflect": 1}, "clear": {"diffuse": [0, 0, 0], "transmit": 1}},
          "objects": [)" +
              objects + "]}") {
    stage.document.environment = scene::TextureEntry{"background", scene::ImageEntry{}, {}};
    stage.model.scene.environment =
        texmap::ImageTexture{std::make_shared<const texmap::Image>(std::move(image)), texmap::Wrap::kRepeat};
  }
  Stage stage;
};

glm::dvec3 gradient(const glm::dvec3& direction) {
  return 0.5 + 0.5 * direction;
}

const char* const kCameras[] = {
    R"("eye": [0, 0, 0], "target": [0, 0, -1])", R"("eye": [0, 0, 0], "target": [0, 0, 1])",
    R"("eye": [0, 0, 0], "target": [1, 0, 0])",  R"("eye": [0, 0, 0], "target": [-1, 0.2, 0])",
    R"("eye": [0, 0, 0], "target": [0, 1, 0])",  R"("eye": [0, 0, 0], "target": [0, -1, 0])"};

TEST(Environment, AConstantPictureIsAConstantBackground) {
  const texmap::Image image = image_of(16, 8, [](const glm::dvec3&) { return glm::dvec3(0.25, 0.5, 4); });
  for (const char* camera : kCameras) {
    const Sky sky(image, camera);
    for (const Filter filter : kFilters) {
      const Picture picture = sky.stage.draw({.filter = filter});
      for (int i = 0; i < 48 * 48; ++i) {
        const glm::vec3 color = picture.image.color(i % 48, i / 48);
        EXPECT_NEAR(color.r, 0.25, 1e-6);
        EXPECT_NEAR(color.g, 0.5, 1e-6);
        EXPECT_NEAR(color.b, 4, 4e-6);
      }
    }
  }
}

TEST(Environment, AGradientHasTheColourOfTheDirectionEverywhere) {
  // Over the seam at the back and over both poles as elsewhere. Half a direction bends by 1/2 a radian
  // squared: linear between texels 0.0245 apart it is off by 0.0245^2 / 16 = 4e-5 at most; under a tent of
  // two texels or pixels (1.3 degrees) by its variance, 0.0245^2 / 6 / 4 = 3e-5; a nearest texel by half of
  // one each way, 0.0087.
  const texmap::Image image = image_of(256, 128, gradient);
  for (const char* camera : kCameras) {
    const Sky sky(image, camera);
    const EyeRays rays(sky.stage.model.scene.camera, 48, 48);
    for (const Filter filter : kFilters) {
      const Picture picture = sky.stage.draw({.filter = filter});
      // Close to a pole the mean over up to sixteen texels of a row, two radians round, is less exact; and
      // trilinear, which knows no long footprints, takes it both ways: a tent of 16 texels, 0.4 radians, has
      // a variance of 0.027, of which half bends half a direction by 0.007 and two of the tent's levels by
      // twice that.
      const double bound = filter == Filter::kPoint ? 0.01 : filter == Filter::kTrilinear ? 0.014 : 1.5e-3;
      for (int i = 0; i < 48 * 48; ++i) {
        const glm::dvec3 expected = gradient(rays.through(i % 48, i / 48).direction);
        const glm::dvec3 color(picture.image.color(i % 48, i / 48));
        EXPECT_LT(glm::length(color - expected), bound)
            << camera << ' ' << texmap::filter_name(filter) << ' ' << i % 48 << ' ' << i / 48;
      }
    }
  }
}

TEST(Environment, IsSeenInAMirrorAndThroughASheet) {
  const texmap::Image image = image_of(256, 128, gradient);
  const Sky sky(
      image, R"("eye": [0, 2, 4], "target": [0, 0, 0])",
      R"({"name": "m", "material": "mirror", "translate": [-50, 0, 0], "plane": {"size": [100, 1000]}},
                   {"name": "c", "material": "clear", "translate": [50, 0, 0], "plane": {"size": [100, 1000]}})");
  const EyeRays rays(sky.stage.model.scene.camera, 48, 48);
  const Picture picture = sky.stage.draw();
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 48; ++x) {
      glm::dvec3 d = rays.through(x, y).direction;
      if (d.y > -0.1 || std::abs(d.x) < 1e-9) continue;
      if (d.x < 0) d.y = -d.y;
      EXPECT_LT(glm::length(glm::dvec3(picture.image.color(x, y)) - gradient(d)), 1.5e-3) << x << ' ' << y;
    }
  }
}

TEST(Environment, DoesNotAlias) {
  // A chessboard of single texels, 14 to a pixel: its mean. Straight, mirrored, and through a sheet.
  texmap::Image image{4096, 2048, 1, std::vector<std::uint16_t>()};
  auto& texels = std::get<std::vector<std::uint16_t>>(image.texels);
  for (int i = 0; i < 4096 * 2048; ++i) texels.push_back((i + i / 4096) % 2 != 0 ? 65535 : 0);
  const Sky sky(
      std::move(image), R"("eye": [0, 2, 4], "target": [0, 1, 0])",
      R"({"name": "m", "material": "mirror", "translate": [-50, 0, 0], "plane": {"size": [100, 1000]}},
                   {"name": "c", "material": "clear", "translate": [50, 0, 0], "plane": {"size": [100, 1000]}})");
  const Picture filtered = sky.stage.draw();
  for (int i = 0; i < 48 * 48; ++i) {
    EXPECT_NEAR(filtered.image.color(i % 48, i / 48).r, 0.5, 0.02) << i % 48 << ' ' << i / 48;
  }
  const Picture points = sky.stage.draw({.filter = Filter::kPoint});
  EXPECT_NEAR(std::abs(points.image.color(20, 10).r - 0.5f), 0.5, 1e-6);
}

TEST(Environment, CountsItsLookups) {
  const Sky sky(image_of(16, 8, gradient), R"("eye": [0, 0, 0], "target": [0, 0, -1])");
  // A lookup a pixel, and the tiles that were made for them.
  EXPECT_GT(sky.stage.draw().ledger[scene::Part::kEnvironment].calls, 48u * 48);
}

TEST(Environment, DrawsTheSamePictureForAnyThreads) {
  const Sky sky(
      image_of(64, 32, gradient), R"("eye": [0, 2, 4], "target": [0, 0, 0])",
      R"({"name": "m", "material": "mirror", "revolve": {"contour": {"arc": {"radius": 1, "from_deg": -90, "to_deg": 90}}}})");
  EXPECT_EQ(test::texels(sky.stage.draw({.threads = 1})), test::texels(sky.stage.draw({.threads = 3})));
}

}  // namespace
}  // namespace sweepkit::render
