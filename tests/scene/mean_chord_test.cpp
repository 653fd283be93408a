// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "mean_chord.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene_text.hpp"
#include "sweepkit/scene/model.hpp"

namespace sweepkit::scene {
namespace {

std::optional<double> chord_of(const std::string& shape) {
  const Document document = parse(scene_text("", R"({"name": "a", )" + shape + "}"));
  const Model model = build(document, plan(document, {.product = Request::Product::kMeshFile}));
  return mean_chord(model.scene.meshes.at(0));
}

// A polygon of n sides inside a circle of radius 1: its area is pi (1 - e) with e = 2 pi^2 / 3 n^2, its
// length 2 pi (1 - e / 4). V and S of round bodies lack as much in each round direction, so that 4 V / S
// lacks at most e of each.
double lack(int cells) {
  return 2 * std::numbers::pi * std::numbers::pi / (3.0 * cells * cells);
}

TEST(MeanChord, OfABallIsFourThirdsOfTheRadius) {
  for (const int cells : {32, 128}) {
    const std::string n = std::to_string(cells);
    const auto chord =
        chord_of(R"("tessellation": {"contour": )" + n + R"(, "trajectory": )" + n +
                 R"(}, "revolve": {"contour": {"arc": {"radius": 0.3, "from_deg": -90, "to_deg": 90}}})");
    ASSERT_TRUE(chord.has_value());
    EXPECT_LE(*chord, 0.4);
    EXPECT_NEAR(*chord / 0.4, 1, 2 * lack(cells));
  }
}

// 4 pi r^2 L / (2 pi r L + 2 pi r^2), caps and all.
TEST(MeanChord, OfARodIsNearlyItsDiameter) {
  const auto chord = chord_of(
      R"("tessellation": {"contour": 128, "trajectory": 1},
         "sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"line": [[0, 0, 0], [0, 3, 0]]}})");
  ASSERT_TRUE(chord.has_value());
  EXPECT_NEAR(*chord / (2 * 0.1 * 3 / (3 + 0.1)), 1, lack(128));
}

// Flat faces: exact but for float32 positions.
TEST(MeanChord, OfABoxIsExact) {
  const auto chord = chord_of(
      R"("sweep": {"contour": {"rectangle": {"width": 1, "height": 2}}, "trajectory": {"line": [[0, 0, 0], [0, 3, 0]]}})");
  ASSERT_TRUE(chord.has_value());
  EXPECT_NEAR(*chord, 4 * 6.0 / 22, 1e-6);
}

TEST(MeanChord, OfAPipeIsTwiceItsWallLessItsEnds) {
  const auto pipe = chord_of(
      R"("tessellation": {"contour": 64, "trajectory": 256},
         "revolve": {"contour": {"polyline": [[0.5, 0], [0.52, 0], [0.52, 5], [0.5, 5]], "closed": true}})");
  ASSERT_TRUE(pipe.has_value());
  const double volume = std::numbers::pi * (0.52 * 0.52 - 0.5 * 0.5) * 5;
  const double surface = 2 * std::numbers::pi * (0.52 + 0.5) * (5 + 0.02);
  EXPECT_NEAR(*pipe / (4 * volume / surface), 1, lack(256));
  EXPECT_NEAR(*pipe / (2 * 0.02), 1, 0.005);
}

TEST(MeanChord, OfARingIsItsDiameter) {
  const auto chord = chord_of(
      R"("tessellation": {"contour": 128, "trajectory": 256},
         "sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"circle": {"radius": 2}}})");
  ASSERT_TRUE(chord.has_value());
  EXPECT_NEAR(*chord / 0.2, 1, 2 * lack(128));
}

TEST(MeanChord, IsTheSameFarFromTheOrigin) {
  const auto at = [](const std::string& x) {
    return chord_of(R"("sweep": {"contour": {"circle": {"radius": 0.1}},
                                 "trajectory": {"line": [[)" +
                    x + ", 0, 0], [" + x + ", 3, 0]]}}");
  };
  ASSERT_TRUE(at("10000000").has_value());
  EXPECT_NEAR(*at("10000000"), *at("0"), 1e-7);
}

TEST(MeanChord, AnOpenSurfaceHasNone) {
  EXPECT_FALSE(chord_of(R"("plane": {"size": [1, 1]})"));
  EXPECT_FALSE(chord_of(
      R"("sweep": {"caps": "none", "contour": {"circle": {"radius": 0.1}}, "trajectory": {"line": [[0, 0, 0], [0, 3, 0]]}})"));
  EXPECT_FALSE(chord_of(R"("revolve": {"contour": {"bezier": [[0, 0], [0.1, 0], [0.1, 0.2]]}})")) << "a bowl";
}

TEST(MeanChord, ABodyInTwoPartsIsClosedInEach) {
  const std::string rod =
      R"({"sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"line": [[0, 0, 0], [0, 3, 0]]}})";
  const auto two = chord_of(R"("parts": [)" + rod + "}, " + rod + R"(, "translate": [1, 0, 0]}])");
  const auto one = chord_of(R"("parts": [)" + rod + "}]");
  ASSERT_TRUE(one && two);
  EXPECT_NEAR(*two, *one, 1e-7);
}

}  // namespace
}  // namespace sweepkit::scene
