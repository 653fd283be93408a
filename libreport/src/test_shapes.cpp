// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The nearest point of a curve, or of a surface given by a formula, by Newton's and by the Gauss-Newton
// method from a first guess out of (u,v). In double: what is left is 1e-15 of the shape's size.
#include "test_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "sweepkit/sweep/primitives.hpp"

namespace sweepkit::report {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kMostSteps = 60;

// A curve's position and two derivatives by t in 0..1.
template <int D>
struct Bent {
  glm::vec<D, double> position, first, second;
};

template <int D>
using Formula = Bent<D> (*)(double t);

// t at even shares of the length, so that a guess can be had from v, which runs by arc length.
template <int D>
class LengthTable {
 public:
  explicit LengthTable(Formula<D> formula) {
    constexpr int kSteps = 4096;
    std::vector<double> lengths = {0};
    for (int i = 0; i < kSteps; ++i)
      lengths.push_back(lengths.back() + glm::length(formula((i + 0.5) / kSteps).first) / kSteps);
    std::size_t next = 0;
    for (std::size_t k = 0; k <= kSteps; ++k) {
      const double wanted = lengths.back() * static_cast<double>(k) / kSteps;
      while (next < kSteps && lengths[next + 1] < wanted) ++next;
      parameters_.push_back(static_cast<double>(next) / kSteps);
    }
  }
  double guess(double share) const {
    const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(parameters_.size() - 1);
    return parameters_[static_cast<std::size_t>(at)];
  }

