// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// What `generate` lets one ask of a glTF file.

#include <gtest/gtest.h>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

TEST(GltfOptions, AreRefusedForFormatsThatHaveNothingOfTheKind) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(kBall));
  for (const char* option : {"--unlit", "--compatible", "--tangents"}) {
    const Outcome run = workshop.sweepkit({"generate", "s.json", "-o", "b.stl", option});
    EXPECT_EQ(run.status, 2);
    const std::string start =
        "sweepkit: " + std::string(option) + ": is for .glb and .gltf: other formats hold no ";
    EXPECT_EQ(run.err.substr(0, start.size()), start);
  }
}

TEST(GltfOptions, UnlitAndCompatibleExcludeEachOther) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(kBall));
  const Outcome run = workshop.sweepkit({"generate", "s.json", "-o", "b.glb", "--unlit", "--compatible"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err,
            "sweepkit: --unlit: is an extension, and --compatible is for viewers that know none; leave one "
            "out\n");
}

}  // namespace
}  // namespace sweepkit::test
