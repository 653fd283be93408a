// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "sweepkit/scene/scene.hpp"
#include "sweepkit/texmap/bake.hpp"

namespace sweepkit::scene {

/// 65535 is glTF's mark for a restart, so 16 bits reach 65535 vertices (0 to 65534).
inline constexpr std::size_t kMostShortVertices = 65535;

/// The vertices of the triangles in 16 bits. Precondition: none is above 65534.
std::vector<std::uint16_t> short_indices(std::span<const sweep::Triangle> triangles);

/// (u,v) as glTF has it, v running down from the image's top row; where a texture was baked, as it lies there
/// (`transforms`: one a sheet of texture, or none).
std::vector<glm::vec2> gltf_texcoords(const MeshView& mesh, std::span<const texmap::UvTransform> transforms);

/// A file name as a URI: every byte but letters, digits and -._~ becomes %XX.
std::string percent_encoded(const std::string& name);

}  // namespace sweepkit::scene
