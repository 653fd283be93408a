// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// --stats tells the picture's error, --error and --time choose how far it is refined.

#include <gtest/gtest.h>

#include <cstdlib>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

const std::string kScene = SWEEPKIT_SAMPLES "/scenes/vase_and_cup.json";

double number(const std::string& json, const std::string& key) {
  const std::size_t at = json.find("\"" + key + "\": ");
  EXPECT_NE(at, std::string::npos) << key;
  return at == std::string::npos ? 0 : std::strtod(json.c_str() + at + key.size() + 4, nullptr);
}

TEST(Error, IsToldByTheStatisticsAndTheLastLineAndLeavesThePictureAsItIs) {
  const Workshop workshop;
  ASSERT_EQ(workshop.sweepkit({"render", kScene, "-o", "a.png", "--size", "64x64"}).status, 0);
  const Outcome run =
      workshop.sweepkit({"render", kScene, "-o", "b.png", "--size", "64x64", "--stats", "b.json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(workshop.read("a.png"), workshop.read("b.png"));
  EXPECT_NE(run.err.find(", error about 0.0"), std::string::npos) << run.err;
  const std::string json = workshop.read("b.json");
  EXPECT_GT(number(json, "error_estimate"), 0);
  EXPECT_GT(number(json, "checked_pixels"), 0);
  EXPECT_GT(number(json, "run_seconds"), number(json, "picture_seconds"));
}

TEST(Error, ThatIsAskedForGivesTheSameBytesForAnyThreads) {
  const Workshop workshop;
  for (const char* threads : {"1", "2", "5"}) {
    const Outcome run = workshop.sweepkit({"render", kScene, "-o", std::string(threads) + ".exr", "--size",
                                           "64x64", "--error", "0.008", "--threads", threads, "--stats",
                                           std::string(threads) + ".json"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(workshop.read("1.exr"), workshop.read(std::string(threads) + ".exr"));
    const std::string json = workshop.read(std::string(threads) + ".json");
    EXPECT_LE(number(json, "error_estimate"), 0.008);
    EXPECT_GT(number(json, "refining_rays"), 0);
  }
}

TEST(Error, ThatNoNumberOfRaysReachesIsSaid) {
  const Workshop workshop;
  const Outcome run =
      workshop.sweepkit({"render", kScene, "-o", "p.png", "--size", "16x16", "--error", "0.000001"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.err.find("--error 1e-06 takes more than 256 rays a pixel, the most there are"),
            std::string::npos)
      << run.err;
}

TEST(Time, ThatOneRayAPixelTakesAlreadyIsSaid) {
  const Workshop workshop;
  const Outcome run =
      workshop.sweepkit({"render", kScene, "-o", "p.png", "--size", "64x64", "--time", "0.001"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.err.find("--time 0.001 s is less than the picture takes by one ray a pixel"),
            std::string::npos)
      << run.err;
}

}  // namespace
}  // namespace sweepkit::test
