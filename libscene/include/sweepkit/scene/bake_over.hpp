// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/scene/scene.hpp"
#include "sweepkit/texmap/bake.hpp"

namespace sweepkit::scene {

/// texmap::bake() over a mesh, each sheet of texture with its end and where it comes round. Throws as that
/// does.
texmap::BakedTexture bake_over(const MeshView& mesh, const texmap::Texture& texture,
                               const texmap::BakeOptions& options);

}  // namespace sweepkit::scene
