// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "sweepkit/sweep/grid_patch.hpp"

namespace sweepkit::sweep {

struct MeshTraits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::TexCoord2D);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::None);
  FaceAttributes(OpenMesh::Attributes::None);
};

/// The product of libsweep: an OpenMesh mesh with position, unit normal and (u,v) at every vertex, and with
/// it the flat triangle list and the grid shape that drawing and export want. Half-edges are there when they
/// were asked for (SweepOptions::has_half_edges); without them n_faces() is 0 and the triangle list is the
/// connectivity. Positions are float32 relative to `origin`.
class Mesh : public OpenMesh::TriMesh_ArrayKernelT<MeshTraits> {
 public:
  std::vector<Triangle> triangles;
  std::vector<GridPatch> patches;  ///< in order of their triangles; caps belong to none
  std::vector<Area> areas;         ///< in order; together all triangles
  glm::dvec3 origin{0.0};
  /// The largest distance measured between the surface and the mesh, metres, where a tolerance was
  /// asked for.
  std::optional<double> deviation;

  /// Spans over OpenMesh's own storage, valid until the number of vertices changes.
  std::span<const glm::vec3> positions() const;
  std::span<const glm::vec3> normals() const;
  std::span<const glm::vec2> texcoords() const;
  std::span<glm::vec3> positions();
  std::span<glm::vec3> normals();
  std::span<glm::vec2> texcoords();

  /// Bytes of the vertices, the triangle list and the half-edges.
  std::size_t bytes() const;
  std::size_t half_edge_bytes() const;
};

/// Throws InputError for a mesh of more triangles than 32-bit indices can count.
void check_triangle_count(std::uint64_t triangles);

/// The most by which a linear map lengthens a distance: exact where its columns are perpendicular, as of
/// scaling before turning, and a bound on it otherwise.
double largest_stretch(const glm::dmat3& map);

/// Appends `part`, moved by `mesh_from_part` (affine and invertible; a mirroring one turns the triangles
/// round), with its patches, areas and half-edges; the deviation is known where it is of both. Precondition:
/// both have half-edges or neither, unless one is empty.
void append(Mesh& mesh, const Mesh& part, const glm::dmat4& mesh_from_part);

}  // namespace sweepkit::sweep
