// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <limits>
#include <map>
#include <vector>

#include "sweepkit/sweep/mesh.hpp"

namespace sweepkit::sweep::test {

inline glm::dvec3 position(const Mesh& mesh, std::uint32_t vertex) {
  return glm::dvec3(mesh.positions()[vertex]) + mesh.origin;
}

/// What welding equal positions shows of a mesh, and its size.
struct Measures {
  double volume = 0;
  double area = 0;
  double smallest_triangle = std::numeric_limits<double>::infinity();
  double worst_normal_cosine = 1;  ///< between a triangle and its vertices' normals
  double worst_normal_length = 0;  ///< |1 - length|
  std::size_t open_edges = 0;      ///< directed edges without their opposite, or twice
  std::size_t leaking_edges = 0;   ///< that are there more often one way than the other
  long euler = 0;                  ///< V - E + F after welding
};

inline Measures measure(const Mesh& mesh) {
  Measures m;
  std::map<std::array<float, 3>, std::uint32_t> welded;
  std::vector<std::uint32_t> id;
  for (const glm::vec3& p : mesh.positions()) {
    // -0 and 0 are one place.
    id.push_back(welded.emplace(std::array<float, 3>{p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}, welded.size())
                     .first->second);
  }
  for (const glm::vec3& n : mesh.normals()) {
    m.worst_normal_length = std::max(m.worst_normal_length, std::abs(glm::length(glm::dvec3(n)) - 1));
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Triangle& t : mesh.triangles) {
    const glm::dvec3 a = position(mesh, t[0]);
    const glm::dvec3 b = position(mesh, t[1]);
    const glm::dvec3 c = position(mesh, t[2]);
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    const double area = 0.5 * glm::length(cross);
    m.volume += glm::dot(a, glm::cross(b, c)) / 6;
    m.area += area;
    m.smallest_triangle = std::min(m.smallest_triangle, area);
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[{id[t[k]], id[t[(k + 1) % 3]]}];
      m.worst_normal_cosine =
          std::min(m.worst_normal_cosine, glm::dot(cross, glm::dvec3(mesh.normals()[t[k]])) / (2 * area));
    }
  }
  std::size_t undirected = 0;
  for (const auto& [edge, count] : edges) {
    const auto opposite = edges.find({edge.second, edge.first});
    if (count != 1 || opposite == edges.end()) ++m.open_edges;
    if (opposite == edges.end() || opposite->second != count) ++m.leaking_edges;
    if (edge.first < edge.second || opposite == edges.end()) ++undirected;
  }
  m.euler = static_cast<long>(welded.size()) - static_cast<long>(undirected) +
            static_cast<long>(mesh.triangles.size());
  return m;
}

}  // namespace sweepkit::sweep::test
