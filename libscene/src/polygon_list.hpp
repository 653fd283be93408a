// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace sweepkit::scene {

/// What the reader of a mesh format hands on: lists, and polygons of indices into them.
struct PolygonList {
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  struct Corner {
    std::uint32_t position;
    std::uint32_t texcoord = kNone;
    std::uint32_t normal = kNone;
  };

  std::string format;
  std::vector<glm::dvec3> positions;
  std::vector<glm::vec2> texcoords;
  std::vector<glm::vec3> normals;
  std::vector<Corner> corners;
  std::vector<std::uint32_t> ends;  ///< one past the last corner of each polygon
};

/// At most so many corners, and so many positions.
inline constexpr std::size_t kMostMeshCorners = std::size_t{3} << 26;
inline constexpr std::size_t kMostFaceCorners = 1000;

/// The readers, one a format. Indices are checked, numbers finite and in range; polygons have at least 3
/// corners. They throw InputError with `file` and the place in it.
PolygonList read_obj(std::string_view text, const std::string& file);
PolygonList read_ply(std::string_view bytes, const std::string& file);
PolygonList read_stl(std::string_view bytes, const std::string& file);
PolygonList read_off(std::string_view text, const std::string& file);

}  // namespace sweepkit::scene
