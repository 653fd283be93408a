// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "word_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "message_text.hpp"
#include "number_token.hpp"
#include "object_reader.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

constexpr std::string_view kBlanks = " \t\f\v\r";

std::string_view without_comment(std::string_view line) {
  return line.substr(0, line.find('#'));
}

}  // namespace

bool WordReader::next_line() {
  const auto take_line = [&] {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view line = without_comment(rest_.substr(0, end));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return line.substr(0, line.find_last_not_of(kBlanks) + 1);
  };
  number_ += joined_lines_;
  joined_lines_ = 0;
  while (!rest_.empty()) {
    ++number_;
    line_ = take_line();
    if (line_.ends_with('\\')) {
      joined_ = line_;
      while (joined_.ends_with('\\') && !rest_.empty()) {
        joined_.back() = ' ';
        joined_ += take_line();
        ++joined_lines_;
      }
      line_ = joined_;
    }
    at_ = word_at_ = std::min(line_.find_first_not_of(kBlanks), line_.size());
    if (at_ < line_.size()) return true;
    number_ += joined_lines_;
    joined_lines_ = 0;
  }
  line_ = {};
  at_ = word_at_ = 0;
  return false;
}

std::string_view WordReader::word() {
  word_at_ = at_;
  const std::size_t end = std::min(line_.find_first_of(kBlanks, at_), line_.size());
  const std::string_view word = line_.substr(at_, end - at_);
  at_ = std::min(line_.find_first_not_of(kBlanks, end), line_.size());
  return word;
}

std::string_view WordReader::rest() const {
  return line_.substr(at_);
}

double WordReader::number(const char* what, double most) {
  const std::string_view next = word();
  if (next.empty()) fail(std::string("needs ") + what + " here, and the line ends");
  return number_of(next, what, most, *this);
}

std::uint64_t WordReader::whole(const char* what, std::uint64_t most) {
  const std::string_view next = word();
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(next.data(), next.data() + next.size(), value);
  if (error != std::errc() || end != next.data() + next.size() || value > most) {
    fail(std::string("needs ") + what + ", a whole number from 0 to " + std::to_string(most) + ", got " +
         in_quotes(next));
  }
  return value;
}

void WordReader::fail(const std::string& problem) const {
  throw InputError({.file = file_, .line = number_, .column = static_cast<int>(word_at_) + 1}, problem);
}

double number_of(std::string_view word, const char* what, double most, const WordReader& words) {
  std::string_view rest = word;
  const std::optional<double> value = take_number(rest);
  if (!value || !rest.empty()) words.fail(std::string("needs ") + what + ", got " + in_quotes(word));
  if (!(std::abs(*value) <= most))
    words.fail(std::string(what) + " needs to be at most " + to_text(most) + " from 0, got " +
               one_line(word, 40));
  return *value;
}

}  // namespace sweepkit::scene
