// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The curves that people hand in, as joined segments.
// free_curve: centripetal Catmull-Rom [Yuksel, Schaefer, Keyser 2011]: knots spaced by the square root of the
// chord, which makes no loop between points at uneven distances. Each span becomes a cubic Bezier segment.
// Next to a chord s a chord L gets a handle of about 2/3 sqrt(s L), though: far longer than s where s is
// short, and the curve swings out beside the short span by hundreds of its lengths. So no handle is longer
// than the chord on the other side of its point. The directions stay, and chords within 4.8 times of each
// other keep the spline as published.

#include <algorithm>
#include <cmath>
#include <string>

#include "number_text.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::sweep {
namespace {

void check_count(std::size_t count, std::size_t least, const char* what) {
  if (count < least) {
    throw InputError("needs at least " + std::to_string(least) + " " + what + ", got " +
                     std::to_string(count));
  }
}

// Points nearer to each other than this share of the largest coordinate differ by its rounding, which tells
// no direction.
constexpr double kSamePoint = 1e-15;

template <int D>
std::vector<Vector<D>> without_repeats(const std::vector<Vector<D>>& points, bool is_closed) {
  double largest = 0;
  for (const Vector<D>& point : points) {
    for (int i = 0; i < D; ++i) {
      if (!std::isfinite(point[i])) throw InputError("needs finite coordinates, got NaN or infinity");
      largest = std::max(largest, std::abs(point[i]));
    }
  }
  const auto is_repeated = [&](const Vector<D>& a, const Vector<D>& b) {
    return !(glm::length(a - b) > kSamePoint * largest);
  };
  std::vector<Vector<D>> kept;
  for (const Vector<D>& point : points) {
    if (kept.empty() || !is_repeated(point, kept.back())) kept.push_back(point);
  }
  if (is_closed && kept.size() > 1 && is_repeated(kept.front(), kept.back())) kept.pop_back();
  return kept;
}

// Slope at b of the parabola through a, b, c with knots spaced `ab` and `bc` apart.
template <int D>
Vector<D> parabola_slope(const Vector<D>& a, const Vector<D>& b, const Vector<D>& c, double ab, double bc) {
  return ((b - a) / ab) * (bc / (ab + bc)) + ((c - b) / bc) * (ab / (ab + bc));
}

// The longest handle of the published spline, as a share of its own chord: reached between chords that lie
// on one line. The parabola of an open end may ask for more.
constexpr double kLongestHandle = 2.0 / 3;

template <int D>
Vector<D> shortened(const Vector<D>& handle, double longest) {
  const double length = glm::length(handle);
  return length > longest ? handle * (longest / length) : handle;
}

}  // namespace

template <int D>
Curve<D> bezier_curve(const std::vector<Vector<D>>& control_points) {
  check_count(control_points.size(), 2, "control points");
  return Curve<D>({BezierSegment<D>{control_points}});
}

template <int D>
Curve<D> joined_bezier_curve(const std::vector<std::vector<Vector<D>>>& segments) {
  check_count(segments.size(), 1, "segments");
  std::vector<Segment<D>> joined;
  for (const std::vector<Vector<D>>& control_points : segments) {
    check_count(control_points.size(), 2, "control points a segment");
    joined.push_back(BezierSegment<D>{control_points});
  }
  return Curve<D>(std::move(joined));
}

template <int D>
Curve<D> polyline(const std::vector<Vector<D>>& points, bool is_closed) {
  check_count(points.size(), is_closed ? 3 : 2, "points");
  std::vector<Segment<D>> segments;
  for (std::size_t i = 1; i < points.size(); ++i)
    segments.push_back(BezierSegment<D>{{points[i - 1], points[i]}});
  if (is_closed && points.front() != points.back())
    segments.push_back(BezierSegment<D>{{points.back(), points.front()}});
  return Curve<D>(std::move(segments));
}

template <int D>
Curve<D> free_curve(const std::vector<Vector<D>>& points, bool is_closed) {
  check_count(points.size(), is_closed ? 3 : 2, "points");
  const std::vector<Vector<D>> through = without_repeats<D>(points, is_closed);
  check_count(through.size(), is_closed ? 3 : 2, "points that differ from their neighbours");

  const std::size_t count = through.size();
  const std::size_t spans = is_closed ? count : count - 1;
  const auto point = [&](std::size_t i) { return through[i % count]; };
  std::vector<double> knot_steps(spans);
  for (std::size_t i = 0; i < spans; ++i) knot_steps[i] = std::sqrt(glm::length(point(i + 1) - point(i)));

  const auto slope = [&](std::size_t i) -> Vector<D> {
    if (!is_closed && (i == 0 || i == count - 1)) {
      // An open end goes on as the parabola through its three points does; two points make a line.
      if (count == 2) return (through[1] - through[0]) / knot_steps[0];
      const bool is_first = i == 0;
      const Vector<D> end = is_first ? through[0] : through[count - 1];
      const Vector<D> next = is_first ? through[1] : through[count - 2];
      const double step = is_first ? knot_steps[0] : knot_steps[spans - 1];
      const Vector<D> inner =
          is_first ? parabola_slope<D>(through[0], through[1], through[2], knot_steps[0], knot_steps[1])
                   : -parabola_slope<D>(through[count - 3], through[count - 2], through[count - 1],
                                        knot_steps[spans - 2], knot_steps[spans - 1]);
      const Vector<D> outward = 2.0 * (next - end) / step - inner;
      return is_first ? outward : -outward;
    }
    const std::size_t before = (i + count - 1) % count;
    const std::size_t step_before = is_closed ? (i + spans - 1) % spans : i - 1;
    return parabola_slope<D>(point(before), point(i), point(i + 1), knot_steps[step_before],
                             knot_steps[i % spans]);
  };

  const auto chord = [&](std::size_t span) { return knot_steps[span] * knot_steps[span]; };
  // From point `i` into `span`, whose chord alone limits it at an open end.
  const auto handle = [&](std::size_t i, std::size_t span) {
    const std::size_t before = (i + spans - 1) % spans;
    const bool is_open_end = !is_closed && (i == 0 || i == count - 1);
    const std::size_t other = is_open_end ? span : span == before ? i % spans : before;
    return shortened<D>(knot_steps[span] / 3 * slope(i),
                        std::min(chord(span) * kLongestHandle, chord(other)));
  };
  std::vector<Segment<D>> segments;
  segments.reserve(spans);
  for (std::size_t i = 0; i < spans; ++i) {
    const Vector<D> a = point(i);
    const Vector<D> b = point(i + 1);
    segments.push_back(BezierSegment<D>{{a, a + handle(i, i), b - handle((i + 1) % count, i), b}});
  }
  return Curve<D>(std::move(segments));
}

template Curve<2> bezier_curve<2>(const std::vector<Vector<2>>&);
template Curve<3> bezier_curve<3>(const std::vector<Vector<3>>&);
template Curve<2> joined_bezier_curve<2>(const std::vector<std::vector<Vector<2>>>&);
template Curve<3> joined_bezier_curve<3>(const std::vector<std::vector<Vector<3>>>&);
template Curve<2> polyline<2>(const std::vector<Vector<2>>&, bool);
template Curve<3> polyline<3>(const std::vector<Vector<3>>&, bool);
template Curve<2> free_curve<2>(const std::vector<Vector<2>>&, bool);
template Curve<3> free_curve<3>(const std::vector<Vector<3>>&, bool);

}  // namespace sweepkit::sweep
