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

#include "counting_number.hpp"
#include "harness.hpp"
#include "sweepkit/texmap/image_file.hpp"
#include "sweepkit/texmap/triangle_maps.hpp"
#include "triangle_map_picture.hpp"
#include "triangle_map_stability.hpp"

namespace {

using namespace sweepkit;
using namespace sweepkit::texmap;

const RightTriangle kUnit{{0, 0}, 1, 1};

// ---- Costs

void print_costs() {
  std::printf("operations and memory%39s %8s %6s\n", "bytes kept for a triangle", "of float", "double");
  const auto sample = make_case<double>(Hardness::kNone, 0);
  using Vec = glm::vec<3, CountingNumber>;
  const Triangle3<CountingNumber> t{Vec(sample.triangle.a), Vec(sample.triangle.b), Vec(sample.triangle.c)};
  const Vec hit(sample.hit);
  const auto print = [](std::string_view name, const OperationCounts& once, const OperationCounts& each,
                        std::size_t of_float, std::size_t of_double) {
    std::printf("  %-20.*s prepare %2d * %2d /   hit %2d * %2d / %d sqrt %8zu %6zu\n",
                static_cast<int>(name.size()), name.data(), once.multiplications, once.divisions,
                each.multiplications, each.divisions, each.square_roots, of_float, of_double);
  };
  const auto print_map = [&]<class Map>() {
    typename Map::template Prepared<CountingNumber> prepared;
    const OperationCounts once = count_operations([&] { prepared = Map::prepare(t, kUnit); });
    const OperationCounts each = count_operations([&] { Map::map(prepared, t, kUnit, hit); });
    print(Map::kName, once, each, kept_bytes<Map, float>(), kept_bytes<Map, double>());
  };
  const auto print_all = [&]<class... Maps>(std::tuple<Maps...>) {
    (print_map.template operator()<Maps>(), ...);
  };
  print_all(TriangleMaps{});
  print("area-ratio-once", {}, count_operations([&] { area_ratio_map(t, kUnit, hit); }), 0, 0);
  std::printf("  and for a texture's right triangle %zu bytes\n\n", sizeof(RightTriangle));
}

// ---- Times

template <class Real>
bench::Comparison compare_times(const char* name) {
  constexpr std::size_t kPairs = 1024;  // fit into the first cache, whatever is kept
  // Many short runs: on a machine that others use too, most of them are left alone.
  constexpr std::uint64_t kCalls = 20;
  constexpr int kRounds = 301;
  static std::vector<MapCase<Real>> samples;
  for (std::uint64_t i = 0; i < kPairs; ++i) samples.push_back(make_case<Real>(Hardness::kNone, i));
  static glm::dvec2 sum;
  const auto check = [] { return std::isfinite(sum.x + sum.y) ? std::string() : "the sum is not finite"; };
  std::vector<bench::Contender> contenders;
  const auto add = [&](std::string_view method, auto&& map) {
    contenders.push_back({std::string(method),
                          [map] {
                            glm::vec<2, Real> total(0);
                            for (std::size_t i = 0; i < kPairs; ++i) total += map(i);
                            sum = glm::dvec2(total);
                            bench::keep(sum);
                          },
                          check,
                          {},
                          kCalls});
  };
  const auto add_map = [&]<class Map>() {
    std::vector<typename Map::template Prepared<Real>> prepared;
    prepared.reserve(kPairs);
    for (const MapCase<Real>& sample : samples) prepared.push_back(Map::prepare(sample.triangle, kUnit));
    add(Map::kName, [prepared](std::size_t i) {
      return Map::map(prepared[i], samples[i].triangle, kUnit, samples[i].hit);
    });
  };
  const auto add_all = [&]<class... Maps>(std::tuple<Maps...>) {
    (add_map.template operator()<Maps>(), ...);
  };
  add_all(TriangleMaps{});
  add("area-ratio-once",
      [](std::size_t i) { return area_ratio_map(samples[i].triangle, kUnit, samples[i].hit); });
  // Where a ray tracer has a and c already; any two numbers of the hit stand for them.
  add("area-ratio-known", [](std::size_t i) {
    return glm::vec<2, Real>(area_ratio_map(kUnit, samples[i].hit.x, samples[i].hit.y));
  });
  std::rotate(contenders.begin(), contenders.begin() + 4, contenders.begin() + 5);  // ratios to the default
  bench::Comparison comparison = bench::compare(name, contenders, kRounds);
  for (bench::Result& result : comparison.results) {
    for (double* seconds : {&result.seconds.median, &result.seconds.min, &result.seconds.max})
      *seconds /= static_cast<double>(kPairs);
  }
  return comparison;
}

// ---- Stability

std::string seconds_since(const std::chrono::steady_clock::time_point& start) {
  char text[32];
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::snprintf(text, sizeof text, "%.0f s", elapsed.count());
  return text;
}

void print_stability(const char* type, const bench::StabilityRecord& record) {
  std::printf("\n%s: not finite + wrong, largest error\n  %-20s", type, "");
  for (const std::string_view name : bench::kMapNames)
    std::printf(" %21.*s", static_cast<int>(name.size()), name.data());
  std::printf("  steps\n");
  for (std::size_t kind = 0; kind < record.size(); ++kind) {
    const std::string_view name = kHardnessNames[kind];
    std::printf("  %-20.*s", static_cast<int>(name.size()), name.data());
    double steps = 0;
    for (std::size_t row = 0; row < bench::kMapNames.size(); ++row) {
      const bench::MapRecord& map = record[kind].maps[row];
      char text[64];
      std::snprintf(text, sizeof text, "%llu+%llu %.1e", static_cast<unsigned long long>(map.not_finite),
                    static_cast<unsigned long long>(map.wrong), map.largest);
      std::printf(" %21s", text);
      if (bench::is_default_map(row)) steps = std::max(steps, map.steps);
    }
    std::printf("  %.2f\n", steps);
  }
}

std::string csv_of(const char* type, const bench::StabilityRecord& record) {
  std::string csv;
  for (std::size_t kind = 0; kind < record.size(); ++kind) {
    for (std::size_t row = 0; row < bench::kMapNames.size(); ++row) {
      const bench::MapRecord& map = record[kind].maps[row];
      char numbers[256];
      std::snprintf(numbers, sizeof numbers, ",%llu,%llu,%llu,%llu,%.2e,%.2e,%.3e,%.3g\n",
                    static_cast<unsigned long long>(map.pairs),
                    static_cast<unsigned long long>(record[kind].without_area),
                    static_cast<unsigned long long>(map.not_finite),
                    static_cast<unsigned long long>(map.wrong), map.median, map.percentile99, map.largest,
                    map.steps);
      csv += std::string(type) + ',' + std::string(kHardnessNames[kind]) + ',' +
             std::string(bench::kMapNames[row]) + numbers;
    }
  }
  return csv;
}

// Does the default keep its promise? One line for each fault.
int report_faults(const char* type, const bench::StabilityRecord& record) {
  int faults = 0;
  for (std::size_t kind = 0; kind < record.size(); ++kind) {
    for (std::size_t row = 0; row < bench::kMapNames.size(); ++row) {
      const bench::MapRecord& map = record[kind].maps[row];
      if (!bench::is_default_map(row) || (map.not_finite == 0 && map.wrong == 0)) continue;
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
  for (const bench::Comparison& times : {compare_times<double>("double"), compare_times<float>("float")})
    std::fputs(bench::to_table(times).c_str(), stdout);

  const std::uint64_t each = (options.pairs + kHardnessNames.size() - 1) / kHardnessNames.size();
  const auto start = std::chrono::steady_clock::now();
  const bench::StabilityRecord of_double = bench::measure_stability<double>(each, options.threads);
  const bench::StabilityRecord of_float = bench::measure_stability<float>(each, options.threads);
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
