// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace sweepkit {

/// Where in the user's input something stands. What is not known stays empty or 0.
struct Place {
  std::string file;     ///< as the user named it, or the option ("--set")
  int line = 0;         ///< from 1
  int column = 0;       ///< from 1, in bytes
  std::string pointer;  ///< JSON pointer inside the file ("/objects/0/sweep")
};

/// "vase.json:14:9: /objects/0/contour: " without the parts that are not known.
inline std::string to_prefix(const Place& place) {
  std::string prefix;
  if (!place.file.empty()) {
    prefix += place.file;
    if (place.line > 0) prefix += ':' + std::to_string(place.line) + ':' + std::to_string(place.column);
    prefix += ": ";
  }
  if (!place.pointer.empty()) prefix += place.pointer + ": ";
  return prefix;
}

/// Input that cannot be used. `problem` is one line: the value, the limit and what to do
/// ("needs at least 2 control points, got 1"). A library that knows no files throws it without a place;
/// the reader of the file catches it and throws it again with one. The program ends with status 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::string problem) : InputError(Place{}, std::move(problem)) {}
  InputError(Place place, std::string problem)
      : std::runtime_error(to_prefix(place) + problem),
        place_(std::move(place)),
        problem_(std::move(problem)) {}

  const Place& place() const { return place_; }
  const std::string& problem() const { return problem_; }

 private:
  Place place_;
  std::string problem_;
};

/// Work that failed for a reason outside the input: a full disk, a write refused half way. The program ends
/// with 1.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace sweepkit
