// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The formats are read here and not by OpenMesh's readers, which were tried: Debian's 9.0 ends the program at
// "f /1 2 3", believes the counts of a short OFF file for minutes, leaves faces with wrong indices and
// vertices that are NaN out and calls the file read, opens what mtllib names, keeps positions as float32 and
// one normal a vertex, and has one state for all threads. tests/scene/mesh_file_test.cpp reads sound files by
// both.

#include "sweepkit/scene/mesh_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "cut_polygon.hpp"
#include "polygon_list.hpp"
#include "sweepkit/error.hpp"
#include "text_file.hpp"

namespace sweepkit::scene {
namespace {

constexpr std::size_t kLargestMesh = std::size_t{1} << 30;

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
  return extension;
}

PolygonList read_polygons(std::string_view bytes, const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  const std::string name = file.string();
  if (extension == ".obj") return read_obj(bytes, name);
  if (extension == ".ply") return read_ply(bytes, name);
  if (extension == ".stl") return read_stl(bytes, name);
  if (extension == ".off") return read_off(bytes, name);
  throw InputError({.file = name},
                   "is no mesh that is read: its name needs to end in .obj, .ply, .stl or .off");
}

// Positions once each, in the order of their first index; `places` maps the file's indices to them. An open
// hash table of indices, at most half full.
std::vector<glm::dvec3> weld(std::span<const glm::dvec3> all, std::vector<std::uint32_t>& places) {
  constexpr std::uint32_t kEmpty = 0xFFFFFFFF;
  std::vector<glm::dvec3> once;
  const std::size_t mask = std::bit_ceil(2 * all.size() + 2) - 1;
  std::vector<std::uint32_t> table(mask + 1, kEmpty);
  places.reserve(all.size());
  for (const glm::dvec3& given : all) {
    const glm::dvec3 p = given + 0.0;  // -0 and 0 are one place
    std::uint64_t hash = 0;
    for (glm::length_t k = 0; k < 3; ++k) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(p[k])) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
    std::size_t slot = hash & mask;
    while (table[slot] != kEmpty && once[table[slot]] != p) slot = (slot + 1) & mask;
    if (table[slot] == kEmpty) {
      table[slot] = static_cast<std::uint32_t>(once.size());
      once.push_back(p);
    }
    places.push_back(table[slot]);
  }
  return once;
}

}  // namespace

bool is_mesh_name(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  return extension == ".obj" || extension == ".ply" || extension == ".stl" || extension == ".off";
}

MeshFile parse_mesh_file(std::string_view bytes, const std::filesystem::path& file) {
  const Place place{.file = file.string()};
  if (bytes.empty()) throw InputError(place, "is empty");
  const PolygonList list = read_polygons(bytes, file);
  MeshFile mesh;
  mesh.format = list.format;
  mesh.bytes = bytes.size();
  mesh.polygons = list.ends.size();
  std::vector<std::uint32_t> places;
  mesh.positions = weld(list.positions, places);

  const auto with = [&](auto&& has) {
    return static_cast<std::size_t>(std::count_if(list.corners.begin(), list.corners.end(), has));
  };
  const std::size_t texcoords =
      with([](const PolygonList::Corner& c) { return c.texcoord != PolygonList::kNone; });
  const bool has_normals =
      with([](const PolygonList::Corner& c) { return c.normal != PolygonList::kNone; }) > 0;
  if (texcoords > 0 && texcoords < list.corners.size()) {
    throw InputError(place, "gives (u,v) to " + std::to_string(texcoords) + " of its " +
                                std::to_string(list.corners.size()) +
                                " corners; give them to all, or to none and they are laid out");
  }
  std::uint32_t first = 0;
  std::vector<glm::dvec3> outline;
  for (const std::uint32_t end : list.ends) {
    outline.clear();
    for (std::uint32_t c = first; c < end; ++c) outline.push_back(list.positions[list.corners[c].position]);
    for (const auto& triangle : cut_polygon(outline)) {
      std::array<std::uint32_t, 3> vertices{};
      std::array<glm::vec2, 3> uv{};
      std::array<glm::vec3, 3> normals{};
      for (std::size_t k = 0; k < 3; ++k) {
        const PolygonList::Corner& corner = list.corners[first + triangle[k]];
        vertices[k] = places[corner.position];
        if (texcoords > 0) uv[k] = list.texcoords[corner.texcoord];
        if (corner.normal != PolygonList::kNone) normals[k] = list.normals[corner.normal];
      }
      if (vertices[0] == vertices[1] || vertices[1] == vertices[2] || vertices[2] == vertices[0]) {
        ++mesh.degenerate;
        continue;
      }
      mesh.triangles.push_back(vertices);
      if (texcoords > 0) mesh.texcoords.push_back(uv);
      if (has_normals) mesh.normals.push_back(normals);
    }
    first = end;
  }
  if (mesh.triangles.empty()) {
    throw InputError(place, mesh.polygons == 0 ? "has no faces; a mesh needs at least one triangle"
                                               : "has no triangle with three corners at different places");
  }
  return mesh;
}

MeshFile read_mesh_file(const std::filesystem::path& file) {
  if (!is_mesh_name(file)) read_polygons({}, file);  // refuses the name before a byte is read
  return parse_mesh_file(read_text_file(file, kLargestMesh, "a mesh file"), file);
}

}  // namespace sweepkit::scene
