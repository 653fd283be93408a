// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "triangle_map_errors.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <memory>
#include <thread>
#include <vector>

#include "sweepkit/texmap/triangle_maps.hpp"

namespace sweepkit::report {
namespace {

using namespace texmap;

// Errors by their exponent and two bits more, which is what the top of a double's own bits says.
constexpr int kBinShift = 50;
constexpr std::size_t kBins = std::size_t{0x7FF0000000000000u >> kBinShift} + 1;

struct Tally {
  std::uint64_t not_finite = 0;
  std::uint64_t wrong = 0;
  double largest = 0;
  double steps = 0;
  std::vector<std::uint64_t> bins = std::vector<std::uint64_t>(kBins);

  void add(double error, double conditioning, double leeway, double epsilon, bool is_default) {
    ++bins[std::bit_cast<std::uint64_t>(error) >> kBinShift];
    largest = std::max(largest, error);
    const double granted = is_default ? 0 : leeway + 8 * epsilon;
    if (error > granted) steps = std::max(steps, (error - granted) / (epsilon * conditioning));
    if (error > granted + 8 * epsilon * conditioning) ++wrong;
  }
  void merge(const Tally& other) {
    not_finite += other.not_finite;
    wrong += other.wrong;
    largest = std::max(largest, other.largest);
    steps = std::max(steps, other.steps);
    for (std::size_t i = 0; i < kBins; ++i) bins[i] += other.bins[i];
  }
  // The middle of the bin that holds this share.
  double quantile(double share) const {
    std::uint64_t all = 0;
    for (const std::uint64_t count : bins) all += count;
    std::uint64_t left = static_cast<std::uint64_t>(share * static_cast<double>(all));
    for (std::size_t i = 0; i < kBins; ++i) {
      if (left < bins[i])
        return i == 0 ? 0 : std::bit_cast<double>((2 * std::uint64_t{i} + 1) << (kBinShift - 1));
      left -= bins[i];
    }
    return 0;
  }
};

struct KindTally {
  std::uint64_t without_area = 0;
  std::uint64_t not_dominant = 0;
  std::array<Tally, kMapNames.size()> maps;

  void merge(const KindTally& other) {
    without_area += other.without_area;
    not_dominant += other.not_dominant;
    for (std::size_t i = 0; i < maps.size(); ++i) maps[i].merge(other.maps[i]);
  }
};

// What a method should give: (c, a), or for the doubled vertex (c / (1 - a), a), whose first is as far off as
// c and a are, over 1 - a.
struct Target {
  Quad u, v;
  glm::dvec2 conditioning, leeway;
};

Target target_of(const ExactMap& exact, bool is_doubled) {
  Target target{
      exact.c, exact.a, {exact.conditioning_c, exact.conditioning_a}, {exact.leeway_c, exact.leeway_a}};
  if (!is_doubled) return target;
  const Quad rest = 1 - exact.a;
  const double share = std::abs(static_cast<double>(rest));
  target.u = exact.c / rest;
  const double s = std::abs(static_cast<double>(target.u));
  target.conditioning.x = (exact.conditioning_c + s * exact.conditioning_a) / share;
  target.leeway.x = (exact.leeway_c + s * exact.leeway_a) / share;
  return target;
}

template <class Real>
void measure(const CaseMaker<Real>& make, std::uint64_t first, std::uint64_t end, KindTally& tally) {
  static const RightTriangle kUnit{{0, 0}, 1, 1};
  constexpr double kStep = kEpsilon<Real>;
  for (std::uint64_t number = first; number < end; ++number) {
    const MapCase<Real> sample = make(number);
    const auto prepared = AreaRatioMap::prepare(sample.triangle, kUnit);
    const ExactMap exact = exact_map(sample, prepared.i, prepared.j);
    tally.without_area += exact.has_area ? 0 : 1;
    tally.not_dominant += exact.has_area && !exact.is_dominant ? 1 : 0;
    std::size_t row = 0;
    const auto judge = [&](const glm::vec<2, Real>& mapped, bool is_doubled = false) {
      Tally& of = tally.maps[row];
      const bool is_default = is_default_map(row);
      ++row;
      if (!std::isfinite(mapped.x) || !std::isfinite(mapped.y)) {
        ++of.not_finite;
      } else if (exact.has_area) {
        const Target target = target_of(exact, is_doubled);
        const auto error_of = [](Real value, Quad truth) {
          return std::abs(static_cast<double>(value - truth));
        };
        const double u = error_of(mapped.x, target.u);
        const double v = error_of(mapped.y, target.v);
        // Of the two the one that is worse for its conditioning.
        const bool is_u = u * target.conditioning.y > v * target.conditioning.x;
        if (is_u) {
          of.add(u, target.conditioning.x, target.leeway.x, kStep, is_default);
        } else {
          of.add(v, target.conditioning.y, target.leeway.y, kStep, is_default);
        }
      }
    };
    const auto judge_all = [&]<class... Maps>(std::tuple<Maps...>) {
      (judge(map_once<Maps>(sample.triangle, kUnit, sample.hit), std::is_same_v<Maps, DoubledVertexMap>),
       ...);
    };
    judge_all(TriangleMaps{});
    judge(area_ratio_map(sample.triangle, kUnit, sample.hit));
  }
}

}  // namespace

template <class Real>
KindRecord measure_map_errors(const CaseMaker<Real>& make, std::uint64_t pairs, unsigned threads) {
  constexpr std::uint64_t kPiece = 1 << 14;
  std::vector<std::unique_ptr<KindTally>> tallies;
  for (unsigned i = 0; i < threads; ++i) tallies.push_back(std::make_unique<KindTally>());
  std::atomic<std::uint64_t> next = 0;
  {
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < threads; ++i) {
      workers.emplace_back([&, own = tallies[i].get()] {
        for (std::uint64_t first = kPiece * next++; first < pairs; first = kPiece * next++)
          measure<Real>(make, first, std::min(pairs, first + kPiece), *own);
      });
    }
  }
  KindTally& tally = *tallies[0];
  for (unsigned i = 1; i < threads; ++i) tally.merge(*tallies[i]);
  KindRecord record{pairs, tally.without_area, tally.not_dominant, {}};
  for (std::size_t row = 0; row < kMapNames.size(); ++row) {
    const Tally& of = tally.maps[row];
    record.maps[row] = {pairs,      of.not_finite, of.wrong, of.quantile(0.5), of.quantile(0.99),
                        of.largest, of.steps};
  }
  return record;
}

template KindRecord measure_map_errors(const CaseMaker<float>&, std::uint64_t, unsigned);
template KindRecord measure_map_errors(const CaseMaker<double>&, std::uint64_t, unsigned);

}  // namespace sweepkit::report
