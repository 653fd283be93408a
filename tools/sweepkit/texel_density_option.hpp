// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "sweepkit/scene/texel_density.hpp"

namespace sweepkit::tools {

/// --texel-density, of generate and of bake.
inline CLI::Option* add_texel_density(CLI::App& sub, std::optional<double>& density) {
  return sub
      .add_option(
          "--texel-density", density,
          "Texels a metre of the surface in the image that a procedural texture becomes; at most 8192 "
          "on a side")
      ->type_name("N")
      ->check(CLI::Range(scene::kLeastDensity, scene::kMostDensity));
}

}  // namespace sweepkit::tools
