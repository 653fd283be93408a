// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/procedural.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <span>

#include "sweepkit/texmap/noise.hpp"

namespace sweepkit::texmap {
namespace {

// Past 2^52 a double has no fraction left; patterns are held there instead of turned to noise.
constexpr double kFarthest = 4503599627370496.0;

using Colors = std::span<const glm::vec3>;

Colors default_colors(ProceduralKind kind) {
  static constexpr glm::vec3 kIvory(0.85f, 0.83f, 0.78f);
  static constexpr glm::vec3 kSlate(0.06f, 0.065f, 0.07f);
  static constexpr std::array kChecker = {kIvory, kSlate};
  static constexpr glm::vec3 kSand(0.72f, 0.64f, 0.52f);
  static constexpr glm::vec3 kTerracotta(0.42f, 0.14f, 0.08f);
  static constexpr glm::vec3 kMortar(0.28f, 0.26f, 0.24f);
  static constexpr std::array kTiles = {kSand, kTerracotta, kMortar};
  static constexpr glm::vec3 kClay(0.72f, 0.58f, 0.36f);
  static constexpr glm::vec3 kRust(0.32f, 0.07f, 0.035f);
  static constexpr glm::vec3 kIndigo(0.03f, 0.07f, 0.16f);
  static constexpr std::array kBands = {kClay, kRust, kClay, kIndigo};
  static constexpr glm::vec3 kVein(0.16f, 0.18f, 0.23f);
  static constexpr glm::vec3 kCloud(0.66f, 0.67f, 0.69f);
  static constexpr glm::vec3 kWhite(0.86f, 0.85f, 0.83f);
  static constexpr std::array kMarble = {kVein, kCloud, kWhite};
  switch (kind) {
    case ProceduralKind::kChecker:
      return kChecker;
    case ProceduralKind::kTiles:
      return kTiles;
    case ProceduralKind::kBands:
      return kBands;
    case ProceduralKind::kMarble:
      return kMarble;
  }
  return kChecker;
}

std::int64_t cell(double x) {
  return static_cast<std::int64_t>(std::floor(x));
}

bool is_whole(double scale) {
  return scale >= 1 && scale == std::floor(scale);
}

glm::vec3 checker(Colors colors, const glm::dvec3& p) {
  const std::int64_t parity = cell(2 * p.x) + cell(2 * p.y) + cell(2 * p.z);
  return colors[(parity & 1) != 0 && colors.size() > 1 ? 1 : 0];
}

std::size_t tile_color(std::int64_t x, std::int64_t y, std::size_t count, double scale) {
  if (count == 1) return 0;
  if (count == 2) return static_cast<std::size_t>((x + y) & 1);
  if (is_whole(scale)) {  // the same tile after one unit
    const auto period = static_cast<std::int64_t>(scale);
    x = ((x % period) + period) % period;
    y = ((y % period) + period) % period;
  }
  std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15u +
                    static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4Fu;
  h = (h ^ (h >> 32)) * 0xD6E8FEB86659FD93u;
  return static_cast<std::size_t>((h >> 33) % count);
}

glm::vec3 tiles(Colors colors, const Procedural& procedural, double x, double y) {
  const double half = 0.5 * procedural.grout;
  const double fx = x - std::floor(x);
  const double fy = y - std::floor(y);
  const bool is_grout = fx < half || fx > 1 - half || fy < half || fy > 1 - half;
  if (colors.size() == 1) return colors[0];
  if (is_grout) return colors.back();
  return colors[tile_color(cell(x), cell(y), colors.size() - 1, procedural.scale)];
}

glm::vec3 bands(Colors colors, std::span<const double> widths, double y) {
  const double t = y - std::floor(y);
  if (widths.size() != colors.size()) {
    return colors[std::min(static_cast<std::size_t>(t * static_cast<double>(colors.size())),
                           colors.size() - 1)];
  }
  double left = t * std::accumulate(widths.begin(), widths.end(), 0.0);
  for (std::size_t i = 0; i + 1 < colors.size(); ++i) {
    if (left < widths[i]) return colors[i];
    left -= widths[i];
  }
  return colors.back();
}

glm::vec3 marble(Colors colors, const Procedural& procedural, const glm::dvec3& p) {
  const double bend = procedural.turbulence * turbulence(p, std::clamp(procedural.octaves, 1, 16));
  const double wave = 0.5 + 0.5 * std::sin(2 * std::numbers::pi * p.x + bend);
  // The square root keeps the dark veins thin.
  const double along = std::sqrt(wave) * static_cast<double>(colors.size() - 1);
  const std::size_t index = std::min(static_cast<std::size_t>(along), colors.size() - 1);
  const std::size_t next = std::min(index + 1, colors.size() - 1);
  return glm::mix(colors[index], colors[next], static_cast<float>(along - static_cast<double>(index)));
}

}  // namespace

glm::vec3 evaluate(const Procedural& procedural, glm::dvec2 uv, const glm::dvec3& position) {
  const bool is_on_uv = procedural.on == ProceduralOn::kUv;
  glm::dvec3 p = procedural.scale * (is_on_uv ? glm::dvec3(uv, 0) : position);
  p = glm::clamp(p, glm::dvec3(-kFarthest), glm::dvec3(kFarthest));
  if (p != p) p = glm::dvec3(0.0);
  const Colors colors =
      procedural.colors.empty() ? default_colors(procedural.kind) : Colors(procedural.colors);
  switch (procedural.kind) {
    case ProceduralKind::kChecker:
      return checker(colors, p);
    case ProceduralKind::kTiles:
      return tiles(colors, procedural, p.x, is_on_uv ? p.y : p.z);
    case ProceduralKind::kBands:
      return bands(colors, procedural.widths, p.y);
    case ProceduralKind::kMarble:
      return marble(colors, procedural, p);
  }
  return colors[0];
}

bool repeats_in_unit_square(const Procedural& procedural) {
  if (procedural.on != ProceduralOn::kUv || !is_whole(procedural.scale)) return false;
  switch (procedural.kind) {
    case ProceduralKind::kChecker:
      return true;
    // Two tile colours stand like a chessboard, which closes after an even number.
    case ProceduralKind::kTiles:
      return !(procedural.colors.size() == 3 || procedural.colors.empty()) ||
             std::fmod(procedural.scale, 2) == 0;
    case ProceduralKind::kBands:
      return true;
    case ProceduralKind::kMarble:
      return false;
  }
  return false;
}

}  // namespace sweepkit::texmap
