// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// OBJ numbers positions, (u,v) and normals apart. So vertices in one place share their v, and a surface that
// is closed stays closed for programs that look at v alone, while a seam keeps both its vt.

#include "byte_writer.hpp"
#include "mesh_writers.hpp"
#include "placed_surface.hpp"
#include "sweepkit/scene/bake_over.hpp"

namespace sweepkit::scene {
namespace {

template <glm::length_t D, class T>
void put_line(ByteWriter& out, std::string_view kind, const glm::vec<D, T>& values) {
  out.text(kind);
  for (glm::length_t k = 0; k < D; ++k) {
    out.text(" ");
    out.number(static_cast<double>(values[k]));
  }
  out.text("\n");
}

std::vector<glm::vec2> texcoords_of(const MeshView& mesh, const ObjMaterials::Use& use) {
  std::vector<glm::vec2> texcoords = baked_texcoords(mesh, *use.transforms);
  for (glm::vec2& uv : texcoords) uv *= use.uv_factor;
  return texcoords;
}

}  // namespace

WrittenMesh write_obj(const Scene& scene, const std::string& title, ObjMaterials& materials) {
  ByteWriter out;
  // What the lines of a vertex (v, vt, vn) and of a triangle commonly take; longer ones let it grow.
  const MeshCounts counts = count_meshes(scene);
  out.bytes.reserve(100 * counts.vertices + 60 * counts.triangles);
  out.text("# " + title + "\n");
  if (materials.are_needed()) out.text("mtllib " + materials.file() + "\n");
  UniqueNames names;
  std::uint64_t position_count = 0;  // of the objects before
  std::uint64_t vertex_count = 0;
  std::uint64_t face_count = 0;
  for (const Object& object : scene.objects) {
    const MeshView& mesh = scene.meshes[object.mesh];
    const PlacedSurface surface = place_surface(mesh, object);
    const ObjMaterials::Use use = materials.use(object);
    out.text("o " + names.unique(object.name) + "\n");
    for (const glm::dvec3& p : surface.positions) put_line(out, "v", p);
    for (const glm::vec2& uv : texcoords_of(mesh, use)) put_line(out, "vt", uv);
    for (const glm::vec3& n : surface.normals) put_line(out, "vn", n);
    if (materials.are_needed()) out.text("usemtl " + use.name + "\n");
    for (const sweep::Triangle& t : surface.triangles) {
      out.text("f");
      for (const std::uint32_t vertex : t) {
        const std::uint64_t of_vertex = vertex_count + vertex + 1;
        out.text(" ");
        out.whole(position_count + surface.places[vertex] + 1);
        out.text("/");
        out.whole(of_vertex);
        out.text("/");
        out.whole(of_vertex);
      }
      out.text("\n");
    }
    position_count += surface.positions.size();
    vertex_count += surface.places.size();
    face_count += surface.triangles.size();
  }
  return {std::move(out.bytes), face_count};
}

}  // namespace sweepkit::scene
