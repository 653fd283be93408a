// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "harness.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>

namespace sweepkit::bench {
namespace {

double timed_run(const Contender& contender) {
  if (contender.prepare) contender.prepare();
  const auto start = std::chrono::steady_clock::now();
  for (std::uint64_t i = 0; i < contender.calls; ++i) contender.run();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  if (const std::string problem = contender.check ? contender.check() : ""; !problem.empty()) {
    throw std::runtime_error(contender.name + ": " + problem);
  }
  return elapsed.count() / static_cast<double>(contender.calls);
}

std::string seconds_text(double seconds) {
  static constexpr struct {
    double least;
    double factor;
    const char* unit;
  } kUnits[] = {{1, 1, "s"}, {1e-3, 1e3, "ms"}, {1e-6, 1e6, "us"}, {0, 1e9, "ns"}};
  for (const auto& [least, factor, unit] : kUnits) {
    if (seconds < least) continue;
    char text[32];
    std::snprintf(text, sizeof text, "%.3g %s", factor * seconds, unit);
    return text;
  }
  return "0 s";
}

}  // namespace

Spread spread(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
  return {median, values.front(), values.back()};
}

Comparison compare(std::string name, const std::vector<Contender>& contenders, int rounds) {
  std::vector<std::vector<double>> seconds(contenders.size());
  for (const Contender& contender : contenders) timed_run(contender);
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      const std::size_t turn = round % 2 == 0 ? i : contenders.size() - 1 - i;
      seconds[turn].push_back(timed_run(contenders[turn]));
    }
  }
  Comparison comparison{std::move(name), rounds, {}};
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    std::vector<double> ratios;
    for (std::size_t round = 0; round < seconds[i].size(); ++round)
      ratios.push_back(seconds[i][round] / seconds[0][round]);
    comparison.results.push_back({contenders[i].name, spread(seconds[i]), spread(ratios)});
  }
  return comparison;
}

std::string to_table(const Comparison& comparison) {
  std::string out = comparison.name + " (" + std::to_string(comparison.rounds) + " rounds)\n";
  for (const Result& result : comparison.results) {
    char line[256];
    std::snprintf(line, sizeof line, "  %-32s %10s  (%s to %s)   x %.3f  (%.3f to %.3f)\n",
                  result.name.c_str(), seconds_text(result.seconds.median).c_str(),
                  seconds_text(result.seconds.min).c_str(), seconds_text(result.seconds.max).c_str(),
                  result.ratio.median, result.ratio.min, result.ratio.max);
    out += line;
  }
  return out;
}

std::string to_csv(const std::vector<Comparison>& comparisons) {
  std::string out =
      "comparison,contender,rounds,seconds_median,seconds_min,seconds_max,ratio_median,ratio_min,ratio_max\n";
  for (const Comparison& comparison : comparisons) {
    for (const Result& result : comparison.results) {
      char numbers[256];
      std::snprintf(numbers, sizeof numbers, ",%d,%.9g,%.9g,%.9g,%.6g,%.6g,%.6g\n", comparison.rounds,
                    result.seconds.median, result.seconds.min, result.seconds.max, result.ratio.median,
                    result.ratio.min, result.ratio.max);
      out += comparison.name + ',' + result.name + numbers;
    }
  }
  return out;
}

}  // namespace sweepkit::bench
