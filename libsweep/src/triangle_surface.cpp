// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Three partitions of the triangles' corners, each by union-find over shared edges: smooth fans (a normal
// each), islands of (u,v) (an area each), and with them the vertices: a place, its (u,v), its normal and its
// island. Normals weighted by angle do not depend on how a face is cut into triangles [Thuermer & Wuethrich
// 1998, Computing vertex normals from polygonal facets].

#include "sweepkit/sweep/triangle_surface.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <string>
#include <unordered_map>
#include <vector>

#include "directed_edges.hpp"
#include "float_positions.hpp"
#include "half_edges.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

class Sets {
 public:
  explicit Sets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0u); }

  std::uint32_t root(std::uint32_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  // The lower root stays, so that sets are numbered by their first member.
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parents_;
};

// Corner c of triangle t.
std::uint32_t corner_index(std::uint32_t t, std::uint32_t c) {
  return 3 * t + c % 3;
}

glm::dvec3 position(const TriangleSurface& surface, std::uint32_t t, std::uint32_t c) {
  return surface.positions[surface.triangles[t][c % 3]];
}

// Unit, or 0 for a triangle without area.
std::vector<glm::dvec3> face_normals(const TriangleSurface& surface) {
  std::vector<glm::dvec3> normals;
  normals.reserve(surface.triangles.size());
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const glm::dvec3 a = position(surface, t, 0);
    const glm::dvec3 cross = glm::cross(position(surface, t, 1) - a, position(surface, t, 2) - a);
    const double length = glm::length(cross);
    normals.push_back(length > 0 ? cross / length : glm::dvec3(0.0));
  }
  return normals;
}

double angle_at(const TriangleSurface& surface, std::uint32_t t, std::uint32_t c) {
  const glm::dvec3 at = position(surface, t, c);
  const glm::dvec3 a = position(surface, t, c + 1) - at;
  const glm::dvec3 b = position(surface, t, c + 2) - at;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// A normal for every corner: the surface's own where it has one, else that of the corner's smooth fan.
std::vector<glm::vec3> corner_normals(const TriangleSurface& surface, std::span<const DirectedEdge> edges,
                                      double crease_deg) {
  const std::vector<glm::dvec3> faces = face_normals(surface);
  const double least_cosine = std::cos(crease_deg * std::numbers::pi / 180);
  Sets fans(3 * surface.triangles.size());
  for_each_edge(edges, [&](const DirectedEdge& one, const DirectedEdge* twin) {
    if (twin == nullptr) return;
    // Against rounding: a bend by the very angle is none.
    if (glm::dot(faces[one.triangle], faces[twin->triangle]) < least_cosine - 1e-9) return;
    fans.join(corner_index(one.triangle, one.corner), corner_index(twin->triangle, twin->corner + 1));
    fans.join(corner_index(one.triangle, one.corner + 1), corner_index(twin->triangle, twin->corner));
  });
  std::vector<glm::dvec3> sums(3 * surface.triangles.size(), glm::dvec3(0.0));
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::uint32_t c = 0; c < 3; ++c)
      sums[fans.root(corner_index(t, c))] += angle_at(surface, t, c) * faces[t];
  }
  std::vector<glm::vec3> normals(3 * surface.triangles.size());
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::uint32_t c = 0; c < 3; ++c) {
      glm::dvec3 normal(0.0);
      if (!surface.normals.empty()) normal = glm::dvec3(surface.normals[t][c]);
      // Scaled first: squares of the largest floats have no place in a double's square root of squares.
      const double size = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
      if (size > 0) normal /= size;
      if (!(glm::length(normal) > 0)) normal = sums[fans.root(corner_index(t, c))];
      if (!(glm::length(normal) > 0)) normal = faces[t];
      if (!(glm::length(normal) > 0)) normal = {0, 1, 0};  // no area anywhere about it
      normals[corner_index(t, c)] = glm::vec3(glm::normalize(normal));
    }
  }
  return normals;
}

glm::vec2 texcoord(const TriangleSurface& surface, std::uint32_t t, std::uint32_t c) {
  return surface.texcoords.empty() ? glm::vec2(0.0f) : surface.texcoords[t][c % 3];
}

