// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

TEST(Schema, GoesToStandardOutputOrToAFileTheSame) {
  const Workshop workshop;
  const Outcome printed = workshop.sweepkit({"schema"});
  EXPECT_EQ(printed.status, 0);
  EXPECT_EQ(printed.err, "");
  EXPECT_EQ(printed.out.substr(0, 2), "{\n");
  EXPECT_EQ(workshop.sweepkit({"schema", "-o", "scene.schema.json"}).status, 0);
  EXPECT_EQ(workshop.read("scene.schema.json"), printed.out);
}

TEST(Schema, IsWrittenWholeOrNotAtAll) {
  const Workshop workshop;
  EXPECT_EQ(workshop.sweepkit({"schema", "-o", "none/s.json"}).status, 2);
  const Outcome full = workshop.sweepkit({"schema", "-o", "/dev/full"});
  EXPECT_EQ(full.status, 1);
  EXPECT_EQ(full.err, "sweepkit: /dev/full: cannot be written: No space left on device\n");
  EXPECT_EQ(workshop.shell("ulimit -f 8; sweepkit schema -o s.json").status, 1);
  EXPECT_TRUE(workshop.contents().empty());
}

TEST(Schema, ASceneThatNamesItIsReadAsBefore) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(kBall));
  workshop.write("t.json", scene_of(kBall, R"("$schema": "scene.schema.json")"));
  EXPECT_EQ(workshop.sweepkit({"generate", "s.json", "-o", "s.glb", "--quiet"}).status, 0);
  EXPECT_EQ(workshop.sweepkit({"generate", "t.json", "-o", "t.glb", "--quiet"}).status, 0);
  EXPECT_EQ(workshop.read("s.glb"), workshop.read("t.glb"));
}

}  // namespace
}  // namespace sweepkit::test
