// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

namespace sweepkit::sweep {

template <int D>
using Vector = glm::vec<D, double>;

/// A point of a curve and its first three derivatives by the segment's own parameter t in [0, 1].
template <int D>
struct CurvePoint {
  Vector<D> position;
  Vector<D> first;
  Vector<D> second;
  Vector<D> third;
};

/// Bezier segment of any degree from 1: control.size() == degree + 1. Degree 1 is a straight line.
template <int D>
struct BezierSegment {
  std::vector<Vector<D>> control;
};

/// center + cos(a) x_axis + sin(a) y_axis + t rise, a from `from_deg` to `to_deg`: an arc of a circle or an
/// ellipse, or a helix. Whole quarter turns are exact.
template <int D>
struct ArcSegment {
  Vector<D> center;
  Vector<D> x_axis;
  Vector<D> y_axis;
  double from_deg;
  double to_deg;
  Vector<D> rise{0.0};
};

/// ((R + r cos qs) cos ps, r sin qs, -(R + r cos qs) sin ps), s from 0 to 2 pi: p times about the axis +Y, q
/// times through the hole.
struct TorusKnotSegment {
  int p, q;
  double radius;  ///< R, of the torus
  double tube;    ///< r, of its tube
};

template <int D>
using Segment = std::conditional_t<D == 3, std::variant<BezierSegment<D>, ArcSegment<D>, TorusKnotSegment>,
                                   std::variant<BezierSegment<D>, ArcSegment<D>>>;

template <int D>
CurvePoint<D> evaluate(const Segment<D>& segment, double t);

/// The unit direction of travel at t; at a cusp or a repeated control point its limit (from the left at t =
/// 1, from the right at t = 0, from either at a cusp between), never NaN for a segment of positive length.
template <int D>
Vector<D> tangent(const Segment<D>& segment, double t);

/// A point of a curve named by its segment and the segment's own parameter in [0, 1].
struct CurveLocation {
  std::size_t segment = 0;
  double t = 0;
};

/// Smooth segments joined end to end, measured by arc length (relative error below 1e-9).
/// Corners - joints where the direction jumps - are kept and known. A plane Bezier segment that turns back in
/// a cusp is kept as two, with a corner between them.
template <int D>
class Curve {
 public:
  /// Throws InputError when there is no segment, a coordinate is not finite, neighbours do not meet, or the
  /// length is zero. A curve is closed if its ends coincide.
  explicit Curve(std::vector<Segment<D>> segments);

  std::span<const Segment<D>> segments() const { return segments_; }
  bool is_closed() const { return is_closed_; }
  double length() const { return end_lengths_.back(); }
  /// Arc length from the curve's start to the end of each segment.
  std::span<const double> end_lengths() const { return end_lengths_; }
  /// Is the joint at the start of this segment a corner? For segment 0: of a closed curve's seam; false on an
  /// open one.
  bool is_corner(std::size_t segment) const { return corner_at_start_[segment]; }

  CurvePoint<D> evaluate(CurveLocation location) const;
  Vector<D> tangent(CurveLocation location) const;
  /// The location at `length` from the start, clamped to 0 <= length <= length().
  CurveLocation locate(double length) const;

 private:
  // A stretch of a segment short enough for one Gauss-Legendre rule.
  struct Stretch {
    std::size_t segment;
    double from, to;        // of the segment's parameter
    double length_at_from;  // from the curve's start
  };
  void measure();
  void find_corners();

  std::vector<Segment<D>> segments_;
  std::vector<Stretch> stretches_;
  std::vector<double> end_lengths_;
  std::vector<bool> corner_at_start_;
  bool is_closed_ = false;
};

using Curve2 = Curve<2>;
using Curve3 = Curve<3>;

/// One Bezier segment of degree points.size() - 1. Throws InputError below 2 points.
template <int D>
Curve<D> bezier_curve(const std::vector<Vector<D>>& control_points);

/// Bezier segments, each beginning where the one before ends. Throws InputError where they do not meet.
template <int D>
Curve<D> joined_bezier_curve(const std::vector<std::vector<Vector<D>>>& segments);

/// A smooth curve through hand-given points: the centripetal Catmull-Rom spline [Yuksel11] as cubic Bezier
/// segments, with handles no longer than the chord on the other side of their point. It departs from a chord
/// c by at most 3/4 of the longer handle, a handle being at most min(2/3 c, the neighbouring chord): at
/// uneven spacing it neither overshoots nor swings out beside a short span, however short. Repeated points
/// count once. Throws InputError below 2 points (3 when closed).
template <int D>
Curve<D> free_curve(const std::vector<Vector<D>>& points, bool is_closed);

/// Straight segments through the points; every point is a corner. Throws InputError below 2 points (3 when
/// closed).
template <int D>
Curve<D> polyline(const std::vector<Vector<D>>& points, bool is_closed);

}  // namespace sweepkit::sweep
