// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>

namespace sweepkit::report {
namespace {

using Clock = std::chrono::steady_clock;

// A run this long is read from the clock to a thousandth.
constexpr double kRunSeconds = 200e-6;
constexpr int kFewestRuns = 5;
constexpr int kMostRuns = 25;

double run_seconds(const std::function<void()>& call, std::uint64_t calls) {
  const auto start = Clock::now();
  for (std::uint64_t i = 0; i < calls; ++i) call();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// So many calls that a run is long enough; this warms up as well.
std::uint64_t calls_of_a_run(const std::function<void()>& call) {
  std::uint64_t calls = 1;
  while (true) {
    const double seconds = run_seconds(call, calls);
    if (seconds >= kRunSeconds) return calls;
    const double wanted = static_cast<double>(calls) * 1.2 * kRunSeconds / std::max(seconds, 1e-9);
    calls = std::max(2 * calls, static_cast<std::uint64_t>(std::min(wanted, 1e9)));
  }
}

}  // namespace

Timing timing_of(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  const std::size_t half = seconds.size() / 2;
  const double median = seconds.size() % 2 == 1 ? seconds[half] : (seconds[half - 1] + seconds[half]) / 2;
  return {median, seconds.front(), seconds.back(), static_cast<int>(seconds.size())};
}

std::vector<Timing> time_in_turn(const std::vector<std::function<void()>>& calls, const Effort& effort) {
  std::vector<std::uint64_t> repeats;
  repeats.reserve(calls.size());
  double round_seconds = 0;
  for (const auto& call : calls) {
    repeats.push_back(calls_of_a_run(call));
    round_seconds += run_seconds(call, repeats.back());
  }
  // Short work is run more often: its median is the steadier for it.
  const double budget = effort.is_quick ? 0.02 : 0.4;
  const int runs =
      std::clamp(static_cast<int>(budget / std::max(round_seconds, 1e-9)), kFewestRuns, kMostRuns);
  std::vector<std::vector<double>> seconds(calls.size());
  for (int run = 0; run < runs; ++run) {
    for (std::size_t k = 0; k < calls.size(); ++k) {
      // Every other round backwards.
      const std::size_t i = run % 2 == 0 ? k : calls.size() - 1 - k;
      seconds[i].push_back(run_seconds(calls[i], repeats[i]) / static_cast<double>(repeats[i]));
    }
  }
  std::vector<Timing> timings;
  timings.reserve(calls.size());
  for (std::vector<double>& all : seconds) timings.push_back(timing_of(std::move(all)));
  return timings;
}

Timing time_calls(const std::function<void()>& call, const Effort& effort) {
  return time_in_turn({call}, effort).front();
}

std::vector<Column> timing_columns(const std::string& of_what) {
  return {{"seconds", "time for " + of_what + " (s)"},
          {"seconds_least", "least of the runs (s)"},
          {"seconds_most", "most of the runs (s)"},
          {"runs", "runs"}};
}

void add_timing(std::vector<Cell>& row, const Timing& timing) {
  row.insert(row.end(), {timing.median, timing.least, timing.most, static_cast<double>(timing.runs)});
}

}  // namespace sweepkit::report
