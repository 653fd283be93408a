// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/sweep/mesh.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "sweepkit/error.hpp"

namespace sweepkit::sweep {

// OpenMesh keeps each property in one contiguous vector of VectorT<float, N>, an array of N floats as glm's
// vectors are; the spans look at the same storage under glm's name.
static_assert(sizeof(OpenMesh::Vec3f) == sizeof(glm::vec3) && sizeof(OpenMesh::Vec2f) == sizeof(glm::vec2));

std::span<const glm::vec3> Mesh::positions() const {
  return {reinterpret_cast<const glm::vec3*>(points()), n_vertices()};
}
std::span<const glm::vec3> Mesh::normals() const {
  return {reinterpret_cast<const glm::vec3*>(vertex_normals()), n_vertices()};
}
std::span<const glm::vec2> Mesh::texcoords() const {
  return {reinterpret_cast<const glm::vec2*>(texcoords2D()), n_vertices()};
}

// OpenMesh hands out its storage read-only through these; writing in place is what its own set_point() does.
std::span<glm::vec3> Mesh::positions() {
  return {reinterpret_cast<glm::vec3*>(const_cast<Point*>(points())), n_vertices()};
}
std::span<glm::vec3> Mesh::normals() {
  return {reinterpret_cast<glm::vec3*>(const_cast<Normal*>(vertex_normals())), n_vertices()};
}
std::span<glm::vec2> Mesh::texcoords() {
  return {reinterpret_cast<glm::vec2*>(const_cast<TexCoord2D*>(texcoords2D())), n_vertices()};
}

// OpenMesh keeps a byte for every item's own data, even where the traits give it none.
constexpr std::size_t kItemData = 1;

std::size_t Mesh::half_edge_bytes() const {
  // Edges and faces of the connectivity. A vertex has its handle whether edges exist or not.
  return n_edges() * (sizeof(OpenMesh::ArrayItems::Edge) + 3 * kItemData) +
         n_faces() * (sizeof(OpenMesh::ArrayItems::Face) + kItemData);
}

std::size_t Mesh::bytes() const {
  constexpr std::size_t kVertexBytes =
      2 * sizeof(glm::vec3) + sizeof(glm::vec2) + sizeof(OpenMesh::ArrayItems::Vertex) + kItemData;
  return n_vertices() * kVertexBytes + triangles.size() * sizeof(Triangle) + half_edge_bytes();
}

void check_triangle_count(std::uint64_t triangles) {
  // 32-bit half-edge handles are the nearest end: three a triangle.
  if (triangles * 3 > std::numeric_limits<std::int32_t>::max())
    throw InputError("has too many triangles for 32-bit indices; ask for fewer cells");
}

double largest_stretch(const glm::dmat3& map) {
  const glm::dmat3 squares = glm::transpose(map) * map;
  double most = 0;
  for (int row = 0; row < 3; ++row) {
    most = std::max(most, std::abs(squares[0][row]) + std::abs(squares[1][row]) + std::abs(squares[2][row]));
  }
  return std::sqrt(most);
}

void append(Mesh& mesh, const Mesh& part, const glm::dmat4& mesh_from_part) {
  assert(mesh.triangles.empty() || part.triangles.empty() || (mesh.n_faces() > 0) == (part.n_faces() > 0));
  const glm::dmat3 linear(mesh_from_part);
  const glm::dmat3 normal_from_part = glm::transpose(glm::inverse(linear));
  const bool is_mirrored = glm::determinant(linear) < 0;
  const double stretch = largest_stretch(linear);
  if (mesh.n_vertices() == 0) {
    mesh.deviation = part.deviation ? std::optional(stretch * *part.deviation) : std::nullopt;
  } else if (mesh.deviation && part.deviation) {
    mesh.deviation = std::max(*mesh.deviation, stretch * *part.deviation);
  } else {
    mesh.deviation.reset();
  }
  if (mesh.n_vertices() == 0) mesh.origin = glm::dvec3(mesh_from_part * glm::dvec4(part.origin, 1));

  const auto first_vertex = static_cast<std::uint32_t>(mesh.n_vertices());
  const auto first_triangle = static_cast<std::uint32_t>(mesh.triangles.size());
  const auto first_edge = static_cast<int>(mesh.n_edges());
  const auto first_face = static_cast<int>(mesh.n_faces());
  const auto first_area = static_cast<std::uint32_t>(mesh.areas.size());
  mesh.resize(mesh.n_vertices() + part.n_vertices(), mesh.n_edges() + part.n_edges(),
              mesh.n_faces() + part.n_faces());

  const std::span<glm::vec3> positions = mesh.positions().subspan(first_vertex);
  const std::span<glm::vec3> normals = mesh.normals().subspan(first_vertex);
  const std::span<glm::vec2> texcoords = mesh.texcoords().subspan(first_vertex);
  for (std::size_t i = 0; i < part.n_vertices(); ++i) {
    const glm::dvec3 local = glm::dvec3(part.positions()[i]) + part.origin;
    positions[i] = glm::vec3(glm::dvec3(mesh_from_part * glm::dvec4(local, 1)) - mesh.origin);
    normals[i] = glm::vec3(glm::normalize(normal_from_part * glm::dvec3(part.normals()[i])));
    texcoords[i] = part.texcoords()[i];
  }
  for (const Triangle& t : part.triangles) {
    // A mirror turns the triangles round; A and C change places, so B keeps the right angle.
    mesh.triangles.push_back(is_mirrored
                                 ? Triangle{first_vertex + t[2], first_vertex + t[1], first_vertex + t[0]}
                                 : Triangle{first_vertex + t[0], first_vertex + t[1], first_vertex + t[2]});
  }
  for (GridPatch patch : part.patches) {
    patch.first_vertex += first_vertex;
    patch.first_triangle += first_triangle;
    patch.area += first_area;
    mesh.patches.push_back(patch);
  }
  for (Area area : part.areas) {
    area.first_triangle += first_triangle;
    mesh.areas.push_back(area);
  }

  const auto moved_vertex = [&](OpenMesh::VertexHandle v) {
    return OpenMesh::VertexHandle(v.idx() + static_cast<int>(first_vertex));
  };
  const auto moved_half = [&](OpenMesh::HalfedgeHandle h) {
    return OpenMesh::HalfedgeHandle(h.idx() + 2 * first_edge);
  };
  for (std::size_t i = 0; i < part.n_halfedges(); ++i) {
    const OpenMesh::HalfedgeHandle h(static_cast<int>(i));
    // Turned round, every half-edge runs the other way and its next becomes its previous.
    mesh.set_vertex_handle(moved_half(h),
                           moved_vertex(is_mirrored ? part.from_vertex_handle(h) : part.to_vertex_handle(h)));
    mesh.set_next_halfedge_handle(
        moved_half(h), moved_half(is_mirrored ? part.prev_halfedge_handle(h) : part.next_halfedge_handle(h)));
    if (part.is_boundary(h)) {
      mesh.set_boundary(moved_half(h));
    } else {
      mesh.set_face_handle(moved_half(h), OpenMesh::FaceHandle(part.face_handle(h).idx() + first_face));
    }
  }
  for (std::size_t i = 0; i < part.n_faces(); ++i) {
    const OpenMesh::FaceHandle f(static_cast<int>(i));
    mesh.set_halfedge_handle(OpenMesh::FaceHandle(f.idx() + first_face), moved_half(part.halfedge_handle(f)));
  }
  if (part.n_halfedges() == 0) return;
  for (std::size_t i = 0; i < part.n_vertices(); ++i) {
    const OpenMesh::VertexHandle v(static_cast<int>(i));
    OpenMesh::HalfedgeHandle out = part.halfedge_handle(v);
    // The same loop or face leaves the vertex by the twin of the half-edge that came in before.
    if (is_mirrored) out = part.prev_halfedge_handle(out);
    mesh.set_halfedge_handle(moved_vertex(v), moved_half(out));
  }
}

}  // namespace sweepkit::sweep
