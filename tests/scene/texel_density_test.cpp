// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/texel_density.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene_text.hpp"
#include "sweepkit/scene/bake_over.hpp"
#include "sweepkit/scene/model.hpp"

namespace sweepkit::scene {
namespace {

Model build_object(const std::string& object, const std::string& texture) {
  const Document document =
      parse(scene_text(R"("textures": {"t": )" + texture + R"(}, "materials": {"m": {"texture": "t"}})",
                       R"({"name": "o", "material": "m", )" + object + "}"));
  return build(document, plan(document, {.product = Request::Product::kTexture}));
}

glm::ivec2 size_of(const std::string& object, const BakeSize& wanted, const std::string& texture) {
  const Model model = build_object(object, texture);
  const Object& first = model.scene.objects[0];
  return bake_size_of(model.scene.meshes[first.mesh], glm::dmat3(first.world_from_object),
                      model.scene.textures[0], wanted);
}

const std::string kChecker = R"({"procedural": "checker", "scale": 4})";
const std::string kMarble = R"({"procedural": "marble"})";
const std::string kNoise =
    R"({"procedural": "noise", "octaves": 1, "scale": 2, "colors": [[0, 0, 0], [1, 1, 1]]})";
const std::string kPlane = R"("plane": {"size": [2, 1]})";
const std::string kTube =
    R"("tessellation": {"contour": 24, "trajectory": 40}, "sweep": {"contour": {"circle": {"radius": 0.1}},
       "trajectory": {"line": [[0, 0, 0], [0, 3, 0]]}, "caps": "none"})";
// Round a polygon of 24 sides.
const double kRound = 24 * 2 * 0.1 * std::sin(std::numbers::pi / 24);

TEST(TexelDensity, OfAPlaneIsItsSidesTimesTheDensity) {
  for (const std::string& texture : {kChecker, kMarble}) {
    EXPECT_EQ(size_of(kPlane, {.density = 100}, texture), glm::ivec2(200, 100));
    EXPECT_EQ(size_of(kPlane + R"(, "scale": [1, 1, 3])", {.density = 100}, texture), glm::ivec2(200, 300));
    EXPECT_EQ(
        size_of(kPlane + R"(, "scale": [2, 1, 2], "rotate_deg": [20, 30, 40])", {.density = 10}, texture),
        glm::ivec2(40, 20));
  }
}

TEST(TexelDensity, OfATextureThatRepeatsIsThatOfOneRepeat) {
  const std::string twice = kPlane + R"(, "uv": {"repeat": [2, 4]})";
  EXPECT_EQ(size_of(twice, {.density = 100}, kChecker), glm::ivec2(100, 25));
  EXPECT_EQ(size_of(twice, {.density = 100}, kMarble), glm::ivec2(200, 100)) << "laid out over the whole";
}

TEST(TexelDensity, OfATubeIsTheWayRoundAndTheWayAlong) {
  const auto round = static_cast<int>(std::lround(1000 * kRound));
  EXPECT_EQ(size_of(kTube, {.density = 1000}, kChecker), glm::ivec2(round, 3000));
  // On position it has a gutter on all sides: a 64th of 648.
  EXPECT_EQ(size_of(kTube, {.density = 1000}, kMarble), glm::ivec2(round + 2 * 10, 3000 + 2 * 10));
}

// The tube and its two caps lie in a grid of 2 x 2 places, each as large as the tube's.
TEST(TexelDensity, OfSeveralPiecesIsThatOfTheLargestForEach) {
  std::string capped = kTube;
  capped.replace(capped.find("\"none\""), 6, "\"flat\"");
  const auto round = static_cast<int>(std::lround(100 * kRound));
  EXPECT_EQ(size_of(capped, {.density = 100}, kMarble), glm::ivec2(2 * (round + 2 * 4), 2 * (300 + 2 * 4)))
      << "gutters are 4 texels";
}

TEST(TexelDensity, IsCappedWithTheAspectKept) {
  EXPECT_EQ(size_of(kPlane, {.density = 1e9}, kChecker), glm::ivec2(8192, 4096));
  EXPECT_EQ(size_of(kPlane, {.density = 1000, .most = 64}, kChecker), glm::ivec2(64, 32));
  EXPECT_EQ(size_of(kPlane, {.density = 1e-6}, kChecker), glm::ivec2(1, 1));
}

TEST(TexelDensity, WithoutOneTheLongerSideHasTheSizeAndTheOtherFollowsTheObject) {
  EXPECT_EQ(size_of(R"("plane": {"size": [1, 1]})", {}, kChecker), glm::ivec2(1024, 1024));
  EXPECT_EQ(size_of(kPlane, {}, kChecker), glm::ivec2(1024, 512));
  EXPECT_EQ(size_of(kTube, {.size = 300}, kChecker), glm::ivec2(std::lround(100 * kRound), 300));
  EXPECT_EQ(size_of(R"("plane": {"size": [16, 1]})", {.size = 256}, kChecker), glm::ivec2(256, 16));
}

