// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The five ways from a hit on a triangle to its texture coordinates, side by side: what they cost, and what
// becomes of them on triangles and hits that are chosen to be hard, against quadruple precision.
//
// Usage: triangle_maps [--pairs N] [--threads N] [--csv FILE] [--picture FILE.png]
//   --pairs     triangles and hits in each of float and double, over all kinds together; 10^8 unless given
//   --threads   as many as the machine has unless given; the results do not depend on it
//   --csv       the same figures, a row for each number type, kind of pair and method
//   --picture   the diagonals of a wall of cells in float, mapped by the paper's method and by the default

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "sweepkit/texmap/image_file.hpp"
#include "sweepkit/texmap/triangle_maps.hpp"
#include "triangle_map_costs.hpp"
#include "triangle_map_errors.hpp"
#include "triangle_map_picture.hpp"

namespace {

using namespace sweepkit;
using namespace sweepkit::texmap;

// ---- Costs

void print_costs() {
  std::printf("operations and memory%39s %8s %6s\n", "bytes kept for a triangle", "of float", "double");
  const auto costs = report::map_costs();
  for (std::size_t row = 0; row < costs.size(); ++row) {
    const report::MapCost& cost = costs[row];
    std::printf("  %-20.*s prepare %2d * %2d /   hit %2d * %2d / %d sqrt %8zu %6zu\n",
                static_cast<int>(report::kMapNames[row].size()), report::kMapNames[row].data(),
                cost.prepare.multiplications, cost.prepare.divisions, cost.hit.multiplications,
                cost.hit.divisions, cost.hit.square_roots, cost.float_bytes, cost.double_bytes);
  }
  std::printf("  and for a texture's right triangle %zu bytes\n\n", sizeof(RightTriangle));
}

// ---- Times, as ratios to the default's

template <class Real>
void print_times(const char* type) {
  const report::MapTimings timings = report::time_maps<Real>(
      [](std::uint64_t number) { return make_case<Real>(Hardness::kNone, number); }, {});
  std::printf("%s: nanoseconds for a hit (and for a triangle), and the hit's as a share of area-ratio's\n",
              type);
  for (std::size_t row = 0; row < report::kMapNames.size(); ++row) {
    std::printf("  %-20.*s %6.1f (%5.1f) %6.2f\n", static_cast<int>(report::kMapNames[row].size()),
                report::kMapNames[row].data(), 1e9 * timings.hit[row].median,
                1e9 * timings.prepare[row].median, timings.hit[row].median / timings.hit[4].median);
  }
}

// ---- Stability

using StabilityRecord = std::array<report::KindRecord, kHardnessNames.size()>;

template <class Real>
StabilityRecord measure_stability(std::uint64_t pairs, unsigned threads) {
  StabilityRecord record;
  for (std::size_t i = 0; i < record.size(); ++i) {
    record[i] = report::measure_map_errors<Real>(
        [kind = static_cast<Hardness>(i)](std::uint64_t number) { return make_case<Real>(kind, number); },
        pairs, threads);
  }
  return record;
}

std::string seconds_since(const std::chrono::steady_clock::time_point& start) {
  char text[32];
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::snprintf(text, sizeof text, "%.0f s", elapsed.count());
  return text;
}

void print_stability(const char* type, const StabilityRecord& record) {
  std::printf("\n%s: not finite + wrong, largest error\n  %-20s", type, "");
  for (const std::string_view name : report::kMapNames)
    std::printf(" %21.*s", static_cast<int>(name.size()), name.data());
  std::printf("  steps\n");
  for (std::size_t kind = 0; kind < record.size(); ++kind) {
    const std::string_view name = kHardnessNames[kind];
    std::printf("  %-20.*s", static_cast<int>(name.size()), name.data());
    double steps = 0;
    for (std::size_t row = 0; row < report::kMapNames.size(); ++row) {
      const report::MapRecord& map = record[kind].maps[row];
      char text[64];
      std::snprintf(text, sizeof text, "%llu+%llu %.1e", static_cast<unsigned long long>(map.not_finite),
                    static_cast<unsigned long long>(map.wrong), map.largest);
      std::printf(" %21s", text);
      if (report::is_default_map(row)) steps = std::max(steps, map.steps);
    }
    std::printf("  %.2f\n", steps);
  }
}

std::string csv_of(const char* type, const StabilityRecord& record) {
  std::string csv;
  for (std::size_t kind = 0; kind < record.size(); ++kind) {
    for (std::size_t row = 0; row < report::kMapNames.size(); ++row) {
      const report::MapRecord& map = record[kind].maps[row];
      char numbers[256];
      std::snprintf(numbers, sizeof numbers, ",%llu,%llu,%llu,%llu,%.2e,%.2e,%.3e,%.3g\n",
                    static_cast<unsigned long long>(map.pairs),
                    static_cast<unsigned long long>(record[kind].without_area),
                    static_cast<unsigned long long>(map.not_finite),
                    static_cast<unsigned long long>(map.wrong), map.median, map.percentile99, map.largest,
                    map.steps);
      csv += std::string(type) + ',' + std::string(kHardnessNames[kind]) + ',' +
             std::string(report::kMapNames[row]) + numbers;
    }
  }
  return csv;
}

// Does the default keep its promise? One line for each fault.
int report_faults(const char* type, const StabilityRecord& record) {
  int faults = 0;
  for (std::size_t kind = 0; kind < record.size(); ++kind) {
    for (std::size_t row = 0; row < report::kMapNames.size(); ++row) {
      const report::MapRecord& map = record[kind].maps[row];
      if (!report::is_default_map(row) || (map.not_finite == 0 && map.wrong == 0)) continue;
      std::fprintf(stderr, "%s, %s: the default breaks its promise\n", type, kHardnessNames[kind].data());
      ++faults;
    }
    if (record[kind].not_dominant == 0) continue;
    std::fprintf(stderr, "%s, %s: the default drops a wrong axis\n", type, kHardnessNames[kind].data());
    ++faults;
  }
  return faults;
}

void write(const std::string& file, std::string_view bytes) {
  if (!(std::ofstream(file, std::ios::binary) << bytes))
    throw std::runtime_error(file + ": cannot be written");
}

struct Options {
  std::uint64_t pairs = 100'000'000;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::string csv;
  std::string picture;
};

Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string_view name = argv[i];
    const std::string value = argv[i + 1];
    if (name == "--pairs") {
      options.pairs = std::stoull(value);
    } else if (name == "--threads") {
      options.threads = static_cast<unsigned>(std::stoul(value));
    } else if (name == "--csv") {
      options.csv = value;
    } else if (name == "--picture") {
      options.picture = value;
    } else {
      throw std::runtime_error("unknown option " + std::string(name));
    }
  }
  if (argc % 2 == 0 || options.threads == 0)
    throw std::runtime_error(
        "usage: triangle_maps [--pairs N] [--threads N] [--csv FILE] [--picture FILE.png]");
  return options;
}

int run(const Options& options) {
  if (!options.picture.empty()) {
    const std::vector<std::byte> png = encode_image(bench::draw_diagonals(), ImageFormat::kPng);
    write(options.picture, {reinterpret_cast<const char*>(png.data()), png.size()});
  }
  print_costs();
  print_times<double>("double");
  print_times<float>("float");

  const std::uint64_t each = (options.pairs + kHardnessNames.size() - 1) / kHardnessNames.size();
  const auto start = std::chrono::steady_clock::now();
  const StabilityRecord of_double = measure_stability<double>(each, options.threads);
  const StabilityRecord of_float = measure_stability<float>(each, options.threads);
  std::printf("\n%llu pairs of each kind in each number type, %u threads, %s\n",
              static_cast<unsigned long long>(each), options.threads, seconds_since(start).c_str());
  print_stability("double", of_double);
  print_stability("float", of_float);
  if (!options.csv.empty()) {
    write(options.csv,
          "type,kind,method,pairs,without_area,not_finite,wrong,error_median,error_99,error_max,steps_max\n" +
              csv_of("double", of_double) + csv_of("float", of_float));
  }
  return report_faults("double", of_double) + report_faults("float", of_float) > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(parse(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
