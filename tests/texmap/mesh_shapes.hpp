// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace sweepkit::texmap::test {

/// A triangle list for tests; (u,v) where the shape has some.
struct Shape {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> texcoords;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// columns x rows cells of point(u, v) with u, v in 0..1, the (u,v) of the grid, diagonals falling.
template <class Point>
Shape grid_of(std::uint32_t columns, std::uint32_t rows, Point&& point) {
  Shape shape;
  for (std::uint32_t j = 0; j <= rows; ++j) {
    for (std::uint32_t i = 0; i <= columns; ++i) {
      const glm::dvec2 uv(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
      shape.positions.push_back(glm::vec3(point(uv)));
      shape.texcoords.push_back(glm::vec2(uv));
    }
  }
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t p = j * (columns + 1) + i;
      shape.triangles.push_back({p + columns + 1, p, p + 1});
      shape.triangles.push_back({p + 1, p + columns + 2, p + columns + 1});
    }
  }
  return shape;
}

inline Shape plane(std::uint32_t columns, std::uint32_t rows) {
  return grid_of(columns, rows,
                 [&](const glm::dvec2& uv) { return glm::dvec3(uv * glm::dvec2(columns, rows), 0); });
}

/// Closed: the last column and row are the first's positions, bit for bit.
inline Shape torus(std::uint32_t columns, std::uint32_t rows) {
  return grid_of(columns, rows, [](const glm::dvec2& uv) {
    const auto turn = [](double t) {
      const double angle = 2 * std::numbers::pi * (t == 1 ? 0 : t);
      return glm::dvec2(std::cos(angle), std::sin(angle));
    };
    const glm::dvec2 a = turn(uv.x);
    const glm::dvec2 b = turn(uv.y);
    const double r = 3 + a.x;
    return glm::dvec3(r * b.x, a.y, r * b.y);
  });
}

/// Every corner a vertex of its own, as an STL file has them.
inline Shape soup_of(const Shape& shape) {
  Shape soup;
  for (const auto& triangle : shape.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (const std::uint32_t vertex : triangle) soup.positions.push_back(shape.positions[vertex]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

/// An icosahedron, each triangle cut into four `steps` times, on the unit sphere.
inline Shape icosphere(int steps) {
  const double g = std::numbers::phi;
  Shape shape;
  for (const glm::dvec3& p :
       {glm::dvec3(-1, g, 0), glm::dvec3(1, g, 0), glm::dvec3(-1, -g, 0), glm::dvec3(1, -g, 0),
        glm::dvec3(0, -1, g), glm::dvec3(0, 1, g), glm::dvec3(0, -1, -g), glm::dvec3(0, 1, -g),
        glm::dvec3(g, 0, -1), glm::dvec3(g, 0, 1), glm::dvec3(-g, 0, -1), glm::dvec3(-g, 0, 1)}) {
    shape.positions.push_back(glm::vec3(glm::normalize(p)));
  }
  shape.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int step = 0; step < steps; ++step) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, is_new] =
          middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(shape.positions.size()));
      if (is_new) shape.positions.push_back(glm::normalize(shape.positions[a] + shape.positions[b]));
      return found->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : shape.triangles) {
      const std::uint32_t ab = middle(a, b);
      const std::uint32_t bc = middle(b, c);
      const std::uint32_t ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    shape.triangles = std::move(finer);
  }
  return shape;
}

/// Takes the order out of a mesh: its triangles in any order, each from any of its corners on.
inline void shuffle(Shape& shape, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (std::size_t i = shape.triangles.size(); i > 1; --i) {
    std::swap(shape.triangles[i - 1], shape.triangles[random() % i]);
    auto& t = shape.triangles[i - 1];
    const std::size_t turn = random() % 3;
    t = {t[turn], t[(turn + 1) % 3], t[(turn + 2) % 3]};
  }
}

}  // namespace sweepkit::texmap::test
