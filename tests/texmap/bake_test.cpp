// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/bake.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sweepkit/error.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"

namespace sweepkit::texmap {
namespace {

// Two unit squares in space that share the whole of (u,v): the second one stands at x = 10.
struct TwoSquares {
  std::vector<glm::vec3> positions = {{0, 0, 0},  {1, 0, 0},  {0, 1, 0},  {1, 1, 0},
                                      {10, 0, 0}, {11, 0, 0}, {10, 1, 0}, {11, 1, 0}};
  std::vector<glm::vec2> texcoords = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 0}, {0, 1}, {1, 1}};
  std::vector<std::array<std::uint32_t, 3>> triangles = {{2, 0, 1}, {1, 3, 2}, {6, 4, 5}, {5, 7, 6}};
  std::vector<std::uint32_t> area_ends = {2, 4};

  BakeSurface surface() const { return {positions, texcoords, triangles, area_ends, {}}; }
};

TEST(Bake, APeriodicProceduralIsItsUnitSquare) {
  const TwoSquares squares;
  const Procedural checker{.kind = ProceduralKind::kChecker, .colors = {glm::vec3(0), glm::vec3(1)}};
  const BakedTexture baked = bake(checker, squares.surface(), {64, 32});
  EXPECT_EQ(baked.transforms.size(), 2u);
  EXPECT_EQ(baked.transforms[1].scale, glm::dvec2(1.0));
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      const glm::dvec2 uv((x + 0.5) / 64, 1 - (y + 0.5) / 32);
      EXPECT_EQ(baked.image.color(x, y).r, evaluate(checker, uv, {}).r);
    }
  }
}

TEST(Bake, AreasThatShareTexcoordsGetPlacesOfTheirOwn) {
  const TwoSquares squares;
  const Procedural marble{.kind = ProceduralKind::kMarble, .on = ProceduralOn::kPosition, .scale = 0.3};
  const BakedTexture baked = bake(marble, squares.surface(), {256, 256});
  const Texture image = ImageTexture{std::make_shared<const Image>(baked.image), Wrap::kClamp};
  double largest = 0;
  for (std::size_t area = 0; area < 2; ++area) {
    for (const glm::dvec2 uv :
         {glm::dvec2(0.01, 0.01), glm::dvec2(0.5, 0.5), glm::dvec2(0.99, 0.3), glm::dvec2(0.2, 0.99)}) {
      const glm::dvec3 position(uv.x + 10 * static_cast<double>(area), uv.y, 0);
      const UvTransform& t = baked.transforms[area];
      const glm::vec3 got = point_sample(image, t.offset + t.scale * uv, {});
      largest = std::max(largest, static_cast<double>(std::abs(got.r - evaluate(marble, uv, position).r)));
    }
  }
  // A texel covers 1/120 of a square; the pattern's steepest place changes by 0.1 over that.
  EXPECT_LT(largest, 0.1);
}

TEST(Bake, FillsEveryTexelAroundAnArea) {
  const TwoSquares squares;
  const Procedural marble{.kind = ProceduralKind::kMarble,
                          .on = ProceduralOn::kPosition,
                          .colors = {glm::vec3(0.5f), glm::vec3(0.6f)}};
  const BakedTexture baked = bake(marble, squares.surface(), {64, 64});
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) EXPECT_GT(baked.image.color(x, y).r, 0.4f) << x << " " << y;
  }
}

TEST(Bake, ResamplesAnImageByTheMeanOfWhatATexelCovers) {
  const TwoSquares squares;
  const Image fine{4, 2, 1, std::vector<std::uint16_t>{0, 65535, 0, 0, 65535, 0, 0, 0}};
  const BakedTexture baked =
      bake(ImageTexture{std::make_shared<const Image>(fine), Wrap::kRepeat}, squares.surface(), {2, 1});
  EXPECT_NEAR(baked.image.color(0, 0).r, 0.5, 1e-4);
  EXPECT_NEAR(baked.image.color(1, 0).r, 0, 1e-4);
}

TEST(Bake, RefusesSizesOutOfRange) {
  const TwoSquares squares;
  EXPECT_THROW(bake(Procedural{}, squares.surface(), {0, 5}), InputError);
  EXPECT_THROW(bake(Procedural{}, squares.surface(), {5, 40000}), InputError);
}

}  // namespace
}  // namespace sweepkit::texmap
