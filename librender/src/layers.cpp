// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on the arbitrary output variables of RenderMan. Departs from them in taking the ray through a pixel's
// middle alone: a mean of depths, normals or numbers of objects is none of any surface. One ray a pixel is
// there already where there is no antialiasing.

#include "layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "material_of.hpp"
#include "ray_differential.hpp"
#include "surface_point.hpp"
#include "sweepkit/texmap/texture.hpp"

namespace sweepkit::render {
namespace {

struct Axes {
  double major = 0;
  double minor = 0;
};

// The half axes of the ellipse that the unit circle becomes under the matrix of columns a and b: its singular
// values, the larger one by Blinn's sum of two lengths, the smaller one by the determinant, which keeps its
// digits where the ellipse is thin.
Axes ellipse_axes(const glm::dvec2& a, const glm::dvec2& b) {
  const double major = 0.5 * (std::hypot(a.x + b.y, a.y - b.x) + std::hypot(a.x - b.y, a.y + b.x));
  return {major, major > 0 ? std::abs(a.x * b.y - a.y * b.x) / major : 0};
}

}  // namespace

const LayerKind& kind_of(Layer layer) {
  static const std::array<LayerKind, kLayerCount> kKinds = {
      LayerKind{"depth", "metres along the view axis", {"depth.Z"}},
      LayerKind{"normal", "in the world, on the side that is seen", {"normal.X", "normal.Y", "normal.Z"}},
      LayerKind{"uv", "texture coordinates", {"uv.U", "uv.V"}},
      LayerKind{"object-id", "1 for the first object, 0 for none", {"object_id.X"}},
      LayerKind{"footprint",
                "longer and shorter axis of what the pixel covers, in texels of the image texture",
                {"footprint.X", "footprint.Y"}},
      LayerKind{"rays", "eye rays of the pixel", {"rays.X"}},
  };
  return kKinds[static_cast<std::size_t>(layer)];
}

void LayerPainter::write(Layer layer, const Hit& hit, const glm::dvec3& direction, int x, int y,
                         float* out) const {
  const auto put = [&](double value) {
    constexpr double kMost = std::numeric_limits<float>::max();
    *out++ = std::isfinite(value) ? static_cast<float>(std::clamp(value, -kMost, kMost)) : 0.0f;
  };
  switch (layer) {
    case Layer::kDepth:
      put(hit.t * glm::dot(direction, eye_rays_.view_axis()));
      break;
    case Layer::kNormal: {
      const glm::dvec3 normal = surface_point(tracer_, hit, direction).shading_normal;
      for (glm::length_t k = 0; k < 3; ++k) put(normal[k]);
      break;
    }
    case Layer::kUv: {
      if (tracer_.object(hit.object).mesh->texcoords.empty()) break;
      const glm::dvec2 uv = builder_.texcoord_of(hit);
      put(uv.x);
      put(uv.y);
      break;
    }
    case Layer::kObjectId:
      put(hit.object + 1.0);
      break;
    case Layer::kFootprint: {
      const std::optional<std::size_t>& texture = material_of(scene_, hit.object).texture;
      const auto* image = texture ? std::get_if<texmap::ImageTexture>(&scene_.textures[*texture]) : nullptr;
      if (image == nullptr) break;
      const glm::dvec2 texels(texmap::size_of(*image));
      const HitDifferential moved = at_hit(tracer_, hit, direction, eye_rays_.differential(x, y));
      const texmap::Footprint footprint = footprint_of(tracer_, hit, moved, builder_.texcoord_of(hit));
      const Axes axes = ellipse_axes(footprint.dx * texels, footprint.dy * texels);
      put(axes.major);
      put(axes.minor);
      break;
    }
    case Layer::kRays:
      break;  // not of the hit
  }
}

std::uint64_t LayerPainter::fill(int row, int first_x, int y, const TreeRow* trees,
                                 std::span<const std::uint32_t> rays) const {
  std::uint64_t traced = 0;
  const bool needs_hits =
      std::ranges::any_of(layers_, [](const PictureLayer& layer) { return layer.layer != Layer::kRays; });
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const int x = first_x + static_cast<int>(i);
    Hit hit;
    glm::dvec3 direction(0.0);
    if (needs_hits && trees != nullptr) {
      if (const std::int32_t root = trees->root(x); root >= 0) {
        const TreeNode& node = trees->nodes[static_cast<std::size_t>(root)];
        hit = node.hit;
        direction = node.direction;
      }
    } else if (needs_hits) {
      const Ray ray = eye_rays_.through(x, y);
      hit = tracer_.nearest(ray);
      direction = ray.direction;
      ++traced;
    }
    for (PictureLayer& layer : layers_) {
      const std::size_t pixel = static_cast<std::size_t>(row) * rays.size() + i;
      float* out = std::get<std::vector<float>>(layer.image.texels).data() +
                   pixel * static_cast<std::size_t>(layer.image.channels);
      if (layer.layer == Layer::kRays) *out = static_cast<float>(rays[i]);
      if (hit.is_hit()) write(layer.layer, hit, direction, x, y, out);
    }
  }
  return traced;
}

}  // namespace sweepkit::render
