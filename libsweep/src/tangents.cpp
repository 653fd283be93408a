// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// On a triangle (u,v) is linear, so dP/du is constant there. A vertex takes the mean over its triangles,
// weighted by their angles at it, which does not depend on how a cell is cut into triangles, and is made
// perpendicular to its normal [Lengyel, Foundations of Game Engine Development 2, section 7.5].

#include "sweepkit/sweep/tangents.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace sweepkit::sweep {
namespace {

struct Sum {
  glm::dvec3 along_u{0.0};
  double handedness = 0;  ///< of the triangles' (u,v) against their winding, weighted
};

glm::dvec3 perpendicular_part(const glm::dvec3& v, const glm::dvec3& normal) {
  return v - glm::dot(v, normal) * normal;
}

glm::dvec3 any_perpendicular(const glm::dvec3& normal) {
  const glm::dvec3 axis = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(perpendicular_part(axis, normal));
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

std::vector<Sum> sum_over_triangles(std::span<const glm::vec3> positions,
                                    std::span<const glm::vec2> texcoords,
                                    std::span<const Triangle> triangles) {
  std::vector<Sum> sums(positions.size());
  for (const Triangle& triangle : triangles) {
    std::array<glm::dvec3, 3> p;
    std::array<glm::dvec2, 3> uv;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = positions[triangle[k]];
      uv[k] = texcoords[triangle[k]];
    }
    const glm::dvec2 a = uv[1] - uv[0];
    const glm::dvec2 b = uv[2] - uv[0];
    const double area = a.x * b.y - a.y * b.x;
    const glm::dvec3 along = (area < 0 ? -1.0 : 1.0) * (b.y * (p[1] - p[0]) - a.y * (p[2] - p[0]));
    const double length = glm::length(along);
    if (!(area != 0) || !(length > 0)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const double angle = angle_between(p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]);
      Sum& sum = sums[triangle[k]];
      sum.along_u += angle / length * along;
      sum.handedness += area < 0 ? -angle : angle;
    }
  }
  return sums;
}

using Place = std::array<float, 6>;

Place place_of(const glm::vec3& position, const glm::vec3& normal) {
  // Adding 0 turns -0 into 0.
  return {position.x + 0.0f, position.y + 0.0f, position.z + 0.0f,
          normal.x + 0.0f,   normal.y + 0.0f,   normal.z + 0.0f};
}

}  // namespace

std::vector<glm::vec4> find_tangents(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                     std::span<const glm::vec2> texcoords,
                                     std::span<const Triangle> triangles) {
  const std::vector<Sum> sums = sum_over_triangles(positions, texcoords, triangles);
  std::vector<glm::dvec3> tangents(positions.size());
  std::vector<double> signs(positions.size());
  std::vector<bool> is_told(positions.size());
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(normals[i]));
    const glm::dvec3 along = perpendicular_part(sums[i].along_u, normal);
    const double length = glm::length(along);
    is_told[i] = length > 1e-9 * glm::length(sums[i].along_u);
    tangents[i] = is_told[i] ? along / length : any_perpendicular(normal);
    signs[i] = sums[i].handedness < 0 ? -1 : 1;
  }

  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<Place> places(positions.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = place_of(positions[i], normals[i]);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return places[a] != places[b] ? places[a] < places[b] : a < b;
  });
  std::vector<glm::vec4> result(positions.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first;
    while (last < order.size() && places[order[last]] == places[order[first]]) ++last;
    for (std::size_t k = first; k < last; ++k) {
      const std::uint32_t i = order[k];
      glm::dvec3 sum(0.0);
      // All of a place in one order, so that both sides of a seam come out with the same bits.
      for (std::size_t m = first; m < last; ++m) {
        const std::uint32_t other = order[m];
        const bool belongs = is_told[other] && signs[other] == signs[i] &&
                             (!is_told[i] || glm::dot(tangents[other], tangents[i]) > 0);
        if (belongs) sum += tangents[other];
      }
      const glm::dvec3 tangent = glm::length(sum) > 0 ? glm::normalize(sum) : tangents[i];
      result[i] = glm::vec4(glm::vec3(tangent), static_cast<float>(signs[i]));
    }
    first = last;
  }
  return result;
}

}  // namespace sweepkit::sweep
