// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>

#include "sweepkit/scene/check.hpp"

namespace sweepkit::scene {
namespace {

// Three numbers of the file, each rounded to float32: 0.92 and 0.08 come to 1.
constexpr double kRounding = 1e-6;

// As it stood in the file: 0.22 and not 0.2199999988079071.
std::string as_written(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace

std::vector<MaterialFinding> check_materials(const Document& document) {
  std::vector<MaterialFinding> findings;
  for (std::size_t i = 0; i < document.materials.size(); ++i) {
    const Material& material = document.materials[i];
    const double diffuse = std::max({material.diffuse.r, material.diffuse.g, material.diffuse.b});
    const double reflect = material.reflect;
    const double transmit = material.transmit;
    const bool has_fresnel = material.fresnel != Fresnel::kNone;
    // Fresnel's F goes to one and 1 - F to the other.
    const double sum = diffuse + (has_fresnel ? std::max(reflect, transmit) : reflect + transmit);
    if (!(sum > 1 + kRounding)) continue;
    const std::string terms =
        "diffuse " + as_written(diffuse) +
        (has_fresnel ? " and the larger of reflect " + as_written(reflect) + " and transmit "
                     : ", reflect " + as_written(reflect) + " and transmit ") +
        as_written(transmit);
    findings.push_back({material.name, document.material_places[i], sum,
                        terms + " come to " + as_written(sum) + ": more light than falls on it",
                        as_written(1 / sum) + " times each of them fits"});
  }
  return findings;
}

}  // namespace sweepkit::scene
