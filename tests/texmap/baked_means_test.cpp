// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Baked texels against 64 x 64 points of each, or for steps as many closed forms of a 64th (points would be
// off by a whole part along an edge), on a plane that lies askew in space and along the axes of (u,v). A
// level is one of 255, of the linear numbers and of the sRGB ones that a file has, whichever is further off.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "pattern.hpp"
#include "sweepkit/texmap/bake.hpp"

namespace sweepkit::texmap {
namespace {

#ifndef SWEEPKIT_BAKED_SIDE
#define SWEEPKIT_BAKED_SIDE 4
#endif
constexpr int kSide = SWEEPKIT_BAKED_SIDE;
constexpr int kPoints = 64;

double srgb(double value) {
  return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
}

// A square whose texels have that side, in the procedural's space, and what is baked over it.
struct Square {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> texcoords;
  std::vector<std::array<std::uint32_t, 3>> triangles = {{2, 0, 1}, {1, 3, 2}};
  std::vector<std::uint32_t> area_ends = {2};
  glm::dvec3 corner, x, y;  // as rounded
  Image image;

  Square(const Procedural& procedural, double texel) {
    const float side = static_cast<float>(kSide * texel);
    const glm::vec3 at(0.31f, 0.17f, 0.05f);
    const glm::vec3 across = side * glm::normalize(glm::vec3(1, 0.3f, 0.2f));
    const glm::vec3 up = side * glm::normalize(glm::cross(glm::vec3(0.2f, -0.5f, 1), across));
    positions = {at, at + across, at + up, at + across + up};
    const glm::vec2 uv(0.31f, 0.17f);
    texcoords = {uv, uv + glm::vec2(side, 0), uv + glm::vec2(0, side), uv + side};
    const auto place = [&](std::size_t i) {
      return procedural.on == ProceduralOn::kUv ? glm::dvec3(texcoords[i], 0) : glm::dvec3(positions[i]);
    };
    corner = place(0);
    x = (place(1) - corner) / double{kSide};
    y = (place(2) - corner) / double{kSide};
    image = bake(procedural, {positions, texcoords, triangles, area_ends, {}}, {kSide, kSide}).image;
  }
};

glm::dvec3 reference(const Pattern& pattern, const glm::dvec3& corner, const glm::dvec3& x,
                     const glm::dvec3& y) {
  const bool has_steps = is_of_steps(pattern.given.kind);
  const glm::dvec3 half_x = has_steps ? x / (2.0 * kPoints) : glm::dvec3(0.0);
  const glm::dvec3 half_y = has_steps ? y / (2.0 * kPoints) : glm::dvec3(0.0);
  glm::dvec3 sum(0.0);
  for (int j = 0; j < kPoints; ++j) {
    for (int i = 0; i < kPoints; ++i) {
      const glm::dvec3 at = corner + (i + 0.5) / kPoints * x + (j + 0.5) / kPoints * y;
      sum += color_of(pattern, {at, half_x, half_y});
    }
  }
  return sum / double{kPoints * kPoints};
}

// The largest error in levels, texels of that many of the pattern's finest details.
double largest_error(const Procedural& procedural, double details) {
  const Pattern pattern = pattern_of(procedural);
  const Square square(procedural, details * finest_detail(pattern) / procedural.scale);
  double largest = 0;
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const glm::dvec3 corner = square.corner + double(i) * square.x + double(kSide - 1 - j) * square.y;
      const glm::dvec3 mean = reference(pattern, corner, square.x, square.y);
      const glm::dvec3 baked(square.image.color(i, j));
      for (glm::length_t k = 0; k < 3; ++k) {
        largest = std::max(
            {largest, 255 * std::abs(baked[k] - mean[k]), 255 * std::abs(srgb(baked[k]) - srgb(mean[k]))});
      }
    }
  }
  return largest;
}

// `bound` levels, for texels of these sides.
void expect_within(double bound, std::initializer_list<double> sides,
                   const std::function<bool(ProceduralKind)>& is_tested) {
  for (const double details : sides) {
    double worst = 0;
    for (std::size_t kind = 0; kind < kProceduralNames.size(); ++kind) {
      for (const ProceduralOn on : {ProceduralOn::kUv, ProceduralOn::kPosition}) {
        if (!is_tested(static_cast<ProceduralKind>(kind))) continue;
        // Not whole, so that (u,v) are laid out over the square as well.
        const double error =
            largest_error({.kind = static_cast<ProceduralKind>(kind), .on = on, .scale = 1.3}, details);
        EXPECT_LE(error, bound) << kProceduralNames[kind] << (on == ProceduralOn::kUv ? " on uv" : "")
                                << ", texels of " << details << " details";
        worst = std::max(worst, error);
      }
    }
    testing::Test::RecordProperty("largest_at_" + std::to_string(details), std::to_string(worst));
  }
}

// Neighbours may bend by 2 levels, which leaves half a level for a kink; edges in parts leave about as much.
TEST(BakedMeans, AreWithinALevelWhereTexelsAreSmallerThanAFifthOfTheDetail) {
  expect_within(1, {0.05, 0.2}, [](ProceduralKind) { return true; });
}

// Five points of a part no longer tell all of it.
TEST(BakedMeans, AreWithinTwoLevelsUpToHalfTheDetailButForGranite) {
  expect_within(2, {0.35, 0.49}, [](ProceduralKind kind) { return kind != ProceduralKind::kGranite; });
}

// Its edges are a quarter of a finest cell wide.
TEST(BakedMeans, OfGraniteAreWithinFiveLevelsUpToThreeQuartersOfTheDetail) {
  expect_within(5, {0.35, 0.74}, [](ProceduralKind kind) { return kind == ProceduralKind::kGranite; });
}

TEST(BakedMeans, OfStepsAlongTheTexelsAreExactForAnySize) {
  for (const ProceduralKind kind :
       {ProceduralKind::kChecker, ProceduralKind::kTiles, ProceduralKind::kBands, ProceduralKind::kBrick}) {
    for (const double details : {0.3, 1.0, 2.7, 7.3}) {
      // The reference's tents and a box of 1/64 share an edge that crosses them by up to 1/8 of it apart:
      // half a level of linear numbers, and of dark sRGB ones up to 12.92 times as many.
      const Procedural procedural{
          .kind = kind, .colors = {glm::vec3(0.2f), glm::vec3(0.8f), glm::vec3(0.5f)}, .scale = 1.3};
      EXPECT_LE(largest_error(procedural, details), 1)
          << kProceduralNames[static_cast<std::size_t>(kind)] << details;
    }
  }
}

}  // namespace
}  // namespace sweepkit::texmap
