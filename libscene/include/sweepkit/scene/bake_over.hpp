// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "sweepkit/scene/scene.hpp"
#include "sweepkit/texmap/bake.hpp"

namespace sweepkit::scene {

/// texmap::bake() over a mesh, each sheet of texture with its end and where it comes round. Throws as that
/// does.
texmap::BakedTexture bake_over(const MeshView& mesh, const texmap::Texture& texture,
                               const texmap::BakeOptions& options);

/// The mesh's (u,v) as the texture lies in a baked image (`transforms`: one a sheet of texture), or its own
/// where there are none.
std::vector<glm::vec2> baked_texcoords(const MeshView& mesh, std::span<const texmap::UvTransform> transforms);

}  // namespace sweepkit::scene
