// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Curves as joined segments measured by arc length. The length of a segment is integrated by Gauss-Legendre
// rules over stretches that are halved until the rule agrees with its two halves to 1e-13 of the whole; a
// cusp, where the speed has a kink, ends the halving at a stretch too short to matter. locate() inverts by
// Newton's method kept inside the stretch.

#include "sweepkit/sweep/curve.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "cusps.hpp"
#include "gauss_legendre.hpp"
#include "number_text.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/strict_math.hpp"

namespace sweepkit::sweep {
namespace {

// Ends that differ by less than this share of the curve's size were meant to meet: hand-typed and exported
// coordinates carry 6 to 9 digits at best after a transform, and a real gap is far wider.
constexpr double kMeetTolerance = 1e-9;

// A joint that bends by less (radians) is smooth: a fiftieth of a degree shows in no normal.
constexpr double kSmoothAngle = 3e-4;

// Squares of coordinates beyond these overflow, or lose digits below the smallest number of full precision.
constexpr double kSmallest = 1e-140;
constexpr double kLargest = 1e150;

template <int D>
bool is_finite(const Vector<D>& point) {
  for (int i = 0; i < D; ++i) {
    if (!std::isfinite(point[i])) return false;
  }
  return true;
}

template <int D>
bool is_sound(const BezierSegment<D>& bezier) {
  return std::all_of(bezier.control.begin(), bezier.control.end(), is_finite<D>);
}
template <int D>
bool is_sound(const ArcSegment<D>& arc) {
  return is_finite<D>(arc.center) && is_finite<D>(arc.x_axis) && is_finite<D>(arc.y_axis) &&
         is_finite<D>(arc.rise) && std::isfinite(arc.from_deg) && std::isfinite(arc.to_deg);
}
bool is_sound(const TorusKnotSegment& knot) {
  return std::isfinite(knot.radius) && std::isfinite(knot.tube);
}

template <int D>
bool is_point(const BezierSegment<D>& bezier) {
  return std::all_of(bezier.control.begin(), bezier.control.end(),
                     [&](const Vector<D>& p) { return p == bezier.control.front(); });
}
template <int D>
bool is_point(const ArcSegment<D>& arc) {
  const Vector<D> none(0.0);
  return arc.rise == none && (arc.from_deg == arc.to_deg || (arc.x_axis == none && arc.y_axis == none));
}
bool is_point(const TorusKnotSegment& knot) {
  return knot.radius == 0 && knot.tube == 0;
}

template <int D>
double speed(const Segment<D>& segment, double t) {
  return glm::length(evaluate<D>(segment, t).first);
}

// Is the speed the same all along, but for rounding: on a line, a circle, an upright helix?
template <int D>
bool is_even(const BezierSegment<D>& bezier) {
  return bezier.control.size() == 2;
}
template <int D>
bool is_even(const ArcSegment<D>& arc) {
  // The speed's square is |a|^2 + |rise|^2 + 2 a . rise, a = rate (cos y_axis - sin x_axis).
  const double x = glm::dot(arc.x_axis, arc.x_axis);
  const double none = 1e-15 * x;
  const double rise = 1e-15 * std::sqrt(x) * glm::length(arc.rise);
  return std::abs(glm::dot(arc.y_axis, arc.y_axis) - x) <= none &&
         std::abs(glm::dot(arc.x_axis, arc.y_axis)) <= none &&
         std::abs(glm::dot(arc.x_axis, arc.rise)) <= rise && std::abs(glm::dot(arc.y_axis, arc.rise)) <= rise;
}
bool is_even(const TorusKnotSegment&) {
  return false;
}

template <int D>
double length_between(const Segment<D>& segment, double from, double to) {
  return gauss_legendre_16(from, to, [&](double t) { return speed<D>(segment, t); });
}

}  // namespace

template <int D>
Curve<D>::Curve(std::vector<Segment<D>> segments) : segments_(std::move(segments)) {
  for (const Segment<D>& segment : segments_) {
    if (!std::visit([](const auto& kind) { return is_sound(kind); }, segment)) {
      throw InputError("needs finite coordinates, got NaN or infinity");
    }
  }
  std::erase_if(segments_, [](const Segment<D>& segment) {
    return std::visit([](const auto& kind) { return is_point(kind); }, segment);
  });
  if (segments_.empty()) throw InputError("has no length: all its points are the same; give two that differ");
  // In space a cusp is a finding: no joint bends that sharply.
  if constexpr (D == 2) segments_ = split_at_cusps(std::move(segments_));

  double size = 0;
  const Vector<D> start = sweep::evaluate<D>(segments_.front(), 0).position;
  for (const Segment<D>& segment : segments_) {
    for (const double t : {0.25, 0.5, 1.0}) {
      size = std::max(size, glm::length(sweep::evaluate<D>(segment, t).position - start));
    }
  }
  if (size > 0 && !(size > kSmallest && size < kLargest)) {
    throw InputError("is " + number_text(size) + " m large, of which no length can be measured; make it " +
                     "between " + number_text(kSmallest) + " and " + number_text(kLargest) + " m large");
  }
  for (std::size_t i = 1; i < segments_.size(); ++i) {
    const double gap = glm::length(sweep::evaluate<D>(segments_[i], 0).position -
                                   sweep::evaluate<D>(segments_[i - 1], 1).position);
    if (gap > kMeetTolerance * size) {
      throw InputError("segment " + std::to_string(i) + " begins " + number_text(gap) +
                       " m from where segment " + std::to_string(i - 1) + " ends; let it begin there");
    }
  }
  is_closed_ = glm::length(sweep::evaluate<D>(segments_.back(), 1).position - start) <= kMeetTolerance * size;
  measure();
  find_corners();
}

template <int D>
void Curve<D>::measure() {
  constexpr int kMaxDepth = 48;
  double total = 0;
  double rough = 0;
  for (const Segment<D>& segment : segments_) rough += length_between<D>(segment, 0, 1);
  if (!std::isfinite(rough))
    throw InputError("has coordinates too large to measure: its length is not a finite number");

  for (std::size_t index = 0; index < segments_.size(); ++index) {
    const Segment<D>& segment = segments_[index];
    // Depth first, left before right, so that the stretches come in order.
    struct Task {
      double from, to, length;
      int depth;
    };
    std::vector<Task> tasks = {{0, 1, length_between<D>(segment, 0, 1), 0}};
    while (!tasks.empty()) {
      const Task task = tasks.back();
      tasks.pop_back();
      const double middle = 0.5 * (task.from + task.to);
      const double left = length_between<D>(segment, task.from, middle);
      const double right = length_between<D>(segment, middle, task.to);
      if (std::abs(left + right - task.length) <= 1e-13 * rough || task.depth == kMaxDepth) {
        stretches_.push_back({index, task.from, task.to, total});
        total += left + right;
      } else {
        tasks.push_back({middle, task.to, right, task.depth + 1});
        tasks.push_back({task.from, middle, left, task.depth + 1});
      }
    }
    end_lengths_.push_back(total);
  }
  if (!(total > 0)) throw InputError("has no length; give two points that differ");
}

template <int D>
void Curve<D>::find_corners() {
  corner_at_start_.assign(segments_.size(), false);
  for (std::size_t i = is_closed_ ? 0 : 1; i < segments_.size(); ++i) {
    const Segment<D>& before = segments_[i == 0 ? segments_.size() - 1 : i - 1];
    const Vector<D> in = sweep::tangent<D>(before, 1);
    const Vector<D> out = sweep::tangent<D>(segments_[i], 0);
    corner_at_start_[i] = glm::length(out - in) > kSmoothAngle;
  }
}

template <int D>
CurvePoint<D> Curve<D>::evaluate(CurveLocation location) const {
  return sweep::evaluate<D>(segments_[location.segment], location.t);
}

template <int D>
Vector<D> Curve<D>::tangent(CurveLocation location) const {
  return sweep::tangent<D>(segments_[location.segment], location.t);
}

template <int D>
CurveLocation Curve<D>::locate(double length) const {
  if (!(length > 0)) return {0, 0};
  if (length >= this->length()) return {segments_.size() - 1, 1};
  const auto after =
      std::upper_bound(stretches_.begin(), stretches_.end(), length,
                       [](double value, const Stretch& stretch) { return value < stretch.length_at_from; });
  const Stretch& stretch = *(after - 1);
  const double stretch_end = after == stretches_.end() ? this->length() : after->length_at_from;
  const double wanted = length - stretch.length_at_from;
  const double whole = stretch_end - stretch.length_at_from;
  const Segment<D>& segment = segments_[stretch.segment];

  double low = stretch.from;
  double high = stretch.to;
  double t = whole > 0 ? low + (high - low) * std::min(1.0, wanted / whole) : low;
  if (std::visit([](const auto& kind) { return is_even(kind); }, segment)) return {stretch.segment, t};
  for (int step = 0; step < 60; ++step) {
    const double error = length_between<D>(segment, stretch.from, t) - wanted;
    if (std::abs(error) <= 1e-15 * this->length()) break;
    (error > 0 ? high : low) = t;
    const double rate = speed<D>(segment, t);
    double next = rate > 0 ? t - error / rate : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == t) break;
    t = next;
  }
  return {stretch.segment, t};
}

template class Curve<2>;
template class Curve<3>;

}  // namespace sweepkit::sweep
