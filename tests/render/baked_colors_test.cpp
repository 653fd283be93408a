// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A picture whose pixels lie on the texels of a bake: seen straight from above, a plane of 2 x 1 m fills it.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "draw.hpp"
#include "sweepkit/scene/bake_over.hpp"
#include "sweepkit/scene/texel_density.hpp"

namespace sweepkit::render {
namespace {

// The largest difference between a bake at 64 texels a metre and the tracer's colours at their middles, where
// those are within a range.
double difference(const std::string& texture, float low = 0, float high = 1) {
  const double fov = 2 * std::atan(0.5 / 10) * 180 / std::numbers::pi;
  char camera[200];
  std::snprintf(
      camera, sizeof camera,
      R"("camera": {"eye": [0, 10, 0], "target": [0, 0, 0], "up": [0, 0, -1], "fov_deg": %.17g, "width": 128, "height": 64})",
      fov);
  const test::Stage stage(R"({"sweepkit": 1, "ambient": [1, 1, 1], )" + std::string(camera) +
                          R"(, "textures": {"t": )" + texture +
                          R"(}, "materials": {"m": {"diffuse": [1, 1, 1], "texture": "t"}},
    "objects": [{"name": "o", "material": "m", "plane": {"size": [2, 1]}}]})");
  const scene::MeshView& mesh = stage.model.scene.meshes[0];
  const glm::ivec2 size =
      scene::bake_size_of(mesh, glm::dmat3(1.0), stage.model.scene.textures[0], {.density = 64});
  EXPECT_EQ(size, glm::ivec2(128, 64));
  const texmap::Image baked = scene::bake_over(mesh, stage.model.scene.textures[0], {size.x, size.y}).image;
  const Picture picture = stage.draw({.filter = Filter::kPoint});
  double most = 0;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const glm::vec3 drawn = picture.image.color(x, y);
      if (drawn.r < low || drawn.r > high) continue;
      const glm::vec3 gap = glm::abs(baked.color(x, y) - drawn);
      most = std::max(most, static_cast<double>(std::max({gap.r, gap.g, gap.b})));
    }
  }
  return most;
}

// Each texel lies in one square: what remains is half a step of 16 bits.
TEST(BakedColors, OfAPatternOfWholeTexelsAreTheTracers) {
  EXPECT_LE(
      difference(R"({"procedural": "checker", "scale": 4, "colors": [[0.1, 0.2, 0.3], [0.9, 0.7, 0.5]]})"),
      0.5 / 65535 + 1e-6);
}

// A texel is the mean over its 1/64 m, the tracer's colour that of its middle: apart by h^2 / 24 of the
// second derivatives along both sides. Noise of one octave has 4 cells a metre, and 60 a cell squared at
// most; half a texel aside it would be 0.1 off. Where the colours end they do not follow the noise, which is
// left out.
TEST(BakedColors, OfSmoothNoiseOnPositionAreTheTracersToTheTexelsMean) {
  const double most =
      difference(R"({"procedural": "noise", "octaves": 1, "colors": [[0, 0, 0], [1, 1, 1]]})", 0.2f, 0.8f);
  EXPECT_LE(most, 2 * 60.0 * 16 / (64 * 64 * 24));
  EXPECT_GT(most, 0);
}

}  // namespace
}  // namespace sweepkit::render
