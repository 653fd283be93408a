// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "filter_methods.hpp"

#include <array>

namespace sweepkit::report {
namespace {

constexpr int kMostParts = 8;

std::string sampled(int n) {
  return n == 1 ? "once" : std::to_string(n) + " x " + std::to_string(n) + " samples";
}
std::string cut(int parts) {
  return parts == 1 ? "whole" : "cut into " + std::to_string(parts);
}

}  // namespace

std::vector<FilterMethod> filter_methods(bool is_quick, bool has_peer) {
  using texmap::Filter;
  using Interpolation = PeerOptions::Interpolation;
  std::vector<FilterMethod> methods;
  const std::vector<int> samples = is_quick ? std::vector{1, 3} : std::vector{1, 2, 4, 6};
  const std::vector<int> parts = is_quick ? std::vector{1, 4} : std::vector{1, 2, 4, kMostParts};
  const std::vector<int> anisotropies = is_quick ? std::vector{1, 16} : std::vector{1, 4, 16, 64};
  for (const Filter filter : {Filter::kPoint, Filter::kBilinear}) {
    for (const int n : samples)
      methods.push_back({std::string(texmap::filter_name(filter)), sampled(n), OwnLookup{filter, n, 1}});
  }
  for (const Filter filter :
       {Filter::kTrilinear, Filter::kIntegral1, Filter::kIntegral2, Filter::kIntegral3}) {
    for (const int most : parts) {
      if (is_quick && filter == Filter::kIntegral3 && most > 1) continue;  // the slowest of all
      methods.push_back({std::string(texmap::filter_name(filter)), cut(most), OwnLookup{filter, 1, most}});
    }
  }
  for (const Filter filter : {Filter::kEwa, Filter::kAuto, Filter::kBox})
    methods.push_back({std::string(texmap::filter_name(filter)), cut(1), OwnLookup{filter, 1, 1}});
  if (!has_peer) return methods;
  for (const auto& [name, interpolation] :
       {std::pair("OpenImageIO smart bicubic", Interpolation::kSmartBicubic),
        std::pair("OpenImageIO bicubic", Interpolation::kBicubic),
        std::pair("OpenImageIO bilinear", Interpolation::kBilinear)}) {
    if (is_quick && interpolation == Interpolation::kBicubic) continue;
    for (const int anisotropy : anisotropies)
      methods.push_back({name, "anisotropy " + std::to_string(anisotropy),
                         PeerOptions{.interpolation = interpolation, .anisotropy = anisotropy}});
  }
  return methods;
}

float look_up(const texmap::TextureSampler& sampler, const OwnLookup& how, const texmap::Footprint& footprint,
              texmap::FilterThread& thread) {
  if (how.samples > 1) {
    const int n = how.samples;
    float sum = 0;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const double x = (i + 0.5) / n - 0.5;
        const double y = (j + 0.5) / n - 0.5;
        const double share = 1.0 / n;
        sum += sampler
                   .sample({footprint.uv + x * footprint.dx + y * footprint.dy, share * footprint.dx,
                            share * footprint.dy},
                           thread)
                   .r;
      }
    }
    return sum / static_cast<float>(n * n);
  }
  if (how.most_parts > 1) {
    std::array<texmap::FootprintPart, kMostParts> parts;
    const int count = texmap::cut_along_major(footprint, how.most_parts, parts);
    float sum = 0;
    for (int i = 0; i < count; ++i) {
      const texmap::FootprintPart& part = parts[static_cast<std::size_t>(i)];
      sum += static_cast<float>(part.weight) * sampler.sample(part.footprint, thread).r;
    }
    return sum;
  }
  return sampler.sample(footprint, thread).r;
}

}  // namespace sweepkit::report
