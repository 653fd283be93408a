// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "name_pattern.hpp"

#include <algorithm>

#include "generate.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::tools {
namespace {

// A file's name ends at 255 bytes on nearly every disk; a .gltf's images add a few to it ("_12.png").
constexpr std::size_t kLongestName = 240;

[[noreturn]] void refuse(const std::string& problem) {
  throw InputError({.file = "-o"}, problem);
}

}  // namespace

NamePattern::NamePattern(const std::string& text, const scene::ValuesTable& table) : table_(&table) {
  if (text == "-") refuse("--each makes a file a row; name them, such as out/vase_{row}.glb");
  check_model_name(text);
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t brace = std::min(text.find_first_of("{}", at), text.size());
    if (brace > at) parts_.emplace_back(text.substr(at, brace - at));
    if (brace == text.size()) break;
    const std::size_t end = text.find_first_of("{}", brace + 1);
    if (text[brace] == '}' || end == std::string::npos || text[end] == '{') {
      refuse("a brace lacks its other in \"" + text +
             "\"; with --each a name holds no other braces than {row} and {POINTER}");
    }
    parts_.push_back(field(text.substr(brace + 1, end - brace - 1)));
    at = end + 1;
  }
  if (table.rows.size() > 1 && parts_.size() == 1 && std::holds_alternative<std::string>(parts_.front())) {
    refuse("one name for " + std::to_string(table.rows.size()) +
           " rows; put {row} in it, such as out/vase_{row}.glb");
  }
}

NamePattern::Part NamePattern::field(const std::string& name) const {
  if (name == "row") return RowNumber{};
  std::string known = "{row}";
  for (std::size_t i = 0; i < table_->pointers.size(); ++i) {
    if (table_->pointers[i].text == name) return i;
    known += ", {" + table_->pointers[i].text + '}';
  }
  refuse("there is no {" + name + "}; there is " + known);
}

std::string NamePattern::file(std::size_t row) const {
  const scene::ValuesTable::Row& cells = table_->rows[row];
  std::string file;
  for (const Part& part : parts_) {
    if (const auto* text = std::get_if<std::string>(&part)) {
      file += *text;
    } else if (const auto* column = std::get_if<std::size_t>(&part)) {
      file += value(cells[*column], table_->pointers[*column].text);
    } else {
      const std::string number = std::to_string(row + 1);
      file.append(std::to_string(table_->rows.size()).size() - number.size(), '0');
      file += number;
    }
  }
  const std::size_t slash = file.find_last_of('/');
  if (file.size() - (slash == std::string::npos ? 0 : slash + 1) > kLongestName) {
    throw InputError(table_->place(cells.front()),
                     "makes a file's name of over " + std::to_string(kLongestName) + " bytes; shorten it");
  }
  return file;
}

std::string NamePattern::value(const scene::ValuesTable::Cell& cell, const std::string& pointer) const {
  const auto fail = [&](const std::string& problem) {
    Place place = table_->place(cell);
    place.pointer = pointer;
    throw InputError(place, problem);
  };
  // A string may be written as JSON, in quotes of its own.
  const bool is_quoted = cell.text.size() >= 2 && cell.text.front() == '"' && cell.text.back() == '"';
  std::string text = is_quoted ? cell.text.substr(1, cell.text.size() - 2) : cell.text;
  if (text.empty()) fail("is empty, and the file is named for it; give a value, or name files by {row}");
  const bool is_unsafe = text == "." || text == ".." || std::any_of(text.begin(), text.end(), [](char c) {
                           return c == '/' || c == '\\' || (c >= 0 && c < 0x20) || c == 0x7F;
                         });
  if (is_unsafe) fail("cannot be part of a file's name: \"" + text + "\"; name files by {row}");
  return text;
}

}  // namespace sweepkit::tools
