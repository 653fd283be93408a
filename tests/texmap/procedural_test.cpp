// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/procedural.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace sweepkit::texmap {
namespace {

constexpr std::array kKinds = {ProceduralKind::kChecker, ProceduralKind::kTiles,  ProceduralKind::kBands,
                               ProceduralKind::kBrick,   ProceduralKind::kMarble, ProceduralKind::kWood,
                               ProceduralKind::kGranite, ProceduralKind::kClouds, ProceduralKind::kNoise};

TEST(Procedural, RepeatsInTheUnitSquareWhereItSaysSo) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> real(0, 1);
  int repeating = 0;
  for (const ProceduralKind kind : kKinds) {
    for (const double scale : {1.0, 2.0, 3.0, 8.0, 2.5}) {
      for (const std::size_t count : {0u, 2u, 3u, 5u}) {
        Procedural p{.kind = kind, .scale = scale};
        for (std::size_t i = 0; i < count; ++i) p.colors.push_back(glm::vec3(static_cast<float>(i) / 5));
        if (!repeats_in_unit_square(p)) continue;
        ++repeating;
        for (int n = 0; n < 100; ++n) {
          // Dyadic steps keep u + 1 exact.
          const glm::dvec2 uv =
              glm::floor(glm::dvec2(real(random), real(random)) * 4096.0) / 4096.0 + glm::dvec2(1.0 / 16384);
          EXPECT_EQ(evaluate(p, uv, {}), evaluate(p, uv + glm::dvec2(1, 0), {}));
          EXPECT_EQ(evaluate(p, uv, {}), evaluate(p, uv + glm::dvec2(0, 1), {}));
        }
      }
    }
  }
  EXPECT_GT(repeating, 100);
}

TEST(Procedural, CheckerAlternatesInCellsOfAHalf) {
  const Procedural checker{.kind = ProceduralKind::kChecker, .colors = {glm::vec3(0), glm::vec3(1)}};
  EXPECT_EQ(evaluate(checker, {0.25, 0.25}, {}).r, 0);
  EXPECT_EQ(evaluate(checker, {0.75, 0.25}, {}).r, 1);
  EXPECT_EQ(evaluate(checker, {0.75, 0.75}, {}).r, 0);
  EXPECT_EQ(evaluate(checker, {-0.25, 0.25}, {}).r, 1);
}

TEST(Procedural, BandsAreAsWideAsAsked) {
  const Procedural bands{
      .kind = ProceduralKind::kBands, .colors = {glm::vec3(0), glm::vec3(1)}, .widths = {3, 1}};
  EXPECT_EQ(evaluate(bands, {0.9, 0.74}, {}).r, 0);
  EXPECT_EQ(evaluate(bands, {0.1, 0.76}, {}).r, 1);
  EXPECT_EQ(evaluate(bands, {0.1, 1.74}, {}).r, 0);
}

TEST(Procedural, BricksStandInBondWithMortarBetween) {
  const glm::vec3 clay(0.5f);
  const glm::vec3 lime(1.0f);
  const Procedural brick{
      .kind = ProceduralKind::kBrick, .colors = {clay, lime}, .mortar = 0.2, .ratio = 2, .bond = 0.5};
  const auto at = [&](double x, double y) { return evaluate(brick, {x, y}, {}); };
  EXPECT_EQ(at(0.5, 0.25), clay);   // the middle of a brick
  EXPECT_EQ(at(0.5, 0.01), lime);   // the bed joint: 0.1 of half a unit to either side
  EXPECT_EQ(at(0.02, 0.25), lime);  // a head joint, half of 0.2 / 2
  EXPECT_EQ(at(0.07, 0.25), clay);
  EXPECT_EQ(at(0.02, 0.75), clay);  // half a brick on in the next course
  EXPECT_EQ(at(0.52, 0.75), lime);
}

TEST(Procedural, BrickOnPositionGoesRoundCorners) {
  const Procedural brick{.kind = ProceduralKind::kBrick, .on = ProceduralOn::kPosition};
  for (const double along : {0.0, 0.2, 0.4, 0.9}) {
    // From a corner at (1, 1) so far along the front, and along the side.
    const double y = 0.21;
    EXPECT_EQ(evaluate(brick, {}, {1 - along, y, 1}), evaluate(brick, {}, {1, y, 1 + along}));
  }
}

