// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <array>

#include "pattern.hpp"

namespace sweepkit::texmap {
namespace {

using Color = glm::vec3;

constexpr std::array kChecker = {Color(0.85f, 0.83f, 0.78f), Color(0.06f, 0.065f, 0.07f)};
constexpr std::array kTiles = {Color(0.72f, 0.64f, 0.52f), Color(0.42f, 0.14f, 0.08f),  //
                               Color(0.28f, 0.26f, 0.24f)};
constexpr std::array kBands = {Color(0.72f, 0.58f, 0.36f), Color(0.32f, 0.07f, 0.035f),
                               Color(0.72f, 0.58f, 0.36f), Color(0.03f, 0.07f, 0.16f)};
constexpr std::array kBrick = {Color(0.36f, 0.105f, 0.055f), Color(0.30f, 0.078f, 0.042f),
                               Color(0.42f, 0.145f, 0.075f), Color(0.24f, 0.066f, 0.044f),
                               Color(0.34f, 0.12f, 0.075f),  Color(0.50f, 0.46f, 0.40f)};
constexpr std::array kMarble = {Color(0.16f, 0.18f, 0.23f), Color(0.66f, 0.67f, 0.69f),
                                Color(0.86f, 0.85f, 0.83f)};
constexpr std::array kWood = {Color(0.56f, 0.32f, 0.14f), Color(0.46f, 0.235f, 0.09f),
                              Color(0.21f, 0.085f, 0.028f)};
constexpr std::array kGranite = {Color(0.62f, 0.56f, 0.52f), Color(0.36f, 0.34f, 0.34f),
                                 Color(0.56f, 0.30f, 0.23f), Color(0.035f, 0.035f, 0.04f)};
constexpr std::array kClouds = {Color(0.11f, 0.28f, 0.66f), Color(0.58f, 0.66f, 0.80f),
                                Color(0.95f, 0.96f, 0.97f)};
constexpr std::array kNoise = {Color(0.02f), Color(0.95f)};

}  // namespace

KindDefaults defaults_of(ProceduralKind kind) {
  constexpr ProceduralOn kUv = ProceduralOn::kUv;
  constexpr ProceduralOn kPosition = ProceduralOn::kPosition;
  switch (kind) {
    case ProceduralKind::kChecker:
      break;
    case ProceduralKind::kTiles:
      return {kUv, kTiles, 0, 1};
    case ProceduralKind::kBands:
      return {kUv, kBands, 0, 1};
    case ProceduralKind::kBrick:
      return {kUv, kBrick, 0, 1};
    case ProceduralKind::kMarble:
      return {kPosition, kMarble, 5, 6};
    case ProceduralKind::kWood:
      return {kPosition, kWood, 1, 3};
    case ProceduralKind::kGranite:
      return {kPosition, kGranite, 0, 3};
    case ProceduralKind::kClouds:
      return {kPosition, kClouds, 0, 7};
    case ProceduralKind::kNoise:
      return {kPosition, kNoise, 0, 4};
  }
  return {kUv, kChecker, 0, 1};
}

ProceduralOn default_on(ProceduralKind kind) {
  return defaults_of(kind).on;
}

}  // namespace sweepkit::texmap
