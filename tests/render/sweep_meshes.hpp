// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <string>
#include <vector>

#include "ray.hpp"
#include "sweepkit/scene/scene.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::render::test {

/// A mesh's arrays, to be moved, scaled or spoiled.
struct Shape {
  std::string name;
  std::vector<glm::vec3> positions;
  std::vector<sweep::Triangle> triangles;
  std::vector<sweep::GridPatch> patches;

  scene::MeshView view() const {
    scene::MeshView view;
    view.positions = positions;
    view.triangles = triangles;
    view.patches = patches;
    return view;
  }
};

inline Shape shape_of(std::string name, const sweep::Mesh& mesh) {
  return {std::move(name), {mesh.positions().begin(), mesh.positions().end()}, mesh.triangles, mesh.patches};
}

inline Shape moved(Shape shape, double scale, const glm::dvec3& by) {
  for (glm::vec3& p : shape.positions) p = glm::vec3(scale * glm::dvec3(p) + by);
  return shape;
}

/// The paper's kind of vase: closed at the foot by a pole, drawn up outside and down inside.
inline Shape vase(int contour, int turn) {
  const auto bezier = [](std::vector<glm::dvec2> points) {
    return sweep::BezierSegment<2>{std::move(points)};
  };
  const sweep::Curve2 outline({bezier({{0, 0}, {0.064, 0}}),
                               bezier({{0.064, 0}, {0.055, 0.03}, {0.156, 0.09}, {0.151, 0.195}}),
                               bezier({{0.151, 0.195}, {0.146, 0.285}, {0.056, 0.275}, {0.052, 0.345}}),
                               bezier({{0.052, 0.345}, {0.05, 0.385}, {0.068, 0.402}, {0.09, 0.417}}),
                               bezier({{0.09, 0.417}, {0.065, 0.409}, {0.044, 0.39}, {0.046, 0.345}}),
                               bezier({{0.046, 0.345}, {0.05, 0.27}, {0.14, 0.28}, {0.144, 0.195}}),
                               bezier({{0.144, 0.195}, {0.149, 0.09}, {0.06, 0.024}, {0, 0.024}})});
  return shape_of("vase",
                  sweep::revolve(outline, {.tessellation = {contour, turn}, .has_half_edges = false}));
}

inline Shape trefoil(int round, int along) {
  return shape_of("trefoil", sweep::sweep(sweep::circle_contour(0.35), sweep::torus_knot(2, 3, 2, 0.8),
                                          {.tessellation = {round, along}, .has_half_edges = false}));
}

/// A closed sphere of 2 * round * (down - 1) triangles.
inline Shape sphere(int down, int round) {
  return shape_of("sphere",
                  sweep::revolve(sweep::Curve2({sweep::ArcSegment<2>{{0, 0}, {1, 0}, {0, 1}, -90, 90}}),
                                 {.tessellation = {down, round}, .has_half_edges = false}));
}

}  // namespace sweepkit::render::test
