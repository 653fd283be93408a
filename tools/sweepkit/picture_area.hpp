// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "sweepkit/render/render.hpp"

namespace sweepkit::tools {

/// Part `index` of 1 to `count` of a picture: a band of rows over its whole width, from the top. The bands
/// are as even as whole rows allow: part i ends at row height * i / count, rounded down.
struct Tile {
  int index = 1;
  int count = 1;

  bool operator==(const Tile&) const = default;
};

inline constexpr int kMostTiles = 32768;

/// "X,Y,W,H". Throws InputError naming --crop.
render::Region parse_crop(const std::string& text);

/// "I/N". Throws InputError naming --tile: no two whole numbers, N not in 1 to kMostTiles, I not in 1 to N.
Tile parse_tile(const std::string& text);

/// The part of the picture that is drawn: all of it or the crop. Throws InputError naming --crop where that
/// does not lie inside.
render::Region area_of(int width, int height, const std::optional<render::Region>& crop);

/// The tile's part of the area. Throws InputError naming --tile where the area has fewer rows than tiles.
render::Region part_of(const render::Region& area, const Tile& tile);

}  // namespace sweepkit::tools
