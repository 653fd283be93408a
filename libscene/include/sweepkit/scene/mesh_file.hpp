// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace sweepkit::scene {

/// What a mesh file holds, as triangles. Positions are metres as they stand in the file, each once.
struct MeshFile {
  std::string format;  ///< "OBJ", "PLY, binary", ...
  std::size_t bytes = 0;
  std::size_t polygons = 0;    ///< faces, whatever their number of corners
  std::size_t degenerate = 0;  ///< triangles left out because two of their corners are one place
  std::vector<glm::dvec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< not empty, in the file's order and winding
  std::vector<std::array<glm::vec2, 3>> texcoords;      ///< by triangle and corner; empty: the file has none
  std::vector<std::array<glm::vec3, 3>> normals;        ///< the same; 0 for corners that the file gives none
};

/// Does the name end in .obj, .ply, .stl or .off, in any case?
bool is_mesh_name(const std::filesystem::path& file);

enum class MeshFormat { kObj, kPly, kStl, kOff };

/// By what the name ends in. Throws InputError for another name.
MeshFormat mesh_format(const std::filesystem::path& file);

/// Reads a mesh by what its name ends in: OBJ (faces with (u,v) and normals at corners; groups and materials
/// are passed over), PLY (ascii and binary of both orders, (u,v) at vertices or as a list at faces), STL
/// (ascii and binary), OFF (ascii, with N and ST). Polygons are cut into triangles. Throws InputError with
/// file and, for text, line and column: missing, unreadable, over 1 GiB, another format, cut short, numbers
/// that are none or not finite or farther than 1e9 from 0, indices out of range, faces of fewer than 3 or
/// more than 1000 corners, some corners with (u,v) and some without, no triangles, more than 2^26 of them.
MeshFile read_mesh_file(const std::filesystem::path& file);

/// The same from a file's bytes; `file` tells the format and names it in messages.
MeshFile parse_mesh_file(std::string_view bytes, const std::filesystem::path& file);

}  // namespace sweepkit::scene
