// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// check tells faults of shape with place and cure; generate and render make the object all the same, and
// warn.

#include <gtest/gtest.h>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A tube a tenth wider than the ring it is bent to.
constexpr const char* kFold =
    R"({"name": "ring", "translate": [5, 0, 0], "tessellation": {"contour": 16, "trajectory": 24},
  "sweep": {"contour": {"circle": {"radius": 0.11}}, "trajectory": {"circle": {"radius": 0.1}}}})";

TEST(Check, TellsAFoldWithItsPlaceAndItsCure) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(kFold));
  const Outcome run = workshop.sweepkit({"check", "s.json", "--json"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(has(run.out, R"("found": 1)")) << run.out;
  EXPECT_TRUE(has(run.out, R"("object": "ring", "kind": "fold")")) << run.out;
  EXPECT_TRUE(has(run.out, "the contour fits when made 0.909 times as large")) << run.out;
  EXPECT_TRUE(has(run.out, R"("severity": 1.1)")) << run.out;
}

TEST(Check, FindsTheThreeFaultsOfTheSample) {
  const Outcome run = Workshop().sweepkit({"check", SWEEPKIT_SAMPLES "/scenes/faults.json", "--json"});
  EXPECT_TRUE(has(run.out, R"("object": "fold", "kind": "fold", "t": 0.5,)")) << run.out;
  EXPECT_TRUE(has(run.out, R"("object": "crossing", "kind": "crossing")")) << run.out;
  EXPECT_TRUE(has(run.out, R"("object": "cusp", "kind": "cusp", "t": 0.5,)")) << run.out;
  EXPECT_FALSE(has(run.out, R"("object": "cusp", "kind": "fold")")) << run.out;
}

TEST(Check, EndsWith3WhenStrictAndThereIsAFinding) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(kFold));
  workshop.write("sound.json", scene_of(kBall));
  const Outcome fold = workshop.sweepkit({"check", "s.json", "--strict"});
  EXPECT_EQ(fold.status, 3);
  EXPECT_TRUE(has(fold.out, "fold")) << fold.out;
  EXPECT_EQ(fold.err, "");
  const Outcome sound = workshop.sweepkit({"check", "sound.json", "--strict"});
  EXPECT_EQ(sound.status, 0);
  EXPECT_TRUE(has(sound.out, "found: 0")) << sound.out;
  EXPECT_EQ(workshop.sweepkit({"check", "none.json", "--strict"}).status, 2);
}

TEST(Check, TellsAMaterialThatGivesMoreLightThanFallsOnIt) {
  const Workshop workshop;
  workshop.write("s.json",
                 scene_of(kBall, R"("materials": {"m": {"diffuse": [0.9, 0.9, 0.9], "reflect": 0.2}})"));
  const Outcome run = workshop.sweepkit({"check", "s.json", "--strict"});
  EXPECT_EQ(run.status, 3) << run.err;
  EXPECT_TRUE(has(run.out, "/materials/m")) << run.out;
  EXPECT_TRUE(has(run.out, "diffuse 0.9, reflect 0.2 and transmit 0 come to 1.1")) << run.out;
  EXPECT_TRUE(has(run.out, "0.9091 times each of them fits")) << run.out;
}

TEST(Check, GenerateAndRenderWarnInALineAndGoOn) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(kFold));
  for (const char* command : {"generate", "render"}) {
    const std::string file = std::string("out") + (std::string(command) == "generate" ? ".glb" : ".png");
    const Outcome run = workshop.sweepkit({command, "s.json", "-o", file});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(has(run.err, "warning: s.json:4:12: /objects/0/sweep: ring at t = ")) << run.err;
    EXPECT_TRUE(has(run.err, "folds over; the contour fits when made 0.909 times as large\n")) << run.err;
    EXPECT_FALSE(workshop.read(file).empty());
    const Outcome quiet = workshop.sweepkit({command, "s.json", "-o", file, "--quiet"});
    EXPECT_EQ(quiet.err, "");
  }
}

TEST(Check, PartsOfAnObjectMayGoThroughEachOther) {
  const Workshop workshop;
  workshop.write("cup.json", scene_of(R"({"name": "cup", "parts": [
    {"revolve": {"contour": {"bezier": [[0, -1], [1.3, -1], [1.3, 1], [0, 1]]}}},
    {"sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"line": [[0.5, 0, 0], [2, 0, 0]]}}}]})"));
  const Outcome run = workshop.sweepkit({"check", "cup.json", "--strict"});
  EXPECT_EQ(run.status, 0) << run.out;
}

}  // namespace
}  // namespace sweepkit::test
