// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "frame_list.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>

#include "curve_text.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::tools {
namespace {

[[noreturn]] void refuse_frames(const std::string& problem) {
  throw InputError({.file = "--frames"}, problem);
}

[[noreturn]] void refuse_name(const std::string& problem) {
  throw InputError({.file = "-o"}, problem);
}

std::optional<int> whole_number(std::string_view text) {
  int number = -1;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && stop == text.data() + text.size();
  return is_number && number >= 0 && number <= kLastFrame ? std::optional(number) : std::nullopt;
}

std::string padded(int number, std::size_t digits) {
  const std::string text = std::to_string(number);
  return std::string(digits > text.size() ? digits - text.size() : 0, '0') + text;
}

// A text, or the number in so many digits.
struct NamePart {
  std::string text;
  std::optional<std::size_t> digits;
};

// What stands between braces: "frame" or "frame:04".
std::size_t digits_of(const std::string& field, std::size_t otherwise) {
  if (field == "frame") return otherwise;
  const std::optional<int> width =
      field.starts_with("frame:") ? whole_number(std::string_view(field).substr(6)) : std::nullopt;
  if (!width || *width < 1 || *width > 9) {
    refuse_name("there is no {" + field + "}; there is {frame}, and with a number of digits {frame:04}");
  }
  return static_cast<std::size_t>(*width);
}

std::vector<NamePart> parse_name(const std::string& pattern, std::size_t digits) {
  std::vector<NamePart> parts;
  std::size_t at = 0;
  while (at < pattern.size()) {
    const std::size_t brace = std::min(pattern.find_first_of("{}", at), pattern.size());
    if (brace > at) parts.push_back({pattern.substr(at, brace - at), std::nullopt});
    if (brace == pattern.size()) break;
    const std::size_t end = pattern.find_first_of("{}", brace + 1);
    if (pattern[brace] == '}' || end == std::string::npos || pattern[end] == '{') {
      refuse_name("a brace lacks its other in \"" + pattern +
                  "\"; with --frames a name holds no other braces than {frame}");
    }
    parts.push_back({"", digits_of(pattern.substr(brace + 1, end - brace - 1), digits)});
    at = end + 1;
  }
  return parts;
}

}  // namespace

FrameList parse_frames(const std::string& text) {
  FrameList list;
  std::set<int> seen;
  int largest = 0;
  for (const std::string& part : split(text, ',')) {
    const std::size_t colon = part.find(':');
    const std::string range = part.substr(0, colon);
    const std::size_t dash = range.find('-');
    const std::optional<int> first = whole_number(range.substr(0, dash));
    const std::optional<int> last = dash == std::string::npos ? first : whole_number(range.substr(dash + 1));
    const std::optional<int> step =
        colon == std::string::npos ? std::optional(1) : whole_number(part.substr(colon + 1));
    if (!first || !last || !step || *step < 1 || (colon != std::string::npos && dash == std::string::npos)) {
      refuse_frames("needs frames of 0 to " + std::to_string(kLastFrame) +
                    ", such as 7, 1-120, 1-120:2 or 3,5-10, got \"" + text + "\"");
    }
    if (*last < *first) {
      refuse_frames("the frames " + range + " run backwards; write " + std::to_string(*last) + "-" +
                    std::to_string(*first));
    }
    for (int number = *first; number <= *last; number += *step) {
      if (!seen.insert(number).second)
        refuse_frames("has frame " + std::to_string(number) + " twice in \"" + text + "\"");
      list.numbers.push_back(number);
    }
    largest = std::max(largest, *last);
  }
  if (list.numbers.empty()) refuse_frames("needs frames, such as 1-120");
  list.count_in_turn = std::max(1, largest + (seen.contains(0) ? 1 : 0));
  return list;
}

std::vector<std::string> name_frames(const std::string& pattern, const FrameList& frames) {
  if (pattern == "-") refuse_name("--frames makes a file a frame; name them, such as turn_{frame}.png");
  const int largest = *std::max_element(frames.numbers.begin(), frames.numbers.end());
  const std::vector<NamePart> parts = parse_name(pattern, std::to_string(largest).size());
  const bool has_number =
      std::any_of(parts.begin(), parts.end(), [](const NamePart& part) { return part.digits.has_value(); });
  if (!has_number && frames.numbers.size() > 1) {
    refuse_name("one name for " + std::to_string(frames.numbers.size()) +
                " frames; put {frame} in it, such as turn_{frame}.png");
  }
  std::vector<std::string> files;
  files.reserve(frames.numbers.size());
  for (const int number : frames.numbers) {
    std::string& file = files.emplace_back();
    for (const NamePart& part : parts) file += part.digits ? padded(number, *part.digits) : part.text;
  }
  return files;
}

}  // namespace sweepkit::tools