// A strip of 200 m x 0.72 m in 1024 x 64 texels would have them 18 times as long as wide.
TEST(TexelDensity, OfAStripTheShorterSideHasASixteenthAndTheLongerSquareTexels) {
  const std::string strip = R"("plane": {"size": [100, 1]})";
  EXPECT_EQ(size_of(R"("plane": {"size": [40, 1]})", {.size = 256}, kChecker), glm::ivec2(640, 16));
  EXPECT_EQ(size_of(strip, {}, kMarble), glm::ivec2(4096, 64)) << "four times as many at most";
  EXPECT_EQ(size_of(strip, {.most = 2000}, kMarble), glm::ivec2(2000, 64)) << "and no more than that";
  EXPECT_EQ(size_of(strip, {.size = 512, .most = 256}, kMarble), glm::ivec2(512, 32)) << "but what is asked";
  EXPECT_EQ(size_of(R"("plane": {"size": [1e9, 1]})", {.size = 8000}, kMarble), glm::ivec2(8192, 500));
}

// Of a cone of slant length s and base radius r the way round is 2 pi r (1 - x) at the share x of the slant,
// and its mean over the surface, which has 2 (1 - x) dx of itself there, is 2 pi r 2/3. A cone of n sides is
// a pyramid, smaller by (pi^2 / 6) / n^2 or so, less than 1/1000.
TEST(TexelDensity, OfAConeIsAMeanOverTheSurface) {
  const Model model = build_object(
      R"("tessellation": {"contour": 64, "trajectory": 64},
         "revolve": {"contour": {"line": [[0.3, 0], [0, 0.4]]}, "caps": "none"})",
      kChecker);
  const glm::dvec2 lengths = texcoord_lengths(model.scene.meshes[0], glm::dmat3(1.0));
  EXPECT_NEAR(lengths.x, 2 * std::numbers::pi * 0.3 * 2 / 3, 2e-3 * lengths.x);
  EXPECT_NEAR(lengths.y, 0.5, 1e-3);
}

glm::dvec3 bilinear(const texmap::Image& image, const glm::dvec2& uv) {
  const double x = uv.x * image.width - 0.5;
  const double y = (1 - uv.y) * image.height - 0.5;
  const int i = static_cast<int>(std::floor(x));
  const int j = static_cast<int>(std::floor(y));
  const auto texel = [&](int a, int b) {
    return glm::dvec3(image.color(std::clamp(a, 0, image.width - 1), std::clamp(b, 0, image.height - 1)));
  };
  return glm::mix(glm::mix(texel(i, j), texel(i + 1, j), x - i),
                  glm::mix(texel(i, j + 1), texel(i + 1, j + 1), x - i), y - j);
}

// Where the tube closes the two sides of the seam show the same places of the noise. Of 8 cells a metre, its
// second derivative is at most 60 x 8^2; a texel h of 1 mm is off by h^2 / 24 of it both ways, as a mean, and
// by h^2 / 8 in between. A texel aside it would be off by 2 x 8 h.
TEST(TexelDensity, ABakeOverWhatClosesShowsNoSeam) {
  const Model model = build_object(
      R"("tessellation": {"contour": 24, "trajectory": 4}, "sweep": {"contour": {"circle": {"radius": 0.1}},
         "trajectory": {"line": [[0, 0, 0], [0, 0.2, 0]]}, "caps": "none"})",
      kNoise);
  const MeshView& mesh = model.scene.meshes[0];
  const glm::ivec2 size = bake_size_of(mesh, glm::dmat3(1.0), model.scene.textures[0], {.density = 1000});
  const texmap::BakedTexture baked = bake_over(mesh, model.scene.textures[0], {size.x, size.y});
  const texmap::UvTransform& to = baked.transforms[0];
  const double bound = 2 * (1.0 / 8 + 2.0 / 24) * 1e-6 * 60 * 8 * 8;
  double across = 0;
  for (double v = 0.01; v < 1; v += 0.01) {
    const double left = bilinear(baked.image, to.offset + to.scale * glm::dvec2(0, v)).r;
    EXPECT_NEAR(left, bilinear(baked.image, to.offset + to.scale * glm::dvec2(1, v)).r, bound);
    across =
        std::max(across, std::abs(left - bilinear(baked.image, to.offset + to.scale * glm::dvec2(0.5, v)).r));
  }
  EXPECT_GT(across, 0.1) << "the other side of the tube is another place";
}

// Round the edge of a texture that repeats the colour changes as it does inside it.
TEST(TexelDensity, ABakeThatRepeatsGoesOnRoundItsEdge) {
  const Model model = build_object(
      kTube,
      R"({"procedural": "noise", "on": "uv", "scale": 4, "octaves": 1, "colors": [[0, 0, 0], [1, 1, 1]]})");
  const MeshView& mesh = model.scene.meshes[0];
  const glm::ivec2 size = bake_size_of(mesh, glm::dmat3(1.0), model.scene.textures[0], {.density = 400});
  const texmap::Image image = bake_over(mesh, model.scene.textures[0], {size.x, size.y}).image;
  double inside = 0;
  double round = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 1; x < image.width; ++x)
      inside = std::max(inside, static_cast<double>(std::abs(image.color(x, y).r - image.color(x - 1, y).r)));
    round = std::max(round,
                     static_cast<double>(std::abs(image.color(0, y).r - image.color(image.width - 1, y).r)));
  }
  EXPECT_LE(round, inside);
}

}  // namespace
}  // namespace sweepkit::scene
