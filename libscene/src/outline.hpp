// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <initializer_list>
#include <optional>
#include <vector>

#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::scene {

/// A subpath on its way to a curve: segments end to end, not empty.
struct Outline {
  std::vector<sweep::Segment<2>> segments;
  bool is_closed = false;  ///< drawn so, or its ends coincide
};

/// Joins the end to the start by a straight line, where they do not meet.
void close(Outline& outline);

/// Exact: an affine map of an arc of an ellipse is one.
void transform(Outline& outline, const glm::dmat3& map);

/// The same run through from its end to its start.
Outline reversed(const sweep::Curve2& curve);

/// More would take gigabytes.
inline constexpr std::size_t kMostSegments = 500'000;

/// Follows a pen as SVG's path commands lead it, coordinates absolute. Subpaths of one point, and steps too
/// short to have a direction, are left out. Throws InputError beyond kMostSegments, and for coordinates
/// beyond 1e100, whose squares could overflow.
class OutlineBuilder {
 public:
  /// An arc of an ellipse as SVG gives it.
  struct Arc {
    glm::dvec2 radii;
    double x_axis_deg;  ///< of the ellipse's x axis
    bool is_large;      ///< the longer way round
    bool is_positive;   ///< by growing angles, from +x to +y
  };

  void move_to(const glm::dvec2& to);
  void line_to(const glm::dvec2& to);
  void quadratic_to(const glm::dvec2& control, const glm::dvec2& to);
  void cubic_to(const glm::dvec2& first, const glm::dvec2& second, const glm::dvec2& to);
  void arc_to(const Arc& arc, const glm::dvec2& to);
  void close_subpath();
  /// A whole ellipse, closed, from +x by growing angles.
  void ellipse(const glm::dvec2& center, const glm::dvec2& radii);

  std::vector<Outline> take();

 private:
  static void check(std::initializer_list<glm::dvec2> points);
  void add(sweep::Segment<2> segment, const glm::dvec2& to);
  void finish();

  std::vector<Outline> outlines_;
  Outline open_;
  glm::dvec2 start_{0.0};  // of the subpath
  glm::dvec2 at_{0.0};
  std::size_t segments_ = 0;
};

}  // namespace sweepkit::scene
