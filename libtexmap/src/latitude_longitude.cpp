// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Symbols: u, v on the texture that covers the sphere twice; h the distance from the axis, l the latitude.
//   u = 1/2 + atan2(x, -z) / 2 pi,   l = atan2(y, h),   v = 3/4 + l / 2 pi
//   du = (x dz - z dx) / (2 pi h h), dl = h dy - y dh, dh = (x dx + z dz) / h

#include "sweepkit/texmap/latitude_longitude.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "texel_source.hpp"

namespace sweepkit::texmap {
namespace {

// Rows height() / 2 and on: the picture's rows from the bottom up, each begun at its middle. Of an odd width
// half a texel is lost at that, which shows within a texel of a pole alone.
class SphereTexels : public TexelSource {
 public:
  explicit SphereTexels(std::shared_ptr<const TexelSource> picture) : picture_(std::move(picture)) {}

  int width() const override { return picture_->width(); }
  int height() const override { return 2 * picture_->height(); }
  bool is_float() const override { return picture_->is_float(); }
  std::size_t bytes() const override { return picture_->bytes(); }
  void read(const PixelRect& rect, std::span<IntegerTexel> texels) const override { copy(rect, texels); }
  void read(const PixelRect& rect, std::span<FloatTexel> texels) const override { copy(rect, texels); }

 private:
  template <class Texel>
  void copy(const PixelRect& rect, std::span<Texel> texels) const {
    const int plain = std::clamp(picture_->height() - rect.y, 0, rect.height);
    const auto texels_of = [&](int first_row, int rows) {
      return texels.subspan(static_cast<std::size_t>(first_row) * static_cast<std::size_t>(rect.width),
                            static_cast<std::size_t>(rows) * static_cast<std::size_t>(rect.width));
    };
    if (plain > 0) picture_->read({rect.x, rect.y, rect.width, plain}, texels_of(0, plain));
    const int half = width() / 2;
    for (int row = plain; row < rect.height; ++row) {
      const int from = height() - 1 - (rect.y + row);
      std::span<Texel> rest = texels_of(row, 1);
      for (int x = rect.x; x < rect.x + rect.width;) {
        const int start = (x + half) % width();
        const int count = std::min(width() - start, rect.x + rect.width - x);
        picture_->read({start, from, count, 1}, rest.first(static_cast<std::size_t>(count)));
        rest = rest.subspan(static_cast<std::size_t>(count));
        x += count;
      }
    }
  }

  std::shared_ptr<const TexelSource> picture_;
};

}  // namespace

ImageTexture over_sphere(const ImageTexture& picture) {
  return {
      nullptr, Wrap::kRepeat,
      std::make_shared<const SphereTexels>(picture.file ? picture.file : make_texel_source(picture.image))};
}

Footprint over_sphere(const glm::dvec3& direction, const glm::dvec3& dx, const glm::dvec3& dy,
                      glm::dvec2 size) {
  constexpr double kTurn = 2 * std::numbers::pi;
  constexpr double kLongest = 16;
  const glm::dvec3& d = direction;
  const double h = std::hypot(d.x, d.z);
  const auto step = [&](const glm::dvec3& turn) {
    // At a pole itself every way leads down a meridian.
    if (!(h > 0)) return glm::dvec2(0, -std::copysign(glm::length(turn), d.y)) / kTurn;
    const double dh = (d.x * turn.x + d.z * turn.z) / h;
    return glm::dvec2((d.x * turn.z - d.z * turn.x) / h / h, h * turn.y - d.y * dh) / kTurn;
  };
  Footprint footprint{
      {0.5 + std::atan2(d.x, -d.z) / kTurn, 0.75 + std::atan2(d.y, h) / kTurn}, step(dx), step(dy)};
  const double across = std::max(std::abs(footprint.dx.y), std::abs(footprint.dy.y));
  const double longest = kLongest * across * 2 * size.y / size.x;
  footprint.dx.x = std::clamp(footprint.dx.x, -longest, longest);
  footprint.dy.x = std::clamp(footprint.dy.x, -longest, longest);
  return footprint;
}

}  // namespace sweepkit::texmap
