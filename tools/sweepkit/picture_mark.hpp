// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "picture_area.hpp"
#include "sweepkit/render/render.hpp"

namespace sweepkit::tools {

/// A step of a turntable: `frame` of `count` to a full turn.
struct Turn {
  int frame = 0;
  int count = 1;

  bool operator==(const Turn&) const = default;
};

/// What a picture's file says of itself, in one line of text that all its formats keep: what was drawn (a
/// hash of the scene, the files it names, the options that change the picture and the program's version), and
/// which part of it. Two files with equal marks are the same picture.
struct PictureMark {
  std::string key;  ///< hexadecimal digits
  int width = 0;    ///< of the whole picture
  int height = 0;
  render::Region area;  ///< what of it is drawn: all, or a crop
  std::optional<Turn> turn;
  std::optional<Tile> tile;
  bool is_whole_marked = true;  ///< would the area drawn at once have had a mark?
};

std::string to_text(const PictureMark& mark);

/// None where the text is no mark.
std::optional<PictureMark> parse_mark(const std::string& text);

}  // namespace sweepkit::tools
