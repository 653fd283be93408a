// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "sweepkit/report/experiment.hpp"

namespace sweepkit::report {

/// Of one call, in seconds.
struct Timing {
  double median = 0;
  double least = 0;
  double most = 0;
  int runs = 0;

  /// Where the call did a thing so many times.
  Timing of_each(std::size_t count) const {
    const auto n = static_cast<double>(count);
    return {median / n, least / n, most / n, runs};
  }
};

/// Of measured seconds. Precondition: not empty.
Timing timing_of(std::vector<double> seconds);

/// At least five runs (more where they are short), each of as many calls as last long enough to be read from
/// the clock, after one that warms up.
Timing time_calls(const std::function<void()>& call, const Effort& effort);

/// The same for several in turn, round by round, so that a machine whose speed drifts treats them alike.
std::vector<Timing> time_in_turn(const std::vector<std::function<void()>>& calls, const Effort& effort);

/// Makes the compiler believe that the value is used.
template <class T>
void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

/// The columns that add_timing() fills.
std::vector<Column> timing_columns(const std::string& of_what);
void add_timing(std::vector<Cell>& row, const Timing& timing);

}  // namespace sweepkit::report
