// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Joined segments are smooth in direction alone: no method keeps its order across a joint that falls into one
// of its steps. The reference begins anew there.

#include "sample_curves.hpp"

#include <algorithm>
#include <cmath>

#include "frame_methods.hpp"
#include "scene_files.hpp"
#include "sweepkit/scene/document.hpp"

namespace sweepkit::report {
namespace {

const FrameMethod& reference_method() {
  static const std::vector<FrameMethod> all = frame_methods();
  return *std::find_if(all.begin(), all.end(),
                       [](const FrameMethod& one) { return one.name == "Runge-Kutta 4"; });
}

// Across part of one segment.
glm::dvec3 carry(const sweep::Segment<3>& segment, double from, double to, int steps,
                 const glm::dvec3& normal) {
  const auto evaluate = [&](double t) { return sweep::evaluate<3>(segment, t); };
  std::vector<sweep::CurvePoint<3>> points;
  for (int i = 0; i <= steps; ++i) points.push_back(evaluate(from + (to - from) * i / steps));
  std::vector<glm::dvec3> normals(points.size(), normal);
  reference_method().carry(points, from, (to - from) / steps, evaluate, normals);
  return normals.back();
}

std::vector<glm::dvec3> fine_normals(const sweep::Curve3& trajectory, int steps) {
  const auto segments = trajectory.segments();
  const double to = static_cast<double>(segments.size());
  const int finer = std::max(16, 65536 / steps);
  const glm::dvec3 tangent = sweep::tangent<3>(segments[0], 0);
  const glm::dvec3 across = std::abs(tangent.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
  std::vector<glm::dvec3> normals = {glm::normalize(across - glm::dot(across, tangent) * tangent)};
  for (int i = 0; i < steps; ++i) {
    const double end = to * (i + 1) / steps;
    glm::dvec3 normal = normals.back();
    for (double u = to * i / steps; u < end;) {
      const double segment = std::min(std::floor(u), to - 1);
      const double stop = std::min(end, segment + 1);
      normal = carry(segments[static_cast<std::size_t>(segment)], u - segment, stop - segment, finer, normal);
      u = stop;
    }
    normals.push_back(normal);
  }
  return normals;
}

// In a plane the normal across it stays, whatever carries it: there is nothing to tell apart.
bool is_worth_measuring(const sweep::Curve3& trajectory) {
  bool leaves_plane = false;
  for (std::size_t i = 0; i < trajectory.segments().size(); ++i) {
    if (trajectory.is_corner(i)) return false;
    for (const double t : {0.125, 0.375, 0.625, 0.875}) {
      const sweep::CurvePoint<3> point = sweep::evaluate<3>(trajectory.segments()[i], t);
      const double volume = std::abs(glm::dot(glm::cross(point.first, point.second), point.third));
      const double box = glm::length(point.first) * glm::length(point.second) * glm::length(point.third);
      // Far above what rounding makes of a plane curve, far below what anyone draws in space.
      leaves_plane = leaves_plane || volume > 1e-9 * box;
    }
  }
  return leaves_plane;
}

}  // namespace

TestCurve curve_of(std::string name, std::string title, sweep::Curve3 trajectory) {
  const double to = static_cast<double>(trajectory.segments().size());
  const auto evaluate = [trajectory, to](double u) {
    const double segment = std::clamp(std::floor(u), 0.0, to - 1);
    return sweep::evaluate<3>(trajectory.segments()[static_cast<std::size_t>(segment)], u - segment);
  };
  const auto normals = [trajectory](int steps) { return fine_normals(trajectory, steps); };
  return {std::move(name), std::move(title), 0, to, evaluate, normals};
}

std::vector<TestCurve> sample_curves(const Effort& effort) {
  std::vector<TestCurve> curves;
  for (const SceneFile& scene : scene_files(effort, {"spring", "seashell", "trefoil_knot"})) {
    for (const scene::ObjectEntry& object : scene::read_document(scene.file).objects) {
      for (const scene::Piece& piece : object.pieces) {
        const auto* shape = std::get_if<scene::SweepShape>(&piece.shape);
        if (shape == nullptr || !is_worth_measuring(shape->trajectory)) continue;
        const bool is_known = std::any_of(curves.begin(), curves.end(),
                                          [&](const TestCurve& one) { return one.name == object.name; });
        if (is_known) continue;  // the first part's trajectory stands for an object of several
        curves.push_back(curve_of(object.name, "trajectory in " + scene.name + ".json", shape->trajectory));
      }
    }
  }
  return curves;
}

}  // namespace sweepkit::report
