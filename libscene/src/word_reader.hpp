// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace sweepkit::scene {

/// The words of a text file, line by line, each with its place for messages. A comment runs from # to the end
/// of its line.
class WordReader {
 public:
  /// Lines count from `first_line`.
  WordReader(std::string_view text, const std::string& file, int first_line = 1)
      : rest_(text), file_(file), number_(first_line - 1) {}

  /// Goes to the next line that has a word; false at the end of the text. A backslash at a line's end joins
  /// it with the one after.
  bool next_line();
  /// The next word of the line, "" at its end.
  std::string_view word();
  /// The rest of the line without blanks round it.
  std::string_view rest() const;
  bool is_at_end() const { return rest().empty(); }

  /// The next word as a number, at most `most` from 0; `what` says what it is to be ("a coordinate").
  double number(const char* what, double most);
  /// The next word as a whole number from 0 to `most`.
  std::uint64_t whole(const char* what, std::uint64_t most);

  /// Throws InputError at the word read last.
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  std::string_view rest_;  // after the line
  std::string_view line_;
  std::string joined_;  // a line that was several
  std::size_t at_ = 0;
  std::size_t word_at_ = 0;
  const std::string& file_;
  int number_;
  int joined_lines_ = 0;
};

/// A word as a number. Throws InputError through `words` as WordReader::number() does.
double number_of(std::string_view word, const char* what, double most, const WordReader& words);

}  // namespace sweepkit::scene
