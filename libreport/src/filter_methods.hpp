// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "sweepkit/texmap/texture_sampler.hpp"
#include "texture_peer.hpp"

namespace sweepkit::report {

/// One of our filters with its knob: so many lookups spread evenly over the pixel each way, or the footprint
/// cut into at most so many along its major axis.
struct OwnLookup {
  texmap::Filter filter = texmap::Filter::kAuto;
  int samples = 1;
  int most_parts = 1;
};

struct FilterMethod {
  std::string name;
  std::string setting;
  std::variant<OwnLookup, PeerOptions> lookup;
};

/// Every filter with its knob through its range; a few settings each where `is_quick`. OpenImageIO's come
/// last, and only where `has_peer`.
std::vector<FilterMethod> filter_methods(bool is_quick, bool has_peer);

float look_up(const texmap::TextureSampler& sampler, const OwnLookup& how, const texmap::Footprint& footprint,
              texmap::FilterThread& thread);

}  // namespace sweepkit::report
