// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A sweep's contour at the start is the first row of vertices of its wall, made once more with few cells
// along: so twist, guide, profile and joints are in it, whatever they are.
#include "sweepkit/scene/drawn_curves.hpp"

#include <algorithm>
#include <cmath>

#include "make_mesh.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::scene {
namespace {

constexpr int kChordsOfABezier = 32;
constexpr double kDegreesOfAChord = 5;
constexpr int kChordsOfATurnOfAKnot = 96;
constexpr int kContourCells = 96;
constexpr int kFewCells = 4;

template <int D>
int chords_of(const sweep::Segment<D>& segment) {
  if (const auto* bezier = std::get_if<sweep::BezierSegment<D>>(&segment))
    return bezier->control.size() == 2 ? 1 : kChordsOfABezier;
  if (const auto* arc = std::get_if<sweep::ArcSegment<D>>(&segment))
    return std::max(1, static_cast<int>(std::ceil(std::abs(arc->to_deg - arc->from_deg) / kDegreesOfAChord)));
  if constexpr (D == 3) {
    const auto& knot = std::get<sweep::TorusKnotSegment>(segment);
    return kChordsOfATurnOfAKnot * std::max(std::abs(knot.p), std::abs(knot.q));
  }
  return 1;
}

template <int D, class ToSpace>
std::vector<glm::dvec3> points_of(const sweep::Curve<D>& curve, const ToSpace& to_space) {
  std::vector<glm::dvec3> points;
  for (const sweep::Segment<D>& segment : curve.segments()) {
    const int chords = chords_of<D>(segment);
    for (int i = points.empty() ? 0 : 1; i <= chords; ++i)
      points.push_back(to_space(sweep::evaluate<D>(segment, static_cast<double>(i) / chords).position));
  }
  return points;
}

void add_contours_at_start(const Piece& piece, const SweepShape& shape, std::vector<DrawnCurve>& curves) {
  sweep::SweepOptions options = sweep_options(piece, shape);
  options.caps = sweep::Caps::kNone;
  options.tessellation = {.contour = kContourCells, .trajectory = kFewCells};
  const sweep::Mesh mesh = sweep::sweep(shape.contour, shape.trajectory, options);
  const std::span<const glm::vec3> positions = mesh.positions();
  const std::span<const glm::vec2> texcoords = mesh.texcoords();
  // A wall's patches lie one behind the other along the trajectory, and beside each other where creases part
  // them; the first ones have the least v.
  std::vector<float> least(mesh.areas.size(), HUGE_VALF);
  const auto v_of = [&](const sweep::GridPatch& patch) { return texcoords[patch.vertex(0, 0)].y; };
  for (const sweep::GridPatch& patch : mesh.patches)
    least[patch.area] = std::min(least[patch.area], v_of(patch));
  for (const sweep::GridPatch& patch : mesh.patches) {
    if (v_of(patch) != least[patch.area] || patch.has_first_pole) continue;
    DrawnCurve contour{DrawnCurve::Kind::kContour, {}};
    for (std::uint32_t column = 0; column <= patch.columns; ++column)
      contour.points.push_back(mesh.origin + glm::dvec3(positions[patch.vertex(column, 0)]));
    curves.push_back(std::move(contour));
  }
}

// In the piece's own space.
std::vector<DrawnCurve> curves_of(const Piece& piece) {
  std::vector<DrawnCurve> curves;
  if (const auto* swept = std::get_if<SweepShape>(&piece.shape)) {
    curves.push_back({DrawnCurve::Kind::kTrajectory,
                      points_of<3>(swept->trajectory, [](const glm::dvec3& p) { return p; })});
    add_contours_at_start(piece, *swept, curves);
  }
  if (const auto* revolved = std::get_if<RevolveShape>(&piece.shape)) {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const sweep::Curve2& outline : revolved->contour) {
      curves.push_back({DrawnCurve::Kind::kContour,
                        points_of<2>(outline, [](const glm::dvec2& p) { return glm::dvec3(p, 0); })});
      for (const glm::dvec3& p : curves.back().points) {
        low = std::min(low, p.y);
        high = std::max(high, p.y);
      }
    }
    curves.push_back({DrawnCurve::Kind::kAxis, {{0, low, 0}, {0, high, 0}}});
  }
  return curves;
}

}  // namespace

std::vector<DrawnCurve> drawn_curves(const ObjectEntry& object) {
  std::vector<DrawnCurve> all;
  const glm::dmat4 placed = to_matrix(object.placement);
  const std::vector<Placement> once(1);
  for (const Piece& piece : object.pieces) {
    const std::vector<DrawnCurve> curves = curves_of(piece);
    for (const Placement& instance : object.instances.empty() ? once : object.instances) {
      const glm::dmat4 to_world = to_matrix(instance) * placed * to_matrix(piece.placement);
      for (DrawnCurve curve : curves) {
        for (glm::dvec3& p : curve.points) p = glm::dvec3(to_world * glm::dvec4(p, 1));
        all.push_back(std::move(curve));
      }
    }
  }
  return all;
}

}  // namespace sweepkit::scene
