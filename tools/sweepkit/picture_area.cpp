// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "picture_area.hpp"

#include <charconv>
#include <cstdint>
#include <vector>

#include "curve_text.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::tools {
namespace {

// The whole numbers between separators; empty where anything else is there.
std::vector<int> whole_numbers(const std::string& text, char separator) {
  const std::vector<std::string> parts = split(text, separator);
  std::vector<int> numbers;
  numbers.reserve(parts.size());
  for (const std::string& part : parts) {
    int number = 0;
    const char* const end = part.data() + part.size();
    const auto [stop, error] = std::from_chars(part.data(), end, number);
    if (error != std::errc() || stop != end) return {};
    numbers.push_back(number);
  }
  return numbers;
}

}  // namespace

render::Region parse_crop(const std::string& text) {
  const std::vector<int> numbers = whole_numbers(text, ',');
  if (numbers.size() != 4) {
    throw InputError(
        {.file = "--crop"},
        "needs X,Y,WIDTH,HEIGHT in pixels from the top left, such as 100,50,64,48, got \"" + text + "\"");
  }
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

Tile parse_tile(const std::string& text) {
  const std::vector<int> numbers = whole_numbers(text, '/');
  const bool is_tile = numbers.size() == 2 && numbers[1] >= 1 && numbers[1] <= kMostTiles &&
                       numbers[0] >= 1 && numbers[0] <= numbers[1];
  if (!is_tile) {
    throw InputError({.file = "--tile"}, "needs I/N, part I of 1 to N of a picture, N at most " +
                                             std::to_string(kMostTiles) + ", such as 1/4, got \"" + text +
                                             "\"");
  }
  return {numbers[0], numbers[1]};
}

render::Region area_of(int width, int height, const std::optional<render::Region>& crop) {
  if (!crop) return {0, 0, width, height};
  const bool is_inside = crop->x >= 0 && crop->y >= 0 && crop->width > 0 && crop->height > 0 &&
                         crop->x <= width - crop->width && crop->y <= height - crop->height;
  if (!is_inside) {
    throw InputError({.file = "--crop"}, "needs pixels inside the picture of " + std::to_string(width) +
                                             " x " + std::to_string(height) + ", got " +
                                             std::to_string(crop->width) + " x " +
                                             std::to_string(crop->height) + " at " + std::to_string(crop->x) +
                                             "," + std::to_string(crop->y));
  }
  return *crop;
}

render::Region part_of(const render::Region& area, const Tile& tile) {
  if (tile.count > area.height) {
    throw InputError({.file = "--tile"},
                     "needs a row of pixels for each tile: " + std::to_string(tile.count) + " tiles of " +
                         std::to_string(area.height) + (area.height == 1 ? " row" : " rows") +
                         "; ask for fewer tiles");
  }
  const auto end_of = [&](int index) {
    return static_cast<int>(std::int64_t{area.height} * index / tile.count);
  };
  const int first = end_of(tile.index - 1);
  return {area.x, area.y + first, area.width, end_of(tile.index) - first};
}

}  // namespace sweepkit::tools
