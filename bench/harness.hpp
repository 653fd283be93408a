// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace sweepkit::bench {

/// One way of doing a piece of work. Only `run` is timed.
struct Contender {
  std::string name;  ///< stays the same for good: histories of results are joined by it
  std::function<void()> run;
  std::function<std::string()> check;  ///< after every run: what is wrong with its result, or ""
  std::function<void()> prepare;       ///< before every run; may be empty
  std::uint64_t calls = 1;             ///< what `run` does, this many times in a row; times are told for one
};

struct Spread {
  double median = 0;
  double min = 0;
  double max = 0;
};

/// Median (of an even number the mean of the middle two), least and greatest. Precondition: not empty.
Spread spread(std::vector<double> values);

struct Result {
  std::string name;
  Spread seconds;  ///< for one call
  Spread ratio;    ///< this one's time over the first contender's in the same round
};

struct Comparison {
  std::string name;
  int rounds = 0;
  std::vector<Result> results;  ///< in the contenders' order
};

/// Runs all contenders in turn, `rounds` times after one round that warms up, each round in the opposite
/// order of the one before, so that a machine whose speed drifts treats them alike. The ratios are taken
/// round by round: they are far steadier than the times. Throws std::runtime_error where a check finds a
/// wrong result: a benchmark of something else is worse than none.
Comparison compare(std::string name, const std::vector<Contender>& contenders, int rounds = 9);

/// A table for people.
std::string to_table(const Comparison& comparison);

/// Rows of
/// "comparison,contender,rounds,seconds_median,seconds_min,seconds_max,ratio_median,ratio_min,ratio_max",
/// under that line as a head.
std::string to_csv(const std::vector<Comparison>& comparisons);

/// Makes the compiler believe that the value is used.
template <class T>
void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

}  // namespace sweepkit::bench
