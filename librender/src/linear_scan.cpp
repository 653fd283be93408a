// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "linear_scan.hpp"

#include "triangle_test.hpp"

namespace sweepkit::render {

void LinearScan::find_nearest(const Ray& ray, std::uint32_t object, Hit& best) const {
  const ShearedRay sheared(ray);
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    Hit found;
    if (test_triangle(mesh_, sheared, t, best.t, found) && !ray.leaves(object, t))
      keep_nearer(best, found, object, t);
  }
}

bool LinearScan::is_blocked(const Ray& ray, std::uint32_t object, double end) const {
  const ShearedRay sheared(ray);
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    Hit found;
    if (test_triangle(mesh_, sheared, t, end, found) && found.t < end && !ray.leaves(object, t)) return true;
  }
  return false;
}

}  // namespace sweepkit::render
