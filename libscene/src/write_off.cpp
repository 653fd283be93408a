// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// OFF as every reader knows it: positions and faces. Normals and (u,v) would need a header (STNOFF) that many
// refuse; a comment ends the reading of some.

#include "byte_writer.hpp"
#include "mesh_writers.hpp"
#include "placed_surface.hpp"

namespace sweepkit::scene {

WrittenMesh write_off(const Scene& scene) {
  ByteWriter vertices;
  ByteWriter faces;
  // What lines commonly take; longer ones let it grow.
  const MeshCounts counts = count_meshes(scene);
  vertices.bytes.reserve(36 * counts.vertices);
  faces.bytes.reserve(26 * counts.triangles);
  std::uint64_t vertex_count = 0;
  std::uint64_t face_count = 0;
  for (const Object& object : scene.objects) {
    const PlacedSurface surface = place_surface(scene.meshes[object.mesh], object);
    for (const glm::dvec3& p : surface.positions) {
      for (glm::length_t k = 0; k < 3; ++k) {
        if (k > 0) vertices.text(" ");
        vertices.number(p[k]);
      }
      vertices.text("\n");
    }
    for (const sweep::Triangle& t : surface.triangles) {
      faces.text("3");
      for (const std::uint32_t vertex : t) {
        faces.text(" ");
        faces.whole(vertex_count + surface.places[vertex]);
      }
      faces.text("\n");
    }
    vertex_count += surface.positions.size();
    face_count += surface.triangles.size();
  }
  ByteWriter out;
  out.text("OFF\n" + std::to_string(vertex_count) + " " + std::to_string(face_count) + " 0\n");
  out.bytes.reserve(out.bytes.size() + vertices.bytes.size() + faces.bytes.size());
  out.bytes.insert(out.bytes.end(), vertices.bytes.begin(), vertices.bytes.end());
  out.bytes.insert(out.bytes.end(), faces.bytes.begin(), faces.bytes.end());
  return {std::move(out.bytes), face_count};
}

}  // namespace sweepkit::scene
