// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "sweepkit/texmap/image.hpp"

namespace sweepkit::render {

/// What can be told of each pixel besides its colour. All but kRays are of what the ray through the pixel's
/// middle meets first, not averaged over the pixel, whatever the antialiasing; 0 where it meets nothing.
enum class Layer {
  kDepth,      ///< metres along the view axis, from the plane through the eye
  kNormal,     ///< the interpolated normal in the world, unit, on the side that is seen
  kUv,         ///< (u,v), 0 where the mesh has none
  kObjectId,   ///< 1 for the scene's first object, and so on
  kFootprint,  ///< the longer and the shorter axis of what the pixel covers of the object's image texture,
               ///< texels, by the ray's derivatives; 0 where the object has no image texture
  kRays,       ///< eye rays of the pixel's colour
};
inline constexpr std::size_t kLayerCount = static_cast<std::size_t>(Layer::kRays) + 1;

struct LayerKind {
  std::string_view name;  ///< "object-id"
  std::string_view meaning;
  std::vector<std::string_view> channels;  ///< "object_id.X": as EXR files name them
};
const LayerKind& kind_of(Layer layer);

struct PictureLayer {
  Layer layer;
  texmap::Image image;  ///< float, as many channels as the kind has
};

}  // namespace sweepkit::render
