// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <utility>

#include "ray.hpp"

namespace sweepkit::render {

/// Watertight ray-triangle test, based on Woop, Benthin, Wald, "Watertight ray/triangle intersection", JCGT 2
/// (2013): the ray is sheared to the z axis, so that an edge function depends on the edge's two vertices
/// alone and is exactly the negative seen from the other side of the edge. Departs from it in working in
/// double throughout on the float32 vertices, which makes its fallback needless, and in accepting an edge
/// function of 0 (a ray that meets an edge exactly hits both triangles; Hit::is_before chooses).
class ShearedRay {
 public:
  explicit ShearedRay(const Ray& ray) : origin_(ray.origin) {
    const glm::dvec3 size = glm::abs(ray.direction);
    z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    x_ = (z_ + 1) % 3;
    y_ = (x_ + 1) % 3;
    if (ray.direction[z_] < 0) std::swap(x_, y_);  // keeps the winding
    shear_x_ = ray.direction[x_] / ray.direction[z_];
    shear_y_ = ray.direction[y_] / ray.direction[z_];
    scale_z_ = 1 / ray.direction[z_];
  }

  /// Writes t and (a, b, c) and returns true if the ray meets the triangle at 0 < t <= end. NaN fails.
  bool meets(const glm::vec3& va, const glm::vec3& vb, const glm::vec3& vc, double end, Hit& hit) const {
    const glm::dvec3 a = glm::dvec3(va) - origin_;
    const glm::dvec3 b = glm::dvec3(vb) - origin_;
    const glm::dvec3 c = glm::dvec3(vc) - origin_;
    const double ax = a[x_] - shear_x_ * a[z_];
    const double ay = a[y_] - shear_y_ * a[z_];
    const double bx = b[x_] - shear_x_ * b[z_];
    const double by = b[y_] - shear_y_ * b[z_];
    const double cx = c[x_] - shear_x_ * c[z_];
    const double cy = c[y_] - shear_y_ * c[z_];
    const double u = cx * by - cy * bx;
    const double v = ax * cy - ay * cx;
    const double w = bx * ay - by * ax;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
    const double determinant = u + v + w;
    if (determinant == 0) return false;
    const double t = scale_z_ * (u * a[z_] + v * b[z_] + w * c[z_]) / determinant;
    if (!(t > 0 && t <= end)) return false;
    hit.t = t;
    hit.a = u / determinant;
    hit.b = v / determinant;
    hit.c = w / determinant;
    return true;
  }

 private:
  glm::dvec3 origin_;
  int x_, y_, z_;
  double shear_x_, shear_y_, scale_z_;
};

}  // namespace sweepkit::render
