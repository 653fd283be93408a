// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "sweep_meshes.hpp"

namespace sweepkit::render::test {

/// Triangles without any order or grid: some share vertices, some are points or lines, some lie in one plane.
inline Shape soup() {
  Shape shape;
  shape.name = "soup";
  std::mt19937 random(11);
  std::uniform_real_distribution<float> real(-1, 1);
  for (std::uint32_t t = 0; t < 300; ++t) {
    const glm::vec3 middle(real(random), real(random), real(random));
    for (int corner = 0; corner < 3; ++corner) {
      glm::vec3 p = middle + 0.2F * glm::vec3(real(random), real(random), real(random));
      if (t % 5 == 0) p.y = 0.25F;
      shape.positions.push_back(p);
    }
    shape.triangles.push_back(t % 11 == 0   ? sweep::Triangle{3 * t, 3 * t, 3 * t}
                              : t % 11 == 1 ? sweep::Triangle{3 * t, 3 * t + 1, 3 * t}
                                            : sweep::Triangle{3 * t, 3 * t + 1, 3 * t + 2});
  }
  return shape;
}

inline Shape plane(int columns, int rows) {
  return shape_of("plane " + std::to_string(columns) + " x " + std::to_string(rows),
                  sweep::plane({2, 2}, {.tessellation = {columns, rows}, .has_half_edges = false}));
}

inline Shape many_patches() {
  return shape_of("star prism", sweep::sweep(sweep::star_contour(40, 1, 0.6),
                                             sweep::Curve3({sweep::BezierSegment<3>{{{0, 0, 0}, {0, 1, 0}}}}),
                                             {.tessellation = {320, 9}, .has_half_edges = false}));
}

inline Shape mirrored_pair() {
  const sweep::Mesh part = sweep::sweep(sweep::circle_contour(0.3), sweep::circle_trajectory(1),
                                        {.tessellation = {12, 40}, .has_half_edges = false});
  sweep::Mesh mesh;
  sweep::append(mesh, part, glm::dmat4(1.0));
  glm::dmat4 mirror(1.0);
  mirror[0][0] = -1;
  mirror[3][1] = 0.2;
  sweep::append(mesh, part, mirror);
  return shape_of("mirrored pair", mesh);
}

inline std::vector<Shape> crowd() {
  std::vector<Shape> shapes = {vase(24, 30), trefoil(12, 90), sphere(24, 40), soup(),
                               plane(1, 1),  plane(1, 50),    plane(50, 1),   plane(2, 9),
                               plane(3, 3),  plane(40, 33),   many_patches(), mirrored_pair()};
  shapes.push_back(moved(vase(24, 30), 1e-3, glm::dvec3(0.0)));
  shapes.push_back(moved(vase(24, 30), 0x1p10, glm::dvec3(0.0)));
  shapes.push_back(moved(trefoil(12, 90), 0x1p-10, glm::dvec3(0.0)));
  shapes.push_back(moved(sphere(24, 40), 1, glm::dvec3(1e3, -1e3, 1e3)));
  shapes.push_back(moved(sphere(24, 40), 1e-20, glm::dvec3(0.0)));
  shapes.push_back(moved(sphere(24, 40), 1e20, glm::dvec3(0.0)));
  // A grid pressed flat, to a line and to a point, and one with a vertex that is no number.
  for (int flat = 1; flat <= 3; ++flat) {
    Shape shape = trefoil(12, 90);
    for (glm::vec3& p : shape.positions) {
      p.y = 0.5F;
      if (flat > 1) p.z = p.x;
      if (flat > 2) p.x = p.z = 1;
    }
    shapes.push_back(shape);
  }
  Shape spoiled = trefoil(12, 90);
  spoiled.positions[70] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
  shapes.push_back(spoiled);
  return shapes;
}

struct Extent {
  glm::dvec3 middle{0.0};
  double size = 0;
};

inline Extent extent_of(const Shape& shape) {
  glm::dvec3 low(1e300);
  glm::dvec3 high(-1e300);
  for (const glm::vec3& p : shape.positions) {
    if (std::isnan(p.x)) continue;
    low = glm::min(low, glm::dvec3(p));
    high = glm::max(high, glm::dvec3(p));
  }
  return {0.5 * (low + high), std::max(1e-3 * glm::length(low), glm::length(high - low))};
}

/// Rays that go wrong first: through vertices and along edges, in planes and along axes, from inside, from
/// afar, from the surface itself, of tiny and huge directions.
inline std::vector<Ray> hard_rays(const Shape& shape, int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> real(-1, 1);
  const auto [middle, size] = extent_of(shape);
  const auto any = [&] { return glm::dvec3(real(random), real(random), real(random)); };
  const auto any_vertex = [&](const sweep::Triangle& t) {
    return glm::dvec3(shape.positions[t[random() % 3]]);
  };
  std::vector<Ray> rays;
  for (int n = 0; n < count; ++n) {
    const sweep::Triangle& t = shape.triangles[random() % shape.triangles.size()];
    const glm::dvec3 a(shape.positions[t[0]]);
    const glm::dvec3 b(shape.positions[t[1]]);
    const glm::dvec3 c(shape.positions[t[2]]);
    const double s = 0.5 + 0.5 * real(random);
    glm::dvec3 origin = middle + size * any();
    glm::dvec3 aim = any_vertex(t);
    Ray ray;
    switch (n % 12) {
      case 0:
        break;
      case 1:
        aim = (1 - s) * a + s * b;
        break;
      case 2:
        aim = 0.5 * (b + c);
        break;
      case 3:
        aim = (a + b + c) / 3.0;
        break;
      case 4:  // from one vertex to another, along an edge or across the mesh
        origin = n % 24 == 4 ? a : any_vertex(shape.triangles[random() % shape.triangles.size()]);
        aim = b;
        break;
      case 5:  // in the triangle's plane
        origin = a + 3.0 * (b - a) + real(random) * (c - a);
        break;
      case 6: {  // axis-parallel, through a vertex or not
        const int axis = static_cast<int>(random() % 3);
        if (n % 24 == 6) origin = aim;
        origin[axis] = middle[axis] + 2 * size * (n % 48 < 24 ? 1 : -1);
        aim = origin;
        aim[axis] = middle[axis];
        break;
      }
      case 7:  // from afar
        origin = middle + 1e6 * size * any();
        break;
      case 8:  // from very far
        origin = middle + 1e12 * size * any();
        break;
      case 9:  // from inside
        origin = middle + 0.1 * size * any();
        break;
      case 10:  // from the surface
        origin = (a + b + c) / 3.0;
        aim = origin + any();
        ray.from_object = 7;
        ray.from_triangle = static_cast<std::uint32_t>(&t - shape.triangles.data());
        break;
      default:
        aim = middle + size * any();
    }
    ray.origin = origin;
    ray.direction = aim - origin;
    if (n % 7 == 1) ray.direction *= 1e-12;
    if (n % 7 == 2) ray.direction *= 1e9;
    if (n % 5 == 1) ray.direction[n % 3] = n % 2 == 0 ? 0.0 : -0.0;
    rays.push_back(ray);
  }
  return rays;
}

}  // namespace sweepkit::render::test
