// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "texture_repeats.hpp"

#include <algorithm>
#include <cmath>

#include "number_text.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

double repeats(Extent extent, double size) {
  const double fitting = extent.length / size;
  return extent.is_closed ? std::max(1.0, std::nearbyint(fitting)) : fitting;
}

}  // namespace

UvOptions with_repeats(const UvOptions& uv, Extent u, Extent v) {
  UvOptions fitted = uv;
  if (uv.size) fitted.repeat = {repeats(u, uv.size->x), repeats(v, uv.size->y)};
  fitted.size.reset();
  return fitted;
}

void check_texture(const UvOptions& uv) {
  if (!std::isfinite(uv.repeat.x) || !std::isfinite(uv.repeat.y)) {
    throw InputError("uv repeat needs two finite numbers, got " + number_text(uv.repeat.x) + " and " +
                     number_text(uv.repeat.y));
  }
  if (uv.size &&
      !(uv.size->x > 0 && uv.size->y > 0 && std::isfinite(uv.size->x) && std::isfinite(uv.size->y))) {
    throw InputError("uv size needs two lengths above 0 m, got " + number_text(uv.size->x) + " and " +
                     number_text(uv.size->y));
  }
}

}  // namespace sweepkit::sweep
