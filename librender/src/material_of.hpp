// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "sweepkit/scene/scene.hpp"

namespace sweepkit::render {

inline const scene::Material& material_of(const scene::Scene& scene, std::uint32_t object) {
  static const scene::Material kDefault;
  const std::optional<std::size_t>& index = scene.objects[object].material;
  return index ? scene.materials[*index] : kDefault;
}

}  // namespace sweepkit::render
