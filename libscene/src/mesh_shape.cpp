// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "mesh_shape.hpp"

#include "sweepkit/error.hpp"
#include "sweepkit/scene/mesh_file.hpp"
#include "sweepkit/sweep/triangle_surface.hpp"
#include "sweepkit/texmap/right_triangle_layout.hpp"

namespace sweepkit::scene {
namespace {

template <class T>
void turn(std::array<T, 3>& corners, std::size_t middle) {
  corners = {corners[(middle + 2) % 3], corners[middle], corners[(middle + 1) % 3]};
}

// Gives the file the (u,v) that it lacks, and turns each triangle so that B stands in the middle.
void lay_out(MeshFile& file, Cost& cost) {
  std::vector<glm::vec3> positions;
  positions.reserve(file.positions.size());
  // As near to 0 as can be before they lose digits.
  for (const glm::dvec3& p : file.positions) positions.push_back(glm::vec3(p - file.positions.front()));
  const texmap::RightTriangleLayout layout = texmap::lay_out_right_triangles(positions, file.triangles);
  cost.calls += 1;
  cost.bytes += layout.halves.size() * sizeof(texmap::HalfCell);
  file.texcoords.resize(file.triangles.size());
  for (std::size_t t = 0; t < file.triangles.size(); ++t) {
    const std::array<glm::dvec2, 3> uv = layout.texcoords(t);
    for (std::size_t k = 0; k < 3; ++k) file.texcoords[t][k] = glm::vec2(uv[k]);
    const std::size_t b = layout.halves[t].b;
    turn(file.triangles[t], b);
    turn(file.texcoords[t], b);
    if (!file.normals.empty()) turn(file.normals[t], b);
  }
}

}  // namespace

sweep::Mesh make_mesh_shape(const Piece& piece, const MeshShape& shape, const MeshNeeds& needs,
                            Cost& layout_cost) {
  try {
    MeshFile file = read_mesh_file(shape.file);
    if (file.texcoords.empty() && needs.layout) lay_out(file, layout_cost);
    for (auto& triangle : file.texcoords) {
      for (glm::vec2& uv : triangle) uv = glm::vec2(glm::dvec2(uv) * piece.uv.repeat);
    }
    try {
      return sweep::mesh_of({file.positions, file.triangles, file.texcoords, file.normals},
                            {piece.crease_deg, needs.half_edges});
    } catch (const InputError& error) {
      throw InputError({.file = shape.file.string()}, error.problem());
    }
  } catch (const InputError& error) {
    throw InputError(piece.place, error.what());
  }
}

}  // namespace sweepkit::scene
