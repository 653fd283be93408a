// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

TEST(AcceleratorOption, DrawsTheSameBytesWithAnyOfOurs) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall, R"("camera": {"width": 64, "height": 48})"));
  const auto drawn = [&](const std::string& accelerator) {
    const Outcome run =
        workshop.sweepkit({"render", "ball.json", "-o", accelerator + ".exr", "--accelerator", accelerator});
    EXPECT_EQ(run.status, 0) << run.err;
    return workshop.read(accelerator + ".exr");
  };
  const std::string seads = drawn("seads");
  for (const char* other : {"linear", "auto"}) EXPECT_EQ(drawn(other), seads) << other;
}

TEST(AcceleratorOption, EmbreeIsDrawnWithOrRefusedWithTheRemedy) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall, R"("camera": {"width": 64, "height": 48})"));
  const Outcome run = workshop.sweepkit({"render", "ball.json", "-o", "p.png", "--accelerator", "embree"});
  if (run.status == 0) return;
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err,
            "sweepkit: --accelerator: embree is not in this build; install Embree 3 (Debian: libembree-dev) "
            "and build "
            "again, or leave it to auto\n");
}

TEST(AcceleratorOption, RefusesOthers) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall));
  const Outcome run = workshop.sweepkit({"render", "ball.json", "-o", "p.png", "--accelerator", "octree"});
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("--accelerator: octree not in {seads,sweep,linear,embree,auto}"), std::string::npos)
      << run.err;
}

}  // namespace
}  // namespace sweepkit::test
