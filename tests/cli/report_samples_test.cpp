// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

TEST(ReportSamples, RefusesASceneThatIsNotThereBeforeAnyWork) {
  const Workshop workshop;
  const Outcome outcome =
      workshop.sweepkit({"report", "--quick", "--only", "pictures", "--scene", "none.json", "-o", "out"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("none.json"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(workshop.folder() / "out"));
}

// A copy of the program alone, with the pages that it fills, has no samples beside it.
TEST(ReportSamples, SaysPlainlyThatTheSamplesAreMissing) {
  const Workshop workshop;
  const std::filesystem::path program = SWEEPKIT_PROGRAM;
  for (const char* file : {"sweepkit", "sweepkit-report.html", "sweepkit-plots.js"}) {
    if (!std::filesystem::exists(program.parent_path() / file)) GTEST_SKIP() << "no " << file;
    std::filesystem::copy(program.parent_path() / file, workshop.folder() / file);
  }
  const Outcome outcome = workshop.shell("./sweepkit report --quick --only pictures -o out");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("the experiment pictures needs the sample scenes, which are missing"),
            std::string::npos)
      << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(workshop.folder() / "out"));
}

TEST(ReportSamples, AnUnknownStepOfScaleIsRefused) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall));
  EXPECT_EQ(workshop.sweepkit({"report", "--scale-step", "paint", "ball.json", "1", "8"}).status, 2);
}

}  // namespace
}  // namespace sweepkit::test
