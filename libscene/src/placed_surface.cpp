// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "placed_surface.hpp"

#include <utility>

#include "message_text.hpp"
#include "sweepkit/error.hpp"
#include "weld.hpp"

namespace sweepkit::scene {

PlacedSurface place_surface(const MeshView& mesh, const Object& object) {
  const glm::dmat3 linear(object.world_from_object);
  const glm::dvec3 offset(object.world_from_object[3]);
  PlacedSurface placed;
  std::vector<glm::dvec3> all;
  all.reserve(mesh.positions.size());
  for (const glm::vec3& p : mesh.positions) all.push_back(linear * (mesh.origin + glm::dvec3(p)) + offset);
  placed.positions = weld(all, placed.places);

  // A normal is a covector. Where nothing turns or stretches it, it stays the same to the bit.
  placed.normals.assign(mesh.normals.begin(), mesh.normals.end());
  if (linear != glm::dmat3(1.0)) {
    const glm::dmat3 covectors = glm::transpose(glm::inverse(linear));
    for (glm::vec3& n : placed.normals) {
      const glm::dvec3 turned = covectors * glm::dvec3(n);
      const double length = glm::length(turned);
      if (length > 0) n = glm::vec3(turned / length);
    }
  }

  const bool is_mirrored = glm::determinant(linear) < 0;
  placed.triangles.reserve(mesh.triangles.size());
  for (sweep::Triangle t : mesh.triangles) {
    const std::uint32_t a = placed.places[t[0]];
    const std::uint32_t b = placed.places[t[1]];
    const std::uint32_t c = placed.places[t[2]];
    if (a == b || b == c || c == a) continue;
    if (is_mirrored) std::swap(t[0], t[2]);
    placed.triangles.push_back(t);
  }
  if (placed.triangles.empty()) {
    throw InputError("the object " + in_quotes(object.name) +
                     " has no triangles; give it an extent, or write the other objects by name");
  }
  return placed;
}

}  // namespace sweepkit::scene
