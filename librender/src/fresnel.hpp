// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "sweepkit/scene/material.hpp"

namespace sweepkit::render {

/// The cosine on the far side of a boundary by Snell's law, 0 from the critical angle on. `cosine` is that
/// of the ray that arrives, 0 to 1; `eta` is the index on its side over the one beyond.
inline double refracted_cosine(double cosine, double eta) {
  return std::sqrt(std::max(0.0, 1 - eta * eta * (1 - cosine) * (1 + cosine)));
}

/// The share that a boundary between two clear media mirrors of unpolarized light. By Fresnel's equations;
/// `beyond` is refracted_cosine(). 1 from the critical angle on.
///   r_s = (eta c - b) / (eta c + b),   r_p = (c - eta b) / (c + eta b),   F = (r_s^2 + r_p^2) / 2
inline double fresnel_exact(double cosine, double beyond, double eta) {
  if (eta == 1) return 0;  // no boundary
  if (!(beyond > 0)) return 1;
  const double s = (eta * cosine - beyond) / (eta * cosine + beyond);
  const double p = (cosine - eta * beyond) / (cosine + eta * beyond);
  return 0.5 * (s * s + p * p);
}

/// The same by Schlick's polynomial in the cosine on the thinner side [Schlick94].
///   F = F0 + (1 - F0) (1 - c)^5,   F0 = ((eta - 1) / (eta + 1))^2
inline double fresnel_schlick(double cosine, double beyond, double eta) {
  if (eta == 1) return 0;
  if (!(beyond > 0)) return 1;
  const double root = (eta - 1) / (eta + 1);
  const double f0 = root * root;
  const double x = 1 - (eta > 1 ? beyond : cosine);
  return f0 + (1 - f0) * (x * x) * (x * x) * x;
}

}  // namespace sweepkit::render
