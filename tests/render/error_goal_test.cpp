// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// The error estimate, and the errors and times that are asked for, on every sample scene against a reference
// of 1,024 samples a pixel. Prints what it has measured.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "draw.hpp"
#include "sweepkit/texmap/image_error.hpp"

namespace sweepkit::render {
namespace {

constexpr int kSize = 64;
// Of glass in glass, whose pixels take a hundred times as long.
constexpr int kSizeOfDeep = 24;
constexpr int kReferenceSide = 32;
// Another grid, whose errors have little to do with the first one's.
constexpr int kOtherSide = 31;

class SampleScene : public testing::TestWithParam<std::string> {
 protected:
  SampleScene() : document_(scene::read_document(SWEEPKIT_SAMPLES "/scenes/" + GetParam() + ".json")) {
    const double shape = static_cast<double>(document_.height) / document_.width;
    document_.width = document_.depth > scene::Document{}.depth ? kSizeOfDeep : kSize;
    document_.height = static_cast<int>(document_.width * shape);
    model_ =
        scene::build(document_, test::plan_for(document_, {.adaptive = Adaptive{}, .estimates_error = true}));
    reference_ =
        draw({.filter = Filter::kPoint, .supersampling = kReferenceSide, .shadows = Shadows::kHard}).image;
    if (has_images()) {
      smooth_ =
          draw({.filter = Filter::kBilinear, .supersampling = kReferenceSide, .shadows = Shadows::kHard})
              .image;
    }
    const Options other{.filter = Filter::kPoint, .supersampling = kOtherSide, .shadows = Shadows::kHard};
    own_ = texmap::rmse(draw(other).image, reference_) / std::sqrt(2.0);
    std::printf("%s,reference,%.5f\n", GetParam().c_str(), own_);
  }
  Picture draw(const Options& options) const {
    return render(model_.scene, test::plan_for(document_, options), options);
  }
  bool has_images() const {
    return document_.environment || std::ranges::any_of(document_.textures, [](const auto& texture) {
             return std::holds_alternative<scene::ImageEntry>(texture.source);
           });
  }
  // Without the part that is the reference's own. Between the texels of an image that is larger on the
  // picture than its texels, filters see it smooth and Filter::kPoint does not: either is true.
  double error_of(const Picture& picture) const {
    double measured = texmap::rmse(picture.image, reference_);
    if (smooth_.width > 0) measured = std::min(measured, texmap::rmse(picture.image, smooth_));
    return std::sqrt(std::max(0.0, measured * measured - own_ * own_));
  }
  // An error as small as the reference's own is not measured by it.
  bool is_measured(double error) const { return error > 2 * own_; }

  scene::Document document_;
  scene::Model model_;
  texmap::Image reference_;
  texmap::Image smooth_;  // the same with images between their texels interpolated
  double own_ = 0;        // the reference's error
};

// Twice and half are what is promised (docs/algorithms/error-estimate.md).
TEST_P(SampleScene, HasAnErrorThatTheEstimateTellsAndAGoalReaches) {
  const auto with = [](Options options) {
    options.estimates_error = true;
    return options;
  };
  const std::vector<std::pair<const char*, Options>> settings = {
      {"off", with({})},
      {"point", with({.filter = Filter::kPoint})},
      {"integral-2", with({.filter = Filter::kIntegral2})},
      {"3x3", with({.supersampling = 3})},
      {"adaptive 0.24", with({.adaptive = Adaptive{.contrast = 0.24}})},
      {"adaptive 0.03", with({.adaptive = Adaptive{}})}};
  for (const auto& [name, options] : settings) {
    const Picture picture = draw(options);
    const double error = error_of(picture);
    std::printf("%s,%s,%.5f,%.5f,%.2f\n", GetParam().c_str(), name, error, picture.error->rmse,
                picture.error->rmse / error);
    if (!is_measured(error)) continue;
    EXPECT_LT(picture.error->rmse, 2 * error) << name;
    EXPECT_GT(picture.error->rmse, error / 2) << name;
  }
  const double cheapest = error_of(draw({.filter = Filter::kBox}));
  for (const double goal : {0.02, 0.01, 0.005, 0.002}) {
    if (!is_measured(goal)) continue;
    const Picture picture = draw(with({.goal = Goal{.error = goal}}));
    const double error = error_of(picture);
    std::printf("%s,--error %g,%.5f,%.5f,%.2f\n", GetParam().c_str(), goal, error, picture.error->rmse,
                static_cast<double>(picture.statistics.eye_rays) / (document_.width * document_.height));
    EXPECT_LT(error, 2 * goal) << goal;
    if (picture.statistics.refined_pixels == 0) continue;
    EXPECT_GT(error, std::min(goal / 2, cheapest)) << goal;
  }
}

std::vector<std::string> sample_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(SWEEPKIT_SAMPLES "/scenes"))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, SampleScene, testing::ValuesIn(sample_scenes()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace sweepkit::render
