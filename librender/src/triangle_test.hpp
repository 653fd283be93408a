// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "ray.hpp"
#include "sweepkit/scene/scene.hpp"
#include "triangle_intersection.hpp"

namespace sweepkit::render {

inline bool test_triangle(const scene::MeshView& mesh, const ShearedRay& ray, std::uint32_t triangle,
                          double end, Hit& hit) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return ray.meets(mesh.positions[a], mesh.positions[b], mesh.positions[c], end, hit);
}

inline void keep_nearer(Hit& best, Hit found, std::uint32_t object, std::uint32_t triangle) {
  if (best.is_hit() && best.is_before(found.t, object, triangle)) return;
  found.object = object;
  found.triangle = triangle;
  best = found;
}

}  // namespace sweepkit::render
