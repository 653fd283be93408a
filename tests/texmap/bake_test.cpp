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

// An upright tube of radius 1 and height 1, 64 cells round, its seam at u = 0 and 1.
struct Tube {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> texcoords;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> area_ends;
  std::vector<glm::dvec2> periods = {{1, 0}};

  Tube() {
    for (std::uint32_t i = 0; i <= 64; ++i) {
      const double turn = 2 * 3.14159265358979323846 * (i % 64) / 64;
      for (std::uint32_t j = 0; j < 2; ++j) {
        positions.emplace_back(std::cos(turn), j, -std::sin(turn));
        texcoords.emplace_back(i / 64.0, j);
        if (i == 64) continue;
        const std::uint32_t p = 2 * i;
        triangles.push_back(j == 0 ? std::array{p + 1, p, p + 2} : std::array{p + 2, p + 3, p + 1});
      }
    }
    area_ends = {static_cast<std::uint32_t>(triangles.size())};
  }
  BakeSurface surface() const { return {positions, texcoords, triangles, area_ends, {}, periods}; }
};

TEST(Bake, GoesOnPastTheSeamOfWhatComesRound) {
  const Tube tube;
  for (const ProceduralOn on : {ProceduralOn::kPosition, ProceduralOn::kUv}) {
    const Procedural marble{.kind = ProceduralKind::kMarble, .on = on, .scale = 0.7};
    const BakedTexture baked = bake(marble, tube.surface(), {256, 64});
    const UvTransform& t = baked.transforms[0];
    // The texel's place of (u,v), and the texels to either side of the seam's two places: a whole number of
    // texels apart or not, they are interpolated as a viewer does.
    const auto at = [&](double u, double v) {
      const glm::dvec2 uv = t.offset + t.scale * glm::dvec2(u, v);
      const double x = uv.x * 256 - 0.5;
      const auto column = static_cast<int>(std::floor(x));
      const auto row = static_cast<int>((1 - uv.y) * 64);
      const float share = static_cast<float>(x - column);
      return (1 - share) * baked.image.color(column, row) + share * baked.image.color(column + 1, row);
    };
    const double texel = 1 / (t.scale.x * 256);
    for (int i = 0; i < 10; ++i) {
      const double v = 0.05 + 0.1 * i;
      for (const double past : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
        // Interpolated from two texels of other places, a vein of slope 8 a unit bends by 1 % at most.
        EXPECT_NEAR(at(past * texel, v).r, at(1 + past * texel, v).r, 0.02) << past;
      }
    }
    // And the gutter is no copy of the edge.
    double differs = 0;
    for (int i = 0; i < 10; ++i) {
      const double v = 0.05 + 0.1 * i;
      differs += std::abs(at(-3 * texel, v).r - at(0.5 * texel, v).r);
    }
    EXPECT_GT(differs, 0.05);
  }
}

TEST(Bake, AGutterKeepsAreasApartOnTwoMoreLevels) {
  // Black and white squares: what a filter reads of the black one stays black as far as the gutter goes.
  const TwoSquares squares;
  const Procedural halves{.kind = ProceduralKind::kBands,
                          .on = ProceduralOn::kPosition,
                          .colors = {glm::vec3(0), glm::vec3(1)},
                          .scale = 1.0 / 4};
  std::vector<glm::vec3> positions = squares.positions;
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i].y = i < 4 ? 0.5f : 2.5f;
  BakeSurface surface = squares.surface();
  surface.positions = positions;
  const BakedTexture baked = bake(halves, surface, {512, 512});
  const auto index = [](int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  };
  std::vector<float> level(512 * 512);
  for (int y = 0; y < 512; ++y) {
    for (int x = 0; x < 512; ++x) level[index(x, y, 512)] = baked.image.color(x, y).r;
  }
  for (int side = 256; side >= 128; side /= 2) {
    std::vector<float> coarser(index(0, side, side));
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        float sum = 0;
        for (const int k : {0, 1, 2, 3}) sum += level[index(2 * x + k % 2, 2 * y + k / 2, 2 * side)];
        coarser[index(x, y, side)] = sum / 4;
      }
    }
    level = coarser;
    for (std::size_t area = 0; area < 2; ++area) {
      const UvTransform& t = baked.transforms[area];
      for (const glm::dvec2 corner :
           {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(1, 1)}) {
        const glm::dvec2 uv = t.offset + t.scale * corner;
        const glm::dvec2 p = glm::dvec2(uv.x, 1 - uv.y) * static_cast<double>(side) - 0.5;
        for (int k = 0; k < 4; ++k) {
          const int x = std::clamp(static_cast<int>(std::floor(p.x)) + k % 2, 0, side - 1);
          const int y = std::clamp(static_cast<int>(std::floor(p.y)) + k / 2, 0, side - 1);
          EXPECT_EQ(level[index(x, y, side)], static_cast<float>(area)) << side;
        }
      }
    }
  }
}