TEST(Procedural, EveryColourHasAsManyTilesAsAnother) {
  const std::size_t side = 6;
  Procedural tiles{.kind = ProceduralKind::kTiles, .scale = side, .grout = 0};
  for (int i = 0; i < 5; ++i) tiles.colors.push_back(glm::vec3(static_cast<float>(i) / 4));
  std::array<int, 5> counts{};
  for (std::size_t i = 0; i < side * side; ++i) {
    const std::size_t row = i / side;
    const glm::dvec2 uv((0.5 + static_cast<double>(i % side)) / side,
                        (0.5 + static_cast<double>(row)) / side);
    ++counts[static_cast<std::size_t>(std::lround(4 * evaluate(tiles, uv, {}).r))];
  }
  for (int i = 0; i < 4; ++i) EXPECT_EQ(counts[static_cast<std::size_t>(i)], 9) << i;  // the last is grout's
}

TEST(Procedural, GraniteHasOnlyTheColoursItIsGivenAndBetween) {
  const Procedural granite{.kind = ProceduralKind::kGranite,
                           .colors = {glm::vec3(0.2f, 0.4f, 0.4f), glm::vec3(0.8f, 0.4f, 0.4f)}};
  int ground = 0;
  int specks = 0;
  for (int i = 0; i < 10000; ++i) {
    const glm::vec3 color = evaluate(granite, {0.37 * i, 0.61 * i}, {0.37 * i, 0.61 * i, 0.13 * i});
    EXPECT_NEAR(color.g, 0.4f, 1e-6f);
    ground += color.r < 0.21f ? 1 : 0;
    specks += color.r > 0.79f ? 1 : 0;
  }
  EXPECT_GT(ground, 5000);
  EXPECT_GT(specks, 1500);  // 30 % without the edges between
}

TEST(Procedural, CoverageIsTheShareOfTheSkyThatCloudsTake) {
  for (const double coverage : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    Procedural clouds{.kind = ProceduralKind::kClouds, .on = ProceduralOn::kPosition, .coverage = coverage};
    clouds.colors = {glm::vec3(0), glm::vec3(1)};
    double covered = 0;
    for (int i = 0; i < 20000; ++i)
      covered += evaluate(clouds, {}, {3.7 * i, 6.1 * i, 1.3 * i}).r > 0 ? 1 : 0;
    // 20,000 places of a share of a half tell it to 0.0035; the sum of noise is not quite normal: 0.01.
    EXPECT_NEAR(covered / 20000, coverage, 0.02);
  }
}

TEST(Procedural, OnUvAndOnPositionAreEveryKinds) {
  for (const ProceduralKind kind : kKinds) {
    const Procedural on_uv{.kind = kind, .on = ProceduralOn::kUv};
    const Procedural on_position{.kind = kind, .on = ProceduralOn::kPosition};
    int differs = 0;
    for (int i = 1; i < 50; ++i) {
      const glm::dvec3 p(0.137 * i, 0.291 * i, 0.417 * i);
      EXPECT_EQ(evaluate(on_uv, {p.x, p.y}, p), evaluate(on_uv, {p.x, p.y}, {}));
      EXPECT_EQ(evaluate(on_position, {p.x, p.y}, p), evaluate(on_position, {}, p));
      differs += evaluate(on_position, {}, p) != evaluate(on_position, {}, {}) ? 1 : 0;
    }
    EXPECT_GT(differs, 5) << kProceduralNames[static_cast<std::size_t>(kind)];
  }
}

TEST(Procedural, IsDefinedForEveryNumberAndFootprint) {
  const auto is_color = [](const glm::vec3& c) {
    return c.r >= 0 && c.r <= 1 && c.g >= 0 && c.g <= 1 && c.b >= 0 && c.b <= 1;
  };
  constexpr std::array<double, 8> kNumbers = {0, 1e300, -1e300, 1e-300, 1e9, HUGE_VAL, -HUGE_VAL, NAN};
  for (const ProceduralKind kind : kKinds) {
    for (const ProceduralOn on : {ProceduralOn::kUv, ProceduralOn::kPosition}) {
      for (const double scale : {1.0, 1e-9, 1e9, 2.5}) {
        const Procedural procedural{.kind = kind, .on = on, .scale = scale};
        for (const double x : kNumbers) {
          EXPECT_TRUE(is_color(evaluate(procedural, {x, x}, {x, x, x})));
          for (const double d : kNumbers) {
            EXPECT_TRUE(
                is_color(evaluate(procedural, {glm::dvec3(x), glm::dvec3(d, 0, 0), glm::dvec3(0.0)})));
            EXPECT_TRUE(is_color(evaluate(procedural, {glm::dvec3(x), glm::dvec3(d), glm::dvec3(0, d, 1)})));
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace sweepkit::texmap
