// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "picture_mark.hpp"

#include <charconv>
#include <map>

#include "curve_text.hpp"

namespace sweepkit::tools {
namespace {

constexpr const char* kBegin = "sweepkit-picture";

// As many whole numbers as there are targets, a separator between two.
template <class... Int>
bool read(const std::string& text, char separator, Int&... targets) {
  const char* at = text.data();
  const char* const end = at + text.size();
  bool is_first = true;
  const auto read_one = [&](int& target) {
    if (!is_first && (at == end || *at++ != separator)) return false;
    is_first = false;
    const auto [stop, error] = std::from_chars(at, end, target);
    at = stop;
    return error == std::errc() && target >= 0;
  };
  return (read_one(targets) && ...) && at == end;
}

}  // namespace

std::string to_text(const PictureMark& mark) {
  const auto number = [](int value) { return std::to_string(value); };
  const render::Region& area = mark.area;
  std::string text = std::string(kBegin) + " key=" + mark.key + " size=" + number(mark.width) + "x" +
                     number(mark.height) + " area=" + number(area.x) + "," + number(area.y) + "," +
                     number(area.width) + "," + number(area.height);
  if (mark.turn) text += " turn=" + number(mark.turn->frame) + "/" + number(mark.turn->count);
  if (mark.tile) {
    text += " tile=" + number(mark.tile->index) + "/" + number(mark.tile->count) +
            " whole=" + (mark.is_whole_marked ? "marked" : "plain");
  }
  return text;
}

std::optional<PictureMark> parse_mark(const std::string& text) {
  const std::vector<std::string> words = split(text, ' ');
  if (words.empty() || words.front() != kBegin) return std::nullopt;
  std::map<std::string, std::string> fields;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::size_t equals = words[i].find('=');
    if (equals == std::string::npos) return std::nullopt;
    fields[words[i].substr(0, equals)] = words[i].substr(equals + 1);
  }
  PictureMark mark;
  mark.key = fields["key"];
  render::Region& area = mark.area;
  if (mark.key.empty() || !read(fields["size"], 'x', mark.width, mark.height) ||
      !read(fields["area"], ',', area.x, area.y, area.width, area.height)) {
    return std::nullopt;
  }
  if (fields.contains("turn")) {
    Turn& turn = mark.turn.emplace();
    if (!read(fields["turn"], '/', turn.frame, turn.count)) return std::nullopt;
  }
  if (fields.contains("tile")) {
    Tile& tile = mark.tile.emplace();
    if (!read(fields["tile"], '/', tile.index, tile.count)) return std::nullopt;
    mark.is_whole_marked = fields["whole"] == "marked";
    // Another program may have written it.
    const bool is_sound = tile.index >= 1 && tile.index <= tile.count && tile.count <= area.height;
    if (!is_sound) return std::nullopt;
  }
  if (to_text(mark) != text) return std::nullopt;
  return mark;
}

}  // namespace sweepkit::tools
