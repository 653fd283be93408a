// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "draw.hpp"

namespace sweepkit::render {
namespace {

using test::Stage;

constexpr int kWidth = 96;
constexpr int kHeight = 96;

// A vase seen from +x, where its seam (u = 0) runs down the middle of the picture.
Stage vase() {
  Stage stage(
      R"({"sweepkit": 1, "camera": {"eye": [4, 0.5, 0], "target": [0, 0.5, 0], "fov_deg": 16, "width": 96, "height": 96},
    "ambient": [1, 1, 1], "textures": {"t": {"procedural": "checker"}}, "materials": {"m": {"diffuse": [1, 1, 1], "texture": "t"}},
    "objects": [{"name": "vase", "material": "m", "tessellation": {"contour": 48, "trajectory": 96},
      "revolve": {"contour": {"free": [[0.35, -0.2], [0.6, 0.3], [0.4, 0.9], [0.55, 1.2]]}}}]})");
  // Noise that repeats, of the same strength at every column: what is beside the seam is as hard as the seam.
  texmap::Image image{512, 256, 1, std::vector<std::uint16_t>(512 * 256)};
  std::mt19937 random(1);
  for (std::uint16_t& value : std::get<std::vector<std::uint16_t>>(image.texels))
    value = static_cast<std::uint16_t>(random());
  stage.set_texture(0, image);
  return stage;
}

// Root mean square error of columns first..end-1 over the rows that the vase fills.
double error_of(const Picture& picture, const Picture& reference, int first, int end) {
  double sum = 0;
  int count = 0;
  for (int y = 10; y < kHeight - 10; ++y) {
    for (int x = first; x < end; ++x) {
      const double difference = static_cast<double>(picture.image.color(x, y).r) -
                                static_cast<double>(reference.image.color(x, y).r);
      sum += difference * difference;
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

// Seam over beside: columns 46 to 49, whose footprints reach over the middle, against 12 on either side.
double seam_over_beside(const Picture& picture, const Picture& reference) {
  const double seam = error_of(picture, reference, kWidth / 2 - 2, kWidth / 2 + 2);
  const double left = error_of(picture, reference, kWidth / 2 - 14, kWidth / 2 - 2);
  const double right = error_of(picture, reference, kWidth / 2 + 2, kWidth / 2 + 14);
  return seam / std::sqrt(0.5 * (left * left + right * right));
}

TEST(Seam, IsNoWorseThanTheColumnsBesideIt) {
  const Stage stage = vase();
  const Picture reference = stage.draw({.filter = Filter::kPoint, .supersampling = 8});
  for (const Filter filter : {Filter::kTrilinear, Filter::kIntegral1, Filter::kEwa, Filter::kAuto}) {
    for (const Footprint footprint : {Footprint::kNeighbours, Footprint::kDifferentials, Footprint::kAuto}) {
      // The seam's error is the mean over 4 x 76 pixels of noise: two standard deviations are 8 % of it.
      EXPECT_LT(seam_over_beside(stage.draw({.filter = filter, .footprint = footprint}), reference), 1.15)
          << texmap::filter_name(filter) << ' ' << static_cast<int>(footprint);
    }
  }
}

TEST(Seam, IsABlurredLineWhereNeighboursAreTakenAsTheyAre) {
  // The same without the nearest representative: no area says that it comes round. The measure above sees it.
  Stage stage = vase();
  const Picture reference = stage.draw({.filter = Filter::kPoint, .supersampling = 8});
  std::vector<sweep::Area> areas(stage.model.scene.meshes[0].areas.begin(),
                                 stage.model.scene.meshes[0].areas.end());
  for (sweep::Area& area : areas) area.u_period = 0;
  stage.model.scene.meshes[0].areas = areas;
  EXPECT_GT(seam_over_beside(stage.draw(), reference), 1.5);
}

}  // namespace
}  // namespace sweepkit::render
