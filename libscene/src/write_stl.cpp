// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Binary STL: 80 bytes of title, a count, 50 bytes a facet. The title may not begin with "solid", by which
// readers know text.

#include <algorithm>
#include <bit>

#include "byte_writer.hpp"
#include "mesh_writers.hpp"
#include "placed_surface.hpp"

namespace sweepkit::scene {
namespace {

constexpr std::size_t kTitle = 80;

void put(ByteWriter& out, const glm::vec3& v) {
  for (glm::length_t k = 0; k < 3; ++k) out.little_endian(v[k]);
}

}  // namespace

WrittenMesh write_stl(const Scene& scene, const std::string& title) {
  ByteWriter out;
  out.bytes.reserve(kTitle + 4 + 50 * count_meshes(scene).triangles);
  out.text(title.substr(0, kTitle));
  out.bytes.resize(kTitle, std::byte{' '});
  out.little_endian(std::uint32_t{0});
  std::uint32_t count = 0;
  for (const Object& object : scene.objects) {
    const PlacedSurface surface = place_surface(scene.meshes[object.mesh], object);
    for (const sweep::Triangle& t : surface.triangles) {
      const auto at = [&](std::size_t k) { return surface.positions[surface.places[t[k]]]; };
      const glm::dvec3 cross = glm::cross(at(1) - at(0), at(2) - at(0));
      const double length = glm::length(cross);
      put(out, length > 0 ? glm::vec3(cross / length) : glm::vec3(0.0f));
      for (std::size_t k = 0; k < 3; ++k) put(out, glm::vec3(at(k)));
      out.little_endian(std::uint16_t{0});
      ++count;
    }
  }
  ByteWriter counted;
  counted.little_endian(count);
  std::copy(counted.bytes.begin(), counted.bytes.end(), out.bytes.begin() + kTitle);
  return {std::move(out.bytes), count};
}

}  // namespace sweepkit::scene
