// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "sweepkit/sweep/options.hpp"

namespace sweepkit::sweep {

/// How long a surface is along u or v, metres, and whether it comes home there.
struct Extent {
  double length;
  bool is_closed;
};

/// `uv` with its size made repeats.
UvOptions with_repeats(const UvOptions& uv, Extent u, Extent v);

/// Throws InputError unless both repeats are finite, and sizes above 0.
void check_texture(const UvOptions& uv);

}  // namespace sweepkit::sweep
