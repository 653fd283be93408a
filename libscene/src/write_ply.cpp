// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// PLY, binary, little endian. Normals and (u,v) belong to vertices, so that these stay as the mesh has them:
// a seam is two vertices in one place. s and t are the names of (u,v) that most programs read.

#include <algorithm>
#include <limits>

#include "byte_writer.hpp"
#include "mesh_writers.hpp"
#include "placed_surface.hpp"

namespace sweepkit::scene {
namespace {

// Would float32 blur the object? Its own float32 positions have steps of 2^-24 of its size at the finest and
// places that far off steps of 2^-24 of their distance: beyond 16 sizes four bits of the surface are lost.
bool is_far(const PlacedSurface& surface) {
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (const glm::dvec3& p : surface.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const glm::dvec3 farthest = glm::max(glm::abs(low), glm::abs(high));
  return std::max({farthest.x, farthest.y, farthest.z}) > 16 * glm::distance(low, high);
}

void put_vertices(ByteWriter& out, const PlacedSurface& surface, const MeshView& mesh, bool has_doubles) {
  for (std::size_t v = 0; v < surface.places.size(); ++v) {
    const glm::dvec3& p = surface.positions[surface.places[v]];
    for (glm::length_t k = 0; k < 3; ++k) {
      if (has_doubles) {
        out.little_endian(p[k]);
      } else {
        out.little_endian(static_cast<float>(p[k]));
      }
    }
    for (glm::length_t k = 0; k < 3; ++k) out.little_endian(surface.normals[v][k]);
    for (glm::length_t k = 0; k < 2; ++k) out.little_endian(mesh.texcoords[v][k]);
  }
}

}  // namespace

WrittenMesh write_ply(const Scene& scene, const std::string& title) {
  std::vector<PlacedSurface> surfaces;
  surfaces.reserve(scene.objects.size());
  bool has_doubles = false;
  std::uint64_t vertex_count = 0;
  std::uint64_t face_count = 0;
  for (const Object& object : scene.objects) {
    const PlacedSurface& surface = surfaces.emplace_back(place_surface(scene.meshes[object.mesh], object));
    has_doubles |= is_far(surface);
    vertex_count += surface.places.size();
    face_count += surface.triangles.size();
  }
  const std::string real = has_doubles ? "double" : "float";
  ByteWriter out;
  out.text("ply\nformat binary_little_endian 1.0\ncomment " + title + "\nelement vertex " +
           std::to_string(vertex_count) + "\n");
  for (const char* name : {"x", "y", "z"}) out.text("property " + real + " " + name + "\n");
  for (const char* name : {"nx", "ny", "nz", "s", "t"})
    out.text(std::string("property float ") + name + "\n");
  out.text("element face " + std::to_string(face_count) +
           "\nproperty list uchar int vertex_indices\nend_header\n");
  out.bytes.reserve(out.bytes.size() + vertex_count * (has_doubles ? 44 : 32) + face_count * 13);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    put_vertices(out, surfaces[i], scene.meshes[scene.objects[i].mesh], has_doubles);
  std::uint32_t first = 0;
  for (const PlacedSurface& surface : surfaces) {
    for (const sweep::Triangle& t : surface.triangles) {
      out.little_endian(std::uint8_t{3});
      for (const std::uint32_t vertex : t) out.little_endian(first + vertex);
    }
    first += static_cast<std::uint32_t>(surface.places.size());
  }
  return {std::move(out.bytes), face_count};
}

}  // namespace sweepkit::scene
