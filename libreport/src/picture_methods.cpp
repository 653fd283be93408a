// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "picture_methods.hpp"

#include <cstdio>

namespace sweepkit::report {
namespace {

PictureMethod adaptive(const std::string& filter, render::Options options, double contrast) {
  char setting[32];
  std::snprintf(setting, sizeof setting, "adaptive %g", contrast);
  options.adaptive = render::Adaptive{.contrast = contrast};
  return {filter, "adaptive", setting, options};
}

}  // namespace

render::Options plain_options(int side) {
  return {.filter = render::Filter::kPoint,
          .supersampling = side,
          .shadows = render::Shadows::kHard,
          .threads = 1};
}

std::vector<PictureMethod> picture_methods(bool is_quick) {
  using render::Filter;
  struct Kind {
    std::string name;
    Filter filter;
    render::Footprint footprint = render::Footprint::kAuto;
  };
  const std::vector<Kind> kinds = {{"point", Filter::kPoint},
                                   {"bilinear", Filter::kBilinear},
                                   {"trilinear", Filter::kTrilinear},
                                   {"the paper's box", Filter::kIntegral1, render::Footprint::kNeighbours},
                                   {"integral-1", Filter::kIntegral1},
                                   {"integral-2", Filter::kIntegral2},
                                   {"integral-3", Filter::kIntegral3},
                                   {"ewa", Filter::kEwa},
                                   {"auto", Filter::kAuto}};
  std::vector<PictureMethod> all;
  for (const Kind& kind : kinds) {
    // What differs least from its neighbours, or is slowest, waits for the full run.
    const bool is_in_quick = kind.filter != Filter::kBilinear && kind.filter != Filter::kIntegral2 &&
                             kind.filter != Filter::kIntegral3;
    if (is_quick && !is_in_quick) continue;
    render::Options options{.filter = kind.filter, .footprint = kind.footprint, .threads = 1};
    all.push_back({kind.name, "off", "off", options});
    options.supersampling = 3;
    all.push_back({kind.name, "3x3", "3x3", options});
    options.supersampling = 1;
    for (const double contrast : {0.24, 0.12, 0.06, 0.03, 0.02, 0.01}) {
      // The thresholds of the program's own filter are turned more finely.
      const bool is_coarse = contrast == 0.03 || (contrast == 0.12 && !is_quick);
      if (kind.filter != Filter::kAuto && !is_coarse) continue;
      all.push_back(adaptive(kind.name, options, contrast));
    }
  }
  for (int side = 1; side <= (is_quick ? 8 : 16); side *= 2) {
    all.push_back({"plain", "plain", std::to_string(side * side) + " samples", plain_options(side)});
  }
  return all;
}

}  // namespace sweepkit::report