// The island of (u,v) that each triangle belongs to, numbered by their first triangles.
std::vector<std::uint32_t> islands_of(const TriangleSurface& surface, std::span<const DirectedEdge> edges,
                                      std::uint32_t& count) {
  Sets sets(surface.triangles.size());
  for_each_edge(edges, [&](const DirectedEdge& one, const DirectedEdge* twin) {
    if (twin == nullptr) return;
    const bool is_continuous =
        texcoord(surface, one.triangle, one.corner) == texcoord(surface, twin->triangle, twin->corner + 1) &&
        texcoord(surface, one.triangle, one.corner + 1) == texcoord(surface, twin->triangle, twin->corner);
    if (is_continuous) sets.join(one.triangle, twin->triangle);
  });
  std::vector<std::uint32_t> islands(surface.triangles.size());
  count = 0;
  for (std::uint32_t t = 0; t < islands.size(); ++t) {
    const std::uint32_t root = sets.root(t);
    islands[t] = root == t ? count++ : islands[root];
  }
  return islands;
}

struct VertexKey {
  std::uint32_t place, island;
  std::array<std::uint32_t, 5> bits;  // of (u,v) and normal

  bool operator==(const VertexKey&) const = default;
};

struct VertexHash {
  std::size_t operator()(const VertexKey& key) const {
    std::uint64_t hash = key.place;
    const auto add = [&](std::uint32_t word) {
      hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    };
    add(key.island);
    for (const std::uint32_t word : key.bits) add(word);
    return hash;
  }
};

}  // namespace

Mesh mesh_of(const TriangleSurface& surface, const TriangleSurfaceOptions& options) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  const std::size_t count = surface.triangles.size();
  if (count > kMost / 3) {
    throw InputError("has " + std::to_string(count) + " triangles; at most " + std::to_string(kMost / 3) +
                     " can be numbered");
  }
  Box box{surface.positions[surface.triangles[0][0]], surface.positions[surface.triangles[0][0]]};
  for (const Triangle& triangle : surface.triangles) {
    for (const std::uint32_t place : triangle) {
      box.low = glm::min(box.low, surface.positions[place]);
      box.high = glm::max(box.high, surface.positions[place]);
    }
  }
  Mesh mesh;
  mesh.origin = choose_origin(box);

  const std::vector<DirectedEdge> edges =
      sorted_edges(surface.triangles, 0, static_cast<std::uint32_t>(count));
  const std::vector<glm::vec3> normals = corner_normals(surface, edges, options.crease_deg);
  std::uint32_t island_count = 0;
  const std::vector<std::uint32_t> islands = islands_of(surface, edges, island_count);
  for (const std::uint32_t island : islands) {
    if (island == mesh.areas.size()) mesh.areas.push_back({.continues_sheet = island > 0});
    ++mesh.areas[island].triangle_count;
  }
  std::vector<std::uint32_t> next(island_count, 0);
  for (std::uint32_t island = 1; island < island_count; ++island) {
    const Area& before = mesh.areas[island - 1];
    next[island] = mesh.areas[island].first_triangle = before.first_triangle + before.triangle_count;
  }
  std::vector<std::uint32_t> order(count);
  for (std::uint32_t t = 0; t < count; ++t) order[next[islands[t]]++] = t;

  std::unordered_map<VertexKey, std::uint32_t, VertexHash> vertices;
  vertices.reserve(surface.positions.size());
  std::vector<std::uint32_t> corners;  // by vertex, the corner that it is taken from
  mesh.triangles.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t t = order[i];
    for (std::uint32_t c = 0; c < 3; ++c) {
      // Adding 0 turns -0 into 0.
      const glm::vec2 uv = texcoord(surface, t, c) + 0.0f;
      const glm::vec3 normal = normals[corner_index(t, c)] + 0.0f;
      const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
      const VertexKey key{surface.triangles[t][c],
                          islands[t],
                          {bits(uv.x), bits(uv.y), bits(normal.x), bits(normal.y), bits(normal.z)}};
      const auto [found, is_new] = vertices.emplace(key, static_cast<std::uint32_t>(vertices.size()));
      if (is_new) corners.push_back(corner_index(t, c));
      mesh.triangles[i][c] = found->second;
    }
  }
  mesh.resize(corners.size(), 0, 0);
  const std::span<glm::vec3> out_positions = mesh.positions();
  const std::span<glm::vec3> out_normals = mesh.normals();
  const std::span<glm::vec2> out_texcoords = mesh.texcoords();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::uint32_t t = corners[i] / 3;
    const std::uint32_t c = corners[i] % 3;
    out_positions[i] = glm::vec3(position(surface, t, c) - mesh.origin);
    out_normals[i] = normals[corners[i]];
    out_texcoords[i] = texcoord(surface, t, c);
  }
  if (options.has_half_edges) write_half_edges(mesh);
  return mesh;
}

}  // namespace sweepkit::sweep
