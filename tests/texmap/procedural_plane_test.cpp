// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Every procedural texture on a plane to the horizon, and its mean, against many points.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sweepkit/texmap/procedural.hpp"

namespace sweepkit::texmap {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Bound {
  ProceduralKind kind;
  double psnr;  // of the filtered picture
  double gain;  // over the point sampled one
};

// A plane below the eye, turned by 35 degrees: pixel (x, y) of 96 x 48, the horizon at y = -1/2.
glm::dvec3 place_of(double x, double y, ProceduralOn on) {
  const double distance = 48 / (1.2 * (y + 0.5));
  const double right = (x - 48) / 48 * distance;
  const double ahead = 1.2 * distance;
  const double c = std::cos(35 * kPi / 180);
  const double s = std::sin(35 * kPi / 180);
  const glm::dvec2 p(c * right - s * ahead, s * right + c * ahead);
  return on == ProceduralOn::kUv ? glm::dvec3(p, 0) : glm::dvec3(p.x, 0.13, p.y);
}

TEST(ProceduralPlane, DoesNotAliasToTheHorizon) {
  // dB. Steps are exact but for their cuts; noise is foretold from a few places. Measured, less 2 for the
  // pixels that another compiler's library decides otherwise.
  constexpr std::array kBounds = {
      Bound{ProceduralKind::kChecker, 38, 22}, Bound{ProceduralKind::kTiles, 44, 20},
      Bound{ProceduralKind::kBands, 40, 20},   Bound{ProceduralKind::kBrick, 44, 20},
      Bound{ProceduralKind::kMarble, 35, 13},  Bound{ProceduralKind::kWood, 39, 13},
      Bound{ProceduralKind::kGranite, 28, 13}, Bound{ProceduralKind::kClouds, 35, 13},
      Bound{ProceduralKind::kNoise, 34, 13}};
  constexpr int kSide = 16;
  for (const Bound& bound : kBounds) {
    const ProceduralOn on = ProceduralOn::kUv;
    const Procedural procedural{.kind = bound.kind, .on = on};
    double point = 0;
    double filtered = 0;
    double count = 0;
    // The first rows lie past where differences between pixels tell their size.
    for (int y = 4; y < 48; ++y) {
      for (int x = 0; x < 96; ++x) {
        glm::dvec3 mean(0.0);
        double weights = 0;
        for (int i = 0; i < kSide * kSide; ++i) {
          const int row = i / kSide;
          const glm::dvec2 t((2 * (i % kSide) + 1.0) / kSide - 1, (2 * row + 1.0) / kSide - 1);
          const double weight = (1 - std::abs(t.x)) * (1 - std::abs(t.y));
          mean += weight * glm::dvec3(evaluate(procedural, {place_of(x + 0.5 + t.x, y + 0.5 + t.y, on)}));
          weights += weight;
        }
        mean /= weights;
        const auto at = [&](double a, double b) { return place_of(x + 0.5 + a, y + 0.5 + b, on); };
        const glm::dvec3 pixel(
            evaluate(procedural, {at(0, 0), 0.5 * (at(1, 0) - at(-1, 0)), 0.5 * (at(0, 1) - at(0, -1))}));
        const glm::dvec3 sample(evaluate(procedural, {at(0, 0)}));
        filtered += glm::dot(pixel - mean, pixel - mean);
        point += glm::dot(sample - mean, sample - mean);
        count += 3;
      }
    }
    const double psnr = -10 * std::log10(filtered / count);
    const double of_point = -10 * std::log10(point / count);
    const std::string_view name = kProceduralNames[static_cast<std::size_t>(bound.kind)];
    RecordProperty(std::string(name), std::to_string(psnr) + " " + std::to_string(of_point));
    EXPECT_GT(psnr, bound.psnr) << name;
    EXPECT_GT(psnr - of_point, bound.gain) << name << ", by points " << of_point;
  }
}

TEST(ProceduralPlane, TheMeanIsThatOfAMillionPoints) {
  for (std::size_t kind = 0; kind < kProceduralNames.size(); ++kind) {
    for (const ProceduralOn on : {ProceduralOn::kUv, ProceduralOn::kPosition}) {
      // A scale that is not whole: nothing comes round.
      const Procedural procedural{.kind = static_cast<ProceduralKind>(kind), .on = on, .scale = 1.25};
      std::mt19937_64 random(kind + 1);
      std::uniform_real_distribution<double> real(0, 4000);
      constexpr int kCount = 1000000;
      glm::dvec3 sum(0.0);
      for (int n = 0; n < kCount; ++n) {
        const glm::dvec3 at(real(random), real(random), on == ProceduralOn::kUv ? 0.0 : real(random));
        sum += glm::dvec3(evaluate(procedural, {at}));
      }
      const glm::dvec3 off = glm::abs(sum / static_cast<double>(kCount) - glm::dvec3(mean_of(procedural)));
      // Colours have a deviation of 0.4 at most: that of the mean of a million is 4e-4. On (u,v) the octaves
      // share their lattice's lines, so they are not quite independent, which granite's edges show.
      const bool is_granite_on_uv = procedural.kind == ProceduralKind::kGranite && on == ProceduralOn::kUv;
      EXPECT_LT(std::max({off.x, off.y, off.z}), is_granite_on_uv ? 2.5e-3 : 1e-3)
          << kProceduralNames[kind] << (on == ProceduralOn::kUv ? " on uv" : " on position");
    }
  }
}

}  // namespace
}  // namespace sweepkit::texmap
