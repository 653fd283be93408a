// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "triangle_map_costs.hpp"

namespace sweepkit::report {
namespace {

using namespace texmap;

const RightTriangle kUnit{{0, 0}, 1, 1};
constexpr std::size_t kPairs = 1024;

template <class Map>
MapCost cost_of(const Triangle3<CountingNumber>& t, const glm::vec<3, CountingNumber>& hit) {
  typename Map::template Prepared<CountingNumber> prepared;
  MapCost cost;
  cost.prepare = count_operations([&] { prepared = Map::prepare(t, kUnit); });
  cost.hit = count_operations([&] { Map::map(prepared, t, kUnit, hit); });
  cost.float_bytes = kept_bytes<Map, float>();
  cost.double_bytes = kept_bytes<Map, double>();
  return cost;
}

// The calls that are timed, and what they work on.
template <class Real>
class Calls {
 public:
  explicit Calls(const CaseMaker<Real>& make) {
    for (std::uint64_t i = 0; i < kPairs; ++i) cases_.push_back(make(i));
    const auto add_all = [&]<class... Maps>(std::tuple<Maps...>) { (add<Maps>(), ...); };
    add_all(TriangleMaps{});
    // Nothing is prepared for the last.
    hit_.emplace_back(
        sum([this](std::size_t i) { return area_ratio_map(cases_[i].triangle, kUnit, cases_[i].hit); }));
  }
  Calls(const Calls&) = delete;
  Calls& operator=(const Calls&) = delete;

  std::vector<std::function<void()>> all() const {
    std::vector<std::function<void()>> calls = hit_;
    calls.insert(calls.end(), prepare_.begin(), prepare_.end());
    return calls;
  }

 private:
  template <class Function>
  static std::function<void()> sum(Function map) {
    return [map] {
      glm::vec<2, Real> total(0);
      for (std::size_t i = 0; i < kPairs; ++i) total += map(i);
      keep(total);
    };
  }
  template <class Map>
  void add() {
    using Prepared = typename Map::template Prepared<Real>;
    auto prepared = std::make_shared<std::vector<Prepared>>();
    for (const MapCase<Real>& one : cases_) prepared->push_back(Map::prepare(one.triangle, kUnit));
    hit_.emplace_back(sum([this, prepared](std::size_t i) {
      return Map::map((*prepared)[i], cases_[i].triangle, kUnit, cases_[i].hit);
    }));
    prepare_.emplace_back([this, prepared] {
      for (std::size_t i = 0; i < kPairs; ++i) (*prepared)[i] = Map::prepare(cases_[i].triangle, kUnit);
      keep(*prepared);
    });
  }

  std::vector<MapCase<Real>> cases_;
  std::vector<std::function<void()>> hit_, prepare_;
};

}  // namespace

std::array<MapCost, kMapNames.size()> map_costs() {
  const auto sample = make_case<double>(Hardness::kNone, 0);
  using Vec = glm::vec<3, CountingNumber>;
  const Triangle3<CountingNumber> t{Vec(sample.triangle.a), Vec(sample.triangle.b), Vec(sample.triangle.c)};
  const Vec hit(sample.hit);
  const auto of_all = [&]<class... Maps>(std::tuple<Maps...>) {
    return std::array{cost_of<Maps>(t, hit)...,
                      MapCost{.hit = count_operations([&] { area_ratio_map(t, kUnit, hit); })}};
  };
  return of_all(TriangleMaps{});
}

template <class Real>
MapTimings time_maps(const CaseMaker<Real>& make, const Effort& effort) {
  const Calls<Real> calls(make);
  const std::vector<Timing> timings = time_in_turn(calls.all(), effort);
  MapTimings found;
  for (std::size_t row = 0; row < kMapNames.size(); ++row) {
    found.hit[row] = timings[row].of_each(kPairs);
    if (row + 1 < kMapNames.size()) found.prepare[row] = timings[kMapNames.size() + row].of_each(kPairs);
  }
  return found;
}

template MapTimings time_maps(const CaseMaker<float>&, const Effort&);
template MapTimings time_maps(const CaseMaker<double>&, const Effort&);

}  // namespace sweepkit::report