// Each texel against the mean of 16 x 16 points of it, beside the mean of 4 x 4.
TEST(Bake, TexelsAreTheirMeans) {
  constexpr int kSide = 19;
  const auto mean_of_points = [](const Procedural& procedural, int x, int y, int points) {
    glm::dvec3 sum(0.0);
    for (int i = 0; i < points * points; ++i) {
      const int row = i / points;
      const glm::dvec2 p((x + (i % points + 0.5) / points) / kSide, 1 - (y + (row + 0.5) / points) / kSide);
      sum += glm::dvec3(evaluate(procedural, p, {}));
    }
    return sum / static_cast<double>(points * points);
  };
  for (std::size_t kind = 0; kind < kProceduralNames.size(); ++kind) {
    const double scale = kind < 4 ? 4 : 1;
    const Procedural procedural{.kind = static_cast<ProceduralKind>(kind), .scale = scale};
    const Image image = bake(procedural, {}, {kSide, kSide}).image;
    double baked = 0;
    double points = 0;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const glm::dvec3 mean = mean_of_points(procedural, x, y, 16);
        const glm::dvec3 off = glm::dvec3(image.color(x, y)) - mean;
        const glm::dvec3 off_points = mean_of_points(procedural, x, y, 4) - mean;
        baked += glm::dot(off, off);
        points += glm::dot(off_points, off_points);
      }
    }
    const double count = 3.0 * kSide * kSide;
    RecordProperty(std::string(kProceduralNames[kind]), std::to_string(std::sqrt(baked / count)) + " " +
                                                            std::to_string(std::sqrt(points / count)));
    EXPECT_LT(baked, points) << kProceduralNames[kind];
  }
}

// Three bands of rows, of which the last is short; patterns of each way to a mean; an image.
TEST(Bake, IsTheSameForAnyNumberOfThreads) {
  const Tube tube;
  const TwoSquares squares;
  const Image fine{4, 2, 1, std::vector<std::uint16_t>{0, 65535, 0, 0, 65535, 0, 0, 0}};
  const std::vector<Texture> textures = {
      Procedural{.kind = ProceduralKind::kBrick, .scale = 2},
      Procedural{.kind = ProceduralKind::kGranite, .on = ProceduralOn::kUv},
      Procedural{.kind = ProceduralKind::kGranite, .on = ProceduralOn::kPosition, .scale = 0.1},
      Procedural{.kind = ProceduralKind::kChecker, .on = ProceduralOn::kPosition},
      ImageTexture{std::make_shared<const Image>(fine), Wrap::kRepeat}};
  for (const Texture& texture : textures) {
    for (const BakeSurface& surface : {tube.surface(), squares.surface()}) {
      const auto texels = [&](int threads) { return bake(texture, surface, {50, 37, threads}).image.texels; };
      const auto alone = texels(1);
      EXPECT_EQ(texels(2), alone);
      EXPECT_EQ(texels(7), alone) << "more than there are bands";
      EXPECT_EQ(texels(0), alone);
    }
  }
}

TEST(Bake, RefusesSizesOutOfRange) {
  const TwoSquares squares;
  EXPECT_THROW(bake(Procedural{}, squares.surface(), {0, 5}), InputError);
  EXPECT_THROW(bake(Procedural{}, squares.surface(), {5, 40000}), InputError);
}

}  // namespace
}  // namespace sweepkit::texmap
