// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "point_file.hpp"

#include <algorithm>
#include <cmath>

#include "message_text.hpp"
#include "number_token.hpp"
#include "object_reader.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\f' || c == '\v';
}

class Line {
 public:
  Line(std::string_view text, const std::string& file, int number)
      : text_(text.substr(0, text.find('#'))), file_(file), number_(number) {
    skip_blanks();
  }

  bool is_empty() const { return at_ == text_.size(); }

  // A name or the columns' titles: the first word is no number, nor begins as one.
  bool is_header() const {
    std::string_view rest = text_.substr(at_);
    const std::string_view word = rest.substr(0, word_length(at_));
    return !take_number(rest) && !is_no_finite(word);
  }

  // The numbers of the line, at most three.
  int read(glm::dvec3& point) {
    int columns = 0;
    for (;;) {
      if (columns == 3) fail(at_, "has more than 3 columns; a point is x y or x y z, apart by , ; or blanks");
      point[columns++] = number();
      if (is_empty()) return columns;
      if (text_[at_] == ',' || text_[at_] == ';') {
        ++at_;
        skip_blanks();
      }
    }
  }

  [[noreturn]] void fail(std::size_t at, const std::string& problem) const {
    throw InputError({.file = file_, .line = number_, .column = static_cast<int>(at) + 1}, problem);
  }
  [[noreturn]] void fail(const std::string& problem) const { fail(0, problem); }

 private:
  static bool is_no_finite(std::string_view word) {
    std::string lower(word.substr(word.find_first_not_of("+-") == 1 ? 1 : 0));
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return lower == "nan" || lower == "inf" || lower == "infinity";
  }

  std::size_t word_length(std::size_t from) const {
    std::size_t end = from;
    while (end < text_.size() && !is_blank(text_[end]) && text_[end] != ',' && text_[end] != ';') ++end;
    return end - from;
  }

  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }

  double number() {
    const std::string_view word = text_.substr(at_, word_length(at_));
    if (word.empty()) fail(at_, "needs a number here; the field is empty");
    std::string_view rest = word;
    const std::optional<double> value = take_number(rest);
    if (!value || !rest.empty()) {
      fail(at_, "needs a number, got " + in_quotes(word) + "; put # before what is no point");
    }
    if (!(std::abs(*value) <= kFarthest)) {
      fail(at_, "needs to be at most " + to_text(kFarthest) + " m from 0, got " + one_line(word, 40));
    }
    at_ += word.size();
    skip_blanks();
    return *value;
  }

  std::string_view text_;
  const std::string& file_;
  int number_;
  std::size_t at_ = 0;
};

// "17. 17." before seventeen points of the upper surface and seventeen of the lower one.
bool is_lednicer(const PointFile& read) {
  const glm::dvec3& first = read.points.front();
  return read.columns == 2 && first.x > 1 && first.y > 1 && first.x == std::floor(first.x) &&
         first.y == std::floor(first.y) && first.x + first.y + 1 == static_cast<double>(read.points.size());
}

}  // namespace

PointFile read_points(std::string_view text, const std::string& file) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  PointFile read;
  bool has_header = false;
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    Line line(text.substr(0, end), file, ++number);
    text.remove_prefix(text.substr(end).starts_with("\r\n") ? end + 2 : std::min(end + 1, text.size()));
    if (line.is_empty()) continue;
    if (read.points.empty() && !has_header && line.is_header()) {
      has_header = true;
      continue;
    }
    glm::dvec3 point(0.0);
    const int columns = line.read(point);
    if (columns < 2) line.fail("needs 2 or 3 numbers a line, got 1");
    if (read.points.empty()) read.columns = columns;
    if (columns != read.columns) {
      line.fail("needs " + std::to_string(read.columns) + " numbers as the lines before, got " +
                std::to_string(columns));
    }
    if (read.points.size() == kMostPoints) {
      line.fail("has more than " + std::to_string(kMostPoints) + " points; thin them out");
    }
    read.points.push_back(point);
  }
  if (read.points.empty())
    throw InputError({.file = file}, "has no points; give x y or x y z, a point a line");
  if (has_header && is_lednicer(read)) {
    throw InputError(
        {.file = file},
        "lists its two surfaces apart (Lednicer's order); give one run round the airfoil (Selig's)");
  }
  return read;
}

}  // namespace sweepkit::scene
