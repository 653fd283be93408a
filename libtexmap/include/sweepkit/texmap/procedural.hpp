// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace sweepkit::texmap {

enum class ProceduralKind { kChecker, kTiles, kBands, kMarble };
enum class ProceduralOn { kUv, kPosition };

/// A texture that is computed. The pattern's own space is (u,v,0) or the position, times `scale`.
///   checker  cells of side 1/2 alternate between colors[0] and colors[1]: one period is 1
///   tiles    unit tiles of colors[0..n-2], picked by cell, with grout of the last colour `grout` wide
///   between them bands    colours one after another along y, as wide as `widths` says (relative; equal where
///   empty): one period is 1 marble   veins: colors blended along x by a sine bent by turbulence of Perlin's
///   noise [Perlin85]
struct Procedural {
  ProceduralKind kind = ProceduralKind::kChecker;
  ProceduralOn on = ProceduralOn::kUv;
  std::vector<glm::vec3> colors;  ///< empty: the kind's own
  double scale = 1;               ///< periods in a unit of (u,v) or a metre
  double grout = 0.06;            ///< tiles: its width as a share of a tile, 0 to 1
  std::vector<double> widths;     ///< bands: one a colour
  double turbulence = 5;          ///< marble: how far the veins are bent
  int octaves = 6;                ///< marble

  bool operator==(const Procedural&) const = default;
};

/// The value at one point. Throws nothing; defined for every finite input.
glm::vec3 evaluate(const Procedural& procedural, glm::dvec2 uv, const glm::dvec3& position);

/// Does the pattern repeat after 1 in u and in v? Then a unit square of it is the whole of it.
bool repeats_in_unit_square(const Procedural& procedural);

}  // namespace sweepkit::texmap
