// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "ray.hpp"

namespace sweepkit::render {

/// ax * by - ay * bx to two units in the last place, however much cancels (Kahan): also its sign is right.
/// (Products below 1e-290 lose digits; float32 vertices lie no closer together than 1e-45.)
inline double accurate_cross(double ax, double ay, double bx, double by) {
  const double product = ay * bx;
  return std::fma(ax, by, -product) + std::fma(-ay, bx, product);
}

/// Watertight ray-triangle test, based on Woop, Benthin, Wald, "Watertight ray/triangle intersection", JCGT 2
/// (2013): the ray is sheared to the z axis, so that an edge function depends on the edge's two vertices
/// alone and is exactly the negative seen from the other side of the edge. Departs from it in working in
/// double throughout on the float32 vertices, and in accepting an edge function of 0 (a ray that meets an
/// edge exactly hits both triangles; Hit::is_before chooses).
///
/// Rounding keeps the order of two products, so an edge function never has the wrong sign; at worst it is 0.
/// Where a triangle is seen so much from its edge that rounding could move the point by more than 2^-26 of
/// the triangle, the edge functions are computed again without loss. So the point of whatever is accepted
/// lies on the ray and on the triangle within a few roundings and 2^-26 of the triangle's size, and a search
/// may leave out every box that the ray passes at more than that.
class ShearedRay {
 public:
  // A determinant of less than this share of the products is computed again: each edge function is wrong by
  // at most 2^-52 of its products, which are equal to as much where this matters.
  static constexpr double kLeastShare = 0x1p-25;

  explicit ShearedRay(const Ray& ray) {
    // Without branches, which nothing could predict; glm::abs() and glm's operator[] have some.
    const double* const direction = glm::value_ptr(ray.direction);
    const double size[3] = {std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2])};
    const double* const origin = glm::value_ptr(ray.origin);
    const int first = static_cast<int>(!(size[0] > size[1]));
    const int is_first = static_cast<int>(size[first] > size[2]);
    z_ = is_first * first + (1 - is_first) * 2;
    // Changing places keeps the winding.
    const int is_backward = static_cast<int>(direction[z_] < 0);
    static constexpr int kAfter[] = {1, 2, 0, 2, 0, 1};
    x_ = kAfter[z_ + 3 * is_backward];
    y_ = kAfter[z_ + 3 * (1 - is_backward)];
    origin_ = {origin[x_], origin[y_], origin[z_]};
    const Four quotients = Four{direction[x_], direction[y_], 1, 1} / direction[z_];  // for the time of one
    shear_x_ = quotients[0];
    shear_y_ = quotients[1];
    scale_z_ = quotients[2];
  }

  /// Writes t and (a, b, c) and returns true if the ray meets the triangle at 0 < t <= end. NaN fails.
  bool meets(const glm::vec3& va, const glm::vec3& vb, const glm::vec3& vc, double end, Hit& hit) const {
    const float* const pa = glm::value_ptr(va);
    const float* const pb = glm::value_ptr(vb);
    const float* const pc = glm::value_ptr(vc);
    const double az = static_cast<double>(pa[z_]) - origin_.z;
    const double bz = static_cast<double>(pb[z_]) - origin_.z;
    const double cz = static_cast<double>(pc[z_]) - origin_.z;
    const double ax = static_cast<double>(pa[x_]) - origin_.x - shear_x_ * az;
    const double ay = static_cast<double>(pa[y_]) - origin_.y - shear_y_ * az;
    const double bx = static_cast<double>(pb[x_]) - origin_.x - shear_x_ * bz;
    const double by = static_cast<double>(pb[y_]) - origin_.y - shear_y_ * bz;
    const double cx = static_cast<double>(pc[x_]) - origin_.x - shear_x_ * cz;
    const double cy = static_cast<double>(pc[y_]) - origin_.y - shear_y_ * cz;
    double u = cx * by - cy * bx;
    double v = ax * cy - ay * cx;
    double w = bx * ay - by * ax;
    if (has_both_signs(u, v, w)) return false;
    double determinant = u + v + w;
    const double products = std::abs(cx * by) + std::abs(ax * cy) + std::abs(bx * ay);
    if (std::abs(determinant) < kLeastShare * products) {
      u = accurate_cross(cx, cy, bx, by);
      v = accurate_cross(ax, ay, cx, cy);
      w = accurate_cross(bx, by, ax, ay);
      if (has_both_signs(u, v, w)) return false;
      determinant = u + v + w;
    }
    if (determinant == 0) return false;
    const double t = scale_z_ * (u * az + v * bz + w * cz) / determinant;
    if (!(t > 0 && t <= end)) return false;
    hit.t = t;
    hit.a = u / determinant;
    hit.b = v / determinant;
    hit.c = w / determinant;
    return true;
  }

  /// The axes: z is the one that the ray follows most.
  int x() const { return x_; }
  int y() const { return y_; }
  int z() const { return z_; }
  double shear_x() const { return shear_x_; }
  double shear_y() const { return shear_y_; }

 private:
  using Four = double __attribute__((vector_size(32)));

  static bool has_both_signs(double u, double v, double w) {
    // By bits: which of them is below 0 cannot be predicted, that hardly ever both are can.
    const int is_below = int(u < 0) | int(v < 0) | int(w < 0);
    const int is_above = int(u > 0) | int(v > 0) | int(w > 0);
    return (is_below & is_above) != 0;
  }

  glm::dvec3 origin_;  // permuted
  int x_, y_, z_;
  double shear_x_, shear_y_, scale_z_;
};

}  // namespace sweepkit::render
