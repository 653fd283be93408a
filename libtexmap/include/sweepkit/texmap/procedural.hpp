// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "sweepkit/texmap/noise.hpp"

namespace sweepkit::texmap {

enum class ProceduralKind { kChecker, kTiles, kBands, kBrick, kMarble, kWood, kGranite, kClouds, kNoise };
/// Their names, in order.
inline constexpr std::array<std::string_view, 9> kProceduralNames = {
    "checker", "tiles", "bands", "brick", "marble", "wood", "granite", "clouds", "noise"};
enum class ProceduralOn { kUv, kPosition };

/// A texture that is computed. The pattern's own space is (u,v,0) or the position, times `scale`.
///   checker  cells of side 1/2, on position cubes, alternate between colors[0] and colors[1]
///   tiles    unit tiles of colors[0..n-2] with grout of the last colour between them: two colours like a
///            chessboard, more at random, as many of each. On position along x and z
///   bands    colours one after another along y, as wide as `widths` says: one period is 1
///   brick    bricks of length 1 in courses of height 1 / `ratio`, every other one moved on by `bond`;
///            colors[0..n-2] at random, mortar of the last colour. On position along x - z and y, which goes
///            round the corners of a house
///   marble   veins: colours from vein to ground along x, bent by turbulence
///   wood     `rings` a unit, colors[0] in spring to the last in autumn, bent by noise, with fibres along y.
///            On position rings about the y axis; on (u,v) a board, its rings across u
///   granite  colors[0] is the ground, the others lie in it as specks, each over those before
///   clouds   colors[0] is the sky; noise above what `coverage` leaves of it runs through the others
///   noise    all colours along a sum of noise, 4 cells a unit
struct Procedural {
  ProceduralKind kind = ProceduralKind::kChecker;
  ProceduralOn on = ProceduralOn::kUv;
  std::vector<glm::vec3> colors;     ///< 2 to 256; empty: the kind's own
  double scale = 1;                  ///< periods in a unit of (u,v) or a metre
  double grout = 0.06;               ///< tiles: its width as a share of a tile, 0 to 1
  std::vector<double> widths;        ///< bands: relative, one a colour; empty: equal
  double mortar = 0.14;              ///< brick: its width as a share of a course's height, 0 to 1
  double ratio = 3;                  ///< brick: length over height of a course, mortar included, 0.1 to 100
  double bond = 0.5;                 ///< brick: share of a brick, 0 to 1
  double rings = 8;                  ///< wood, 0.01 to 1e6
  double grain = 0.3;                ///< wood: strength of the fibres, 0 to 1
  double coverage = 0.5;             ///< clouds: share of the sky, 0 to 1
  std::optional<double> turbulence;  ///< marble: 5, wood: 1; how far the pattern is bent, 0 to 1000
  std::optional<int> octaves;        ///< marble 6, wood 3, granite 3, clouds 7, noise 4; 1 to 16
  NoiseBasis basis = NoiseBasis::kPerlin2002;  ///< of the five kinds last named

  bool operator==(const Procedural&) const = default;
};

/// What a kind lies on where nothing is said: steps on (u,v), noise on the position.
ProceduralOn default_on(ProceduralKind kind);

/// Where a pixel falls in the space that a procedural is on, (u,v,0) or the position: the place of its middle
/// and the steps to the pixel on the right and to the one below. Steps of 0 are a point.
struct PatternFootprint {
  glm::dvec3 at{0.0};
  glm::dvec3 dx{0.0};
  glm::dvec3 dy{0.0};
};

/// The mean under a pixel that is a tent of one pixel each way: what is finer than the pixel fades to its
/// mean instead of aliasing. Throws nothing; finite for every input.
glm::vec3 evaluate(const Procedural& procedural, const PatternFootprint& footprint);

/// The value at one point.
glm::vec3 evaluate(const Procedural& procedural, glm::dvec2 uv, const glm::dvec3& position);

/// The mean over all of space, which evaluate() tends to as the footprint grows.
glm::vec3 mean_of(const Procedural& procedural);

/// Does the pattern repeat after 1 in u and in v? Then a unit square of it is the whole of it. On (u,v) every
/// kind does at a whole scale, as far as its tiles, bricks and rings come out whole.
bool repeats_in_unit_square(const Procedural& procedural);

}  // namespace sweepkit::texmap
