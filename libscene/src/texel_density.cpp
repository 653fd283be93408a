// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// On a triangle (u,v) is linear: the surface's derivatives by u and v are constant there. Their lengths are
// weighed by the triangle's area.

#include "sweepkit/scene/texel_density.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sweepkit/texmap/bake.hpp"

namespace sweepkit::scene {
namespace {

glm::dvec2 lengths_of(const MeshView& mesh, std::span<const sweep::Triangle> triangles,
                      const glm::dmat3& world_from_object) {
  glm::dvec2 sum(0.0);
  double whole = 0;
  for (const auto& [a, b, c] : triangles) {
    const glm::dvec3 p = world_from_object * glm::dvec3(mesh.positions[b] - mesh.positions[a]);
    const glm::dvec3 q = world_from_object * glm::dvec3(mesh.positions[c] - mesh.positions[a]);
    const glm::dvec2 s(mesh.texcoords[b] - mesh.texcoords[a]);
    const glm::dvec2 t(mesh.texcoords[c] - mesh.texcoords[a]);
    const double in_uv = s.x * t.y - s.y * t.x;
    const double area = glm::length(glm::cross(p, q));
    if (in_uv == 0 || !(area > 0)) continue;
    sum +=
        area / std::abs(in_uv) * glm::dvec2(glm::length(t.y * p - s.y * q), glm::length(s.x * q - t.x * p));
    whole += area;
  }
  return whole > 0 ? sum / whole : glm::dvec2(0.0);
}

glm::dvec2 extent_of(const MeshView& mesh, std::span<const sweep::Triangle> triangles) {
  glm::dvec2 low(std::numeric_limits<double>::infinity());
  glm::dvec2 high(-std::numeric_limits<double>::infinity());
  for (const sweep::Triangle& triangle : triangles) {
    for (const std::uint32_t vertex : triangle) {
      low = glm::min(low, glm::dvec2(mesh.texcoords[vertex]));
      high = glm::max(high, glm::dvec2(mesh.texcoords[vertex]));
    }
  }
  return triangles.empty() ? glm::dvec2(0.0) : high - low;
}

// Metres along u and v of the largest sheet, each way.
glm::dvec2 largest_sheet(const MeshView& mesh, std::span<const std::uint32_t> ends,
                         const glm::dmat3& world_from_object) {
  glm::dvec2 largest(0.0);
  std::uint32_t first = 0;
  for (const std::uint32_t end : ends) {
    const auto sheet = mesh.triangles.subspan(first, end - first);
    largest = glm::max(largest, extent_of(mesh, sheet) * lengths_of(mesh, sheet, world_from_object));
    first = end;
  }
  return largest;
}

double whole_texels(double texels) {
  return std::max(std::round(texels), 1.0);
}

glm::ivec2 whole_texels(const glm::dvec2& texels) {
  return {static_cast<int>(whole_texels(texels.x)), static_cast<int>(whole_texels(texels.y))};
}

}  // namespace

glm::dvec2 texcoord_lengths(const MeshView& mesh, const glm::dmat3& world_from_object) {
  return lengths_of(mesh, mesh.triangles, world_from_object);
}

glm::ivec2 bake_size_of(const MeshView& mesh, const glm::dmat3& world_from_object,
                        const texmap::Texture& texture, const BakeSize& wanted) {
  glm::dvec2 lengths;
  glm::ivec2 cells(1);
  bool has_gutter = false;
  const auto* procedural = std::get_if<texmap::Procedural>(&texture);
  if (procedural != nullptr && !texmap::repeats_in_unit_square(*procedural)) {
    const std::vector<std::uint32_t> ends = sheet_ends(mesh);
    lengths = largest_sheet(mesh, ends, world_from_object);
    cells = texmap::bake_cells(ends.size());
    has_gutter = ends.size() > 1 ||
                 (!mesh.areas.empty() && (mesh.areas[0].u_period > 0 || mesh.areas[0].v_period > 0));
  } else {
    lengths = texcoord_lengths(mesh, world_from_object);
  }
  if (!(lengths.x > 0 && lengths.y > 0)) return glm::ivec2(wanted.size);
  if (!wanted.density) {
    const glm::dvec2 whole = lengths * glm::dvec2(cells);
    const double size = wanted.size;
    constexpr double kLeastShare = 1.0 / 16;  // of the shorter side
    constexpr double kMostShare = 4;          // of a strip's longer one
    const double most = std::clamp<double>(wanted.most, size, kMostShare * size);
    const double density =
        std::max(size / std::max(whole.x, whole.y), kLeastShare * size / std::min(whole.x, whole.y));
    return whole_texels(glm::min(density * whole, glm::dvec2(most)));
  }
  const glm::dvec2 cell(whole_texels(lengths.x * *wanted.density), whole_texels(lengths.y * *wanted.density));
  glm::dvec2 size = cell * glm::dvec2(cells);
  // A size may be too large for an int until it is capped.
  const auto capped = [&] { return size * std::min(wanted.most / std::max(size.x, size.y), 1.0); };
  if (has_gutter) {
    // A gutter is a share of the whole, which it makes larger.
    for (int i = 0; i < 8; ++i) {
      const int gutter = texmap::bake_gutter(whole_texels(capped()));
      size = (cell + 2.0 * gutter) * glm::dvec2(cells);
    }
  }
  return whole_texels(capped());
}

}  // namespace sweepkit::scene
