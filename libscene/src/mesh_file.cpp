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
#include <optional>
#include <string>

#include "cut_polygon.hpp"
#include "polygon_list.hpp"
#include "sweepkit/error.hpp"
#include "text_file.hpp"
#include "weld.hpp"

namespace sweepkit::scene {
namespace {

constexpr std::size_t kLargestMesh = std::size_t{1} << 30;

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
  return extension;
}

std::optional<MeshFormat> find_format(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".obj") return MeshFormat::kObj;
  if (extension == ".ply") return MeshFormat::kPly;
  if (extension == ".stl") return MeshFormat::kStl;
  if (extension == ".off") return MeshFormat::kOff;
  return std::nullopt;
}

PolygonList read_polygons(std::string_view bytes, const std::filesystem::path& file) {
  const std::string name = file.string();
  switch (mesh_format(file)) {
    case MeshFormat::kObj:
      return read_obj(bytes, name);
    case MeshFormat::kPly:
      return read_ply(bytes, name);
    case MeshFormat::kStl:
      return read_stl(bytes, name);
    default:
      return read_off(bytes, name);
  }
}

}  // namespace

bool is_mesh_name(const std::filesystem::path& file) {
  return find_format(file).has_value();
}

MeshFormat mesh_format(const std::filesystem::path& file) {
  const std::optional<MeshFormat> format = find_format(file);
  if (format) return *format;
  throw InputError({.file = file.string()},
                   "is no mesh file: its name needs to end in .obj, .ply, .stl or .off");
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
  mesh_format(file);  // refuses the name before a byte is read
  return parse_mesh_file(read_text_file(file, kLargestMesh, "a mesh file"), file);
}

}  // namespace sweepkit::scene
