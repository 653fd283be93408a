// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <limits>
#include <tuple>
#include <vector>

#include "mesh_measures.hpp"
#include "sweepkit/sweep/mesh.hpp"

namespace sweepkit::sweep::test {

/// The nearest point of a triangle, by cutting it off at its sides: written apart from the library's own.
inline double distance_to_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                                   const glm::dvec3& c) {
  const glm::dvec3 n = glm::cross(b - a, c - a);
  bool is_above = glm::length(n) > 0;
  double nearest = std::numeric_limits<double>::infinity();
  const std::array<glm::dvec3, 3> corners = {a, b, c};
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3& from = corners[k];
    const glm::dvec3 side = corners[(k + 1) % 3] - from;
    if (glm::dot(glm::cross(n, side), p - from) < 0) is_above = false;
    const double square = glm::dot(side, side);
    const double t = square > 0 ? std::clamp(glm::dot(p - from, side) / square, 0.0, 1.0) : 0;
    nearest = std::min(nearest, glm::length(p - from - t * side));
  }
  return is_above ? std::abs(glm::dot(n, p - a)) / glm::length(n) : nearest;
}

/// The wall of one outline of a mesh as a grid over (u,v).
class WallGrid {
 public:
  explicit WallGrid(const Mesh& mesh, std::size_t outline = 0) {
    struct Vertex {
      float v, u;
      std::uint32_t index;
    };
    std::vector<Vertex> vertices;
    for (const std::uint32_t vertex : wall_vertices(mesh, outline)) {
      const glm::vec2 uv = mesh.texcoords()[vertex];
      vertices.push_back({uv.y, uv.x, vertex});
    }
    std::sort(vertices.begin(), vertices.end(),
              [](const Vertex& a, const Vertex& b) { return std::tie(a.v, a.u) < std::tie(b.v, b.u); });
    for (const Vertex& vertex : vertices) {
      u_.push_back(vertex.u);
      if (v_.empty() || v_.back() != vertex.v) v_.push_back(vertex.v);
    }
    std::sort(u_.begin(), u_.end());
    u_.erase(std::unique(u_.begin(), u_.end()), u_.end());
    std::size_t next = 0;
    for (const float v : v_) {
      for (const float u : u_) {
        // A pole lacks the first or the last column, where it is the same place.
        while (next < vertices.size() && std::tie(vertices[next].v, vertices[next].u) < std::tie(v, u))
          ++next;
        const bool is_there = next < vertices.size() && vertices[next].v == v;
        points_.push_back(position(mesh, vertices[is_there ? next : next - 1].index));
      }
    }
  }

  /// The vertices of an outline's wall: each is an area of its own.
  static std::vector<std::uint32_t> wall_vertices(const Mesh& mesh, std::size_t outline) {
    std::vector<std::uint32_t> vertices;
    for (const GridPatch& patch : mesh.patches) {
      if (patch.area != outline) continue;
      for (std::uint32_t k = 0; k < patch.vertex_count(); ++k) vertices.push_back(patch.first_vertex + k);
    }
    return vertices;
  }

  std::size_t cells() const { return (u_.size() - 1) * (v_.size() - 1); }

  /// The distance of a point of the surface at (u, v) from the cells about it, or a number below `enough`
  /// that is no less than it. A section that comes home turned may be turned otherwise in the finer wall:
  /// then the cells of the whole row are looked at.
  double distance(const glm::dvec3& p, const glm::vec2& uv, double enough) const {
    const std::size_t column = cell(u_, uv.x);
    const std::size_t row = cell(v_, uv.y);
    double nearest = nearest_of(p, row, 1, column > 0 ? column - 1 : 0, column + 1);
    const std::size_t columns = u_.size() - 1;
    for (std::size_t i = 0; i < columns && nearest > enough; ++i) {
      nearest = std::min(nearest, nearest_of(p, row, 2, i, i));
    }
    return nearest;
  }

 private:
  double nearest_of(const glm::dvec3& p, std::size_t row, std::size_t rows_about, std::size_t first_column,
                    std::size_t last_column) const {
    double nearest = std::numeric_limits<double>::infinity();
    const std::size_t last_row = std::min(row + rows_about, v_.size() - 2);
    for (std::size_t j = row > rows_about ? row - rows_about : 0; j <= last_row; ++j) {
      for (std::size_t i = first_column; i <= std::min(last_column, u_.size() - 2); ++i) {
        const glm::dvec3& q = at(i + 1, j);
        const glm::dvec3& r = at(i, j + 1);
        nearest = std::min({nearest, distance_to_triangle(p, r, at(i, j), q),
                            distance_to_triangle(p, q, at(i + 1, j + 1), r)});
      }
    }
    return nearest;
  }

  const glm::dvec3& at(std::size_t column, std::size_t row) const {
    return points_[row * u_.size() + column];
  }
  static std::size_t cell(const std::vector<float>& line, float value) {
    const auto after = std::upper_bound(line.begin() + 1, line.end() - 1, value);
    return static_cast<std::size_t>(after - line.begin()) - 1;
  }

  std::vector<float> u_, v_;
  std::vector<glm::dvec3> points_;
};

/// The largest distance of the vertices of a far finer wall from a wall. What float32 makes of the finer
/// one's places is in it.
inline double largest_distance(const Mesh& fine, const Mesh& coarse, std::size_t outline = 0) {
  const WallGrid grid(coarse, outline);
  double largest = 0;
  for (const std::uint32_t vertex : WallGrid::wall_vertices(fine, outline)) {
    largest = std::max(largest, grid.distance(position(fine, vertex), fine.texcoords()[vertex], largest));
  }
  return largest;
}

}  // namespace sweepkit::sweep::test
