// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "sweepkit/texmap/footprint.hpp"
#include "sweepkit/texmap/image.hpp"

namespace sweepkit::report {

/// A camera one unit above the plane y = 0, looking along -z and 20 degrees down, 60 degrees wide, its
/// picture `side` pixels a side; the texture is two units wide and turned by `turn_deg`. Pixels within a
/// degree of the horizon are left out: whole rows.
class PlaneView {
 public:
  PlaneView(int side, double turn_deg);
  int side() const { return side_; }
  /// (u,v) of a place in the picture, or none.
  std::optional<glm::dvec2> uv(const glm::dvec2& place) const;

 private:
  int side_;
  double turn_cos_, turn_sin_;
};

struct PlanePixel {
  int x = 0;
  int y = 0;
  texmap::Footprint footprint;  ///< exact
};
/// Row by row, from the first that is on the plane to the picture's last.
std::vector<PlanePixel> plane_pixels(const PlaneView& view);

/// A square grey texture that repeats.
struct PlaneTexture {
  int side = 0;
  std::vector<float> texels;
};
/// Checks of 32 texels; noise of equal strength in every octave.
PlaneTexture checker_texture(int side);
PlaneTexture noise_texture(int side);
/// 16-bit integers, as a decoded 8-bit file is kept.
std::shared_ptr<const texmap::Image> to_image(const PlaneTexture& texture);

/// What a pixel should show: the mean of 64 x 64 samples of the texture under a tent of one pixel each way,
/// and that of the 32 x 32 of them in the pixel itself, straight from the texels.
struct PlaneReference {
  std::vector<double> tent, box;  ///< a value a pixel
  /// Half the RMS difference between the means of the two halves that a checker board parts the samples
  /// into: what the mean of both may be off by.
  double tent_error = 0, box_error = 0;
};
PlaneReference plane_reference(const PlaneView& view, const PlaneTexture& texture,
                               const std::vector<PlanePixel>& pixels);

}  // namespace sweepkit::report
