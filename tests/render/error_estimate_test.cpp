// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "draw.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/texmap/image_error.hpp"

namespace sweepkit::render {
namespace {

using scene::Part;
using test::Stage;

// A torus over a plane with its shadow: edges, shading and a procedural texture that no ray averages.
Stage torus() {
  return Stage(
      R"({"sweepkit": 1, "camera": {"eye": [0, 2, 5], "target": [0, 0, 0], "width": 24, "height": 24},
    "lights": [{"point": [2, 5, 3]}], "textures": {"t": {"procedural": "checker"}},
    "materials": {"m": {"texture": "t"}, "mirror": {"reflect": 0.4}},
    "objects": [{"name": "floor", "material": "m", "plane": {"size": [6, 6]}},
                {"name": "torus", "material": "mirror", "translate": [0, 0.6, 0],
                 "sweep": {"contour": {"circle": {"radius": 0.5}}, "trajectory": {"circle": {"radius": 1.2}}}}]})");
}

// The torus by 1,024 samples a pixel.
const texmap::Image& reference() {
  static const texmap::Image image =
      torus().draw({.filter = Filter::kPoint, .supersampling = 32, .shadows = Shadows::kHard}).image;
  return image;
}

// With 192 checks for each cause of error, and a spread of the ratios of true and expected errors of 2 to 4,
// the squared error is off by a third at most in nineteen of twenty; 2 for its root is beyond four times
// that.
constexpr double kMostOff = 2;

TEST(ErrorEstimate, IsWithinTwiceAndHalfTheTrueErrorForEveryAntialiasing) {
  const Stage stage = torus();
  for (const Options& options :
       {Options{.estimates_error = true}, Options{.filter = Filter::kPoint, .estimates_error = true},
        Options{.supersampling = 3, .estimates_error = true},
        Options{.adaptive = Adaptive{.contrast = 0.1}, .estimates_error = true},
        Options{.adaptive = Adaptive{}, .estimates_error = true}}) {
    const Picture picture = stage.draw(options);
    ASSERT_TRUE(picture.error);
    const double error = texmap::rmse(picture.image, reference());
    EXPECT_LT(picture.error->rmse, kMostOff * error) << picture.statistics.eye_rays;
    EXPECT_GT(picture.error->rmse, error / kMostOff) << picture.statistics.eye_rays;
  }
}

TEST(ErrorEstimate, OfAPictureInOneColourIsNothing) {
  const Stage stage(
      R"({"sweepkit": 1, "ambient": [0.5, 0.5, 0.5], "camera": {"eye": [0, 3, 0.1], "target": [0, 0, 0], "width": 24, "height": 24}, "objects": [{"name": "p", "plane": {"size": [100, 100]}}]})");
  // What is left is the rounding of the picture's floats.
  EXPECT_LT(stage.draw({.estimates_error = true}).error->rmse, 1e-7);
}

TEST(ErrorEstimate, LeavesThePictureAsItIsToTheBit) {
  const Stage stage = torus();
  for (const Options& options :
       {Options{}, Options{.supersampling = 3}, Options{.adaptive = Adaptive{}}, Options{.has_alpha = true},
        Options{.crop = Region{3, 5, 20, 9}}, Options{.shadows = Shadows::kHard}}) {
    Options estimating = options;
    estimating.estimates_error = true;
    EXPECT_EQ(test::texels(stage.draw(options)), test::texels(stage.draw(estimating)));
  }
}

TEST(ErrorEstimate, IsTheSameForAnyNumberOfThreads) {
  const Stage stage = torus();
  const Picture one = stage.draw({.estimates_error = true, .goal = Goal{.error = 0.01}, .threads = 1});
  const Picture three = stage.draw({.estimates_error = true, .goal = Goal{.error = 0.01}, .threads = 3});
  EXPECT_EQ(one.error->rmse, three.error->rmse);
  EXPECT_EQ(test::texels(one), test::texels(three));
  EXPECT_EQ(one.statistics.eye_rays, three.statistics.eye_rays);
}

TEST(ErrorEstimate, CostsNothingWhereItIsNotAskedForAndShowsUpWhereItIs) {
  const Stage stage = torus();
  const Picture without = stage.draw();
  EXPECT_FALSE(without.error);
  EXPECT_EQ(without.ledger[Part::kErrorEstimate].bytes, 0u);
  EXPECT_EQ(without.ledger[Part::kErrorEstimate].calls, 0u);
  const Picture with = stage.draw({.estimates_error = true});
  EXPECT_GT(with.ledger[Part::kErrorEstimate].bytes, 0u);
  EXPECT_EQ(with.ledger[Part::kErrorEstimate].calls, with.error->checked_pixels);
  EXPECT_EQ(with.ledger[Part::kRefinement].bytes, 0u);
  EXPECT_EQ(with.ledger[Part::kRefinement].calls, 0u);
}

TEST(Goal, OfAnErrorIsReachedAndNotPassedByMoreThanTwice) {
  const Stage stage = torus();
  const double cheapest = texmap::rmse(stage.draw({.filter = Filter::kBox}).image, reference());
  for (const double goal : {0.02, 0.01, 0.005}) {
    ASSERT_LT(goal, cheapest);
    const Picture picture = stage.draw({.estimates_error = true, .goal = Goal{.error = goal}});
    const double error = texmap::rmse(picture.image, reference());
    EXPECT_LT(error, 2 * goal);
    EXPECT_GT(error, goal / 2);
    EXPECT_GT(picture.statistics.refined_pixels, 0u);
  }
}

TEST(Goal, ThatOneRayAPixelReachesIsDrawnByOneRayAPixel) {
  const Picture picture =
      torus().draw({.estimates_error = true, .goal = Goal{.error = 0.9}, .layers = {Layer::kRays}});
  EXPECT_EQ(picture.statistics.refining_rays, 0u);
  for (const float rays : test::eye_rays(picture)) EXPECT_EQ(rays, 1);
}

TEST(Goal, TellsItsRaysInTheirLayer) {
  const Picture picture =
      torus().draw({.estimates_error = true, .goal = Goal{.error = 0.01}, .layers = {Layer::kRays}});
  std::uint64_t refined = 0;
  std::uint64_t rays = 0;
  for (const float here : test::eye_rays(picture)) {
    refined += here > 1 ? 1 : 0;
    rays += static_cast<std::uint64_t>(here) - 1;
  }
  EXPECT_EQ(refined, picture.statistics.refined_pixels);
  EXPECT_EQ(rays, picture.statistics.refining_rays);
}

TEST(Goal, OfATimeThatIsOverDrawsOneRayAPixel) {
  const Picture picture =
      torus().draw({.estimates_error = true, .goal = Goal{.seconds_left = [] { return -1.0; }}});
  EXPECT_EQ(picture.statistics.refining_rays, 0u);
  EXPECT_TRUE(picture.error);
}

TEST(Goal, ThatCannotBeIsRefused) {
  const Stage stage = torus();
  const auto refusal = [&](Options options) -> std::string {
    try {
      stage.draw(options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal({.goal = Goal{.error = 0.1}}), "a goal needs estimates_error");
  const std::string one = "a goal chooses the antialiasing itself; leave out supersampling and adaptive";
  EXPECT_EQ(refusal({.supersampling = 3, .estimates_error = true, .goal = Goal{.error = 0.1}}), one);
  EXPECT_EQ(refusal({.adaptive = Adaptive{}, .estimates_error = true, .goal = Goal{.error = 0.1}}), one);
  const std::string two = "a goal needs an error over 0 or seconds_left, one of the two";
  EXPECT_EQ(refusal({.estimates_error = true, .goal = Goal{}}), two);
  EXPECT_EQ(refusal({.estimates_error = true, .goal = Goal{.error = -1}}), two);
  EXPECT_EQ(
      refusal({.estimates_error = true, .goal = Goal{.error = 0.1, .seconds_left = [] { return 1.0; }}}),
      two);
}

}  // namespace
}  // namespace sweepkit::render