 private:
  std::vector<double> parameters_;
};

// Newton's method for the foot of the perpendicular; beyond an end of an open curve the end is nearest.
template <int D>
double distance_to_curve(Formula<D> formula, const glm::vec<D, double>& p, double t, bool is_closed) {
  for (int step = 0; step < kMostSteps; ++step) {
    const Bent<D> at = formula(t);
    const auto back = at.position - p;
    const double slope = glm::dot(back, at.first);
    const double square = glm::dot(at.first, at.first);
    // Inside of the evolute the second derivative keeps its sign; elsewhere the step is Gauss-Newton's.
    const double bend = square + glm::dot(back, at.second);
    double next = t - slope / (bend > 0.1 * square ? bend : square);
    if (!is_closed) next = std::clamp(next, 0.0, 1.0);
    const double moved = std::abs(next - t);
    t = next;
    if (moved < 1e-14) break;
  }
  return glm::length(formula(t).position - p);
}

SurfaceDistance tube_distance(Formula<3> formula, double radius, bool is_closed) {
  return [formula, radius, is_closed, table = std::make_shared<LengthTable<3>>(formula)](
             const glm::dvec3& p, const glm::dvec2& uv) {
    return std::abs(distance_to_curve<3>(formula, p, table->guess(uv.y), is_closed) - radius);
  };
}

// Along u and v of a sweep: the contour and the trajectory.
sweep::Tessellation swept_counts(int columns, int rows) {
  return {.contour = columns, .trajectory = rows};
}

// ---- A trefoil: ((2 + r cos 3s) cos 2s, ...) in TorusKnotSegment's letters

constexpr double kKnotTube = 0.4;
constexpr double kKnotRadius = 0.15;

Bent<3> trefoil(double t) {
  const double s = 2 * kPi * t;
  const double rate = 2 * kPi;
  const double ring = 1 + kKnotTube * std::cos(3 * s);
  const double ring1 = -3 * kKnotTube * std::sin(3 * s);
  const double ring2 = -9 * kKnotTube * std::cos(3 * s);
  const double c = std::cos(2 * s);
  const double d = std::sin(2 * s);
  const double up = kKnotTube * std::sin(3 * s);
  const glm::dvec3 first(ring1 * c - 2 * ring * d, 3 * kKnotTube * std::cos(3 * s),
                         -(ring1 * d + 2 * ring * c));
  const glm::dvec3 second(ring2 * c - 4 * ring1 * d - 4 * ring * c, -9 * up,
                          -(ring2 * d + 4 * ring1 * c - 4 * ring * d));
  return {{ring * c, up, -ring * d}, rate * first, rate * rate * second};
}

TestShape trefoil_tube() {
  const auto make = [](const sweep::Tessellation& tessellation) {
    return sweep::sweep(sweep::circle_contour(kKnotRadius), sweep::torus_knot(2, 3, 1, kKnotTube),
                        {.tessellation = tessellation, .has_half_edges = false});
  };
  return {"trefoil",    "tube about a trefoil knot, swept",       2.8, 6, make,
          swept_counts, tube_distance(trefoil, kKnotRadius, true)};
}

// ---- A spring: (cos a, 0.4 a / 2 pi, -sin a), 5 turns

constexpr double kSpringTurns = 5;
constexpr double kSpringPitch = 0.4;
constexpr double kSpringRadius = 0.12;

Bent<3> spring(double t) {
  const double rate = 2 * kPi * kSpringTurns;
  const double c = std::cos(rate * t);
  const double s = std::sin(rate * t);
  return {{c, kSpringPitch * kSpringTurns * t, -s},
          {-rate * s, kSpringPitch * kSpringTurns, -rate * c},
          {-rate * rate * c, 0, rate * rate * s}};
}

TestShape spring_tube() {
  const auto make = [](const sweep::Tessellation& tessellation) {
    return sweep::sweep(sweep::circle_contour(kSpringRadius), sweep::helix(1, kSpringPitch, kSpringTurns),
                        {.tessellation = tessellation, .caps = sweep::Caps::kNone, .has_half_edges = false});
  };
  return {"spring",     "tube about a helix of five turns, swept",  2.2, 13, make,
          swept_counts, tube_distance(spring, kSpringRadius, false)};
}

// ---- A vase: a cubic of (distance from the axis, height), turned; begins on the axis

const std::array<glm::dvec2, 4> kVase = {{{0, 0}, {1, 0}, {0.2, 1.5}, {0.6, 2}}};

Bent<2> vase_contour(double t) {
  const double s = 1 - t;
  const auto& [a, b, c, d] = kVase;
  return {s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d,
          3.0 * (s * s * (b - a) + 2 * s * t * (c - b) + t * t * (d - c)),
          6.0 * (s * (c - 2.0 * b + a) + t * (d - 2.0 * c + b))};
}

TestShape vase() {
  const auto make = [](const sweep::Tessellation& tessellation) {
    return sweep::revolve(sweep::bezier_curve<2>({kVase.begin(), kVase.end()}),
                          {.tessellation = tessellation, .has_half_edges = false});
  };
  // u runs round the turn, which is the trajectory's count, v along the contour.
  const auto counts = [](int columns, int rows) {
    return sweep::Tessellation{.contour = rows, .trajectory = columns};
  };
  const auto distance = [table = std::make_shared<LengthTable<2>>(vase_contour)](const glm::dvec3& p,
                                                                                 const glm::dvec2& uv) {
    return distance_to_curve<2>(vase_contour, {std::hypot(p.x, p.z), p.y}, table->guess(uv.y), false);
  };
  return {"vase", "a cubic contour revolved", 2, 0.75, make, counts, distance};
}

// ---- A spindle: an ellipse that turns by a half and swells along +Z

constexpr double kSpindleLength = 3;
const glm::dvec2 kSpindleRadii(0.3, 0.2);
constexpr double kSpindleTurn = kPi;

double spindle_size(double t) {
  return 0.4 + 2.4 * t * (1 - t);
}
double spindle_size_rate(double t) {
  return 2.4 * (1 - 2 * t);
}

struct SpindlePoint {
  glm::dvec3 position, by_angle, by_t;
};

SpindlePoint spindle(double angle, double t) {
  const auto turned = [&](const glm::dvec2& p) {
    const double c = std::cos(kSpindleTurn * t);
    const double s = std::sin(kSpindleTurn * t);
    return glm::dvec2(c * p.x - s * p.y, s * p.x + c * p.y);
  };
  const glm::dvec2 section(kSpindleRadii.x * std::cos(angle), kSpindleRadii.y * std::sin(angle));
  const glm::dvec2 along(-kSpindleRadii.x * std::sin(angle), kSpindleRadii.y * std::cos(angle));
  const glm::dvec2 place = turned(section);
  const glm::dvec2 across(-place.y, place.x);
  return {{spindle_size(t) * place, kSpindleLength * t},
          {spindle_size(t) * turned(along), 0},
          {spindle_size_rate(t) * place + spindle_size(t) * kSpindleTurn * across, kSpindleLength}};
}

// Gauss-Newton; at an end of the spindle, and drawn out of it, along the end's ellipse alone.
double spindle_distance(const glm::dvec3& p, const glm::dvec2&) {
  double t = std::clamp(p.z / kSpindleLength, 0.0, 1.0);
  const double c = std::cos(kSpindleTurn * t);
  const double s = std::sin(kSpindleTurn * t);
  double angle = std::atan2((c * p.y - s * p.x) / kSpindleRadii.y, (c * p.x + s * p.y) / kSpindleRadii.x);
  for (int step = 0; step < kMostSteps; ++step) {
    const SpindlePoint at = spindle(angle, t);
    const glm::dvec3 left = p - at.position;
    const double aa = glm::dot(at.by_angle, at.by_angle);
    const double at_both = glm::dot(at.by_angle, at.by_t);
    const double tt = glm::dot(at.by_t, at.by_t);
    const double a = glm::dot(at.by_angle, left);
    const double b = glm::dot(at.by_t, left);
    const double area = aa * tt - at_both * at_both;
    double moved_t = (aa * b - at_both * a) / area;
    double moved_angle = (tt * a - at_both * b) / area;
    const double next = std::clamp(t + moved_t, 0.0, 1.0);
    if (next != t + moved_t) {
      moved_t = next - t;
      moved_angle = (a - at_both * moved_t) / aa;
    }
    t = next;
    angle += moved_angle;
    if (std::abs(moved_t) + std::abs(moved_angle) < 1e-13) break;
  }
  return glm::length(spindle(angle, t).position - p);
}

TestShape twisted_spindle() {
  // The same parabola and the same line, as Bezier laws.
  const sweep::Law size = sweep::Law::bezier(
      {{0, spindle_size(0)}, {0.5, spindle_size(0) + 0.5 * spindle_size_rate(0)}, {1, spindle_size(1)}});
  const sweep::Law turn = sweep::Law::bezier({{0, 0}, {1, kSpindleTurn * 180 / kPi}});
  const auto make = [size, turn](const sweep::Tessellation& tessellation) {
    return sweep::sweep(sweep::ellipse_contour(kSpindleRadii.x, kSpindleRadii.y),
                        sweep::polyline<3>({{0, 0, 0}, {0, 0, kSpindleLength}}, false),
                        {.tessellation = tessellation,
                         .caps = sweep::Caps::kNone,
                         .has_half_edges = false,
                         .profile = {size, size},
                         .twist_deg = turn});
  };
  return {"spindle", "an ellipse that turns and swells, swept", 3, 1, make, swept_counts, spindle_distance};
}

}  // namespace

std::vector<TestShape> test_shapes() {
  return {vase(), trefoil_tube(), spring_tube(), twisted_spindle()};
}

}  // namespace sweepkit::report
