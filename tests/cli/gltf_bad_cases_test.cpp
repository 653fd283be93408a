// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// A glTF file that cannot be made: one line that says why, the exit status, and nothing left behind.

#include <gtest/gtest.h>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

TEST(GltfBadCases, AFullDiskIsTold) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const Workshop workshop;
  workshop.write("s.json", scene_of(kBall));
  std::filesystem::create_symlink("/dev/full", workshop.folder() / "a.glb");
  const Outcome run = workshop.sweepkit({"generate", "s.json", "-o", "a.glb"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "sweepkit: a.glb: cannot be written: No space left on device\n");
}

TEST(GltfBadCases, ADiskThatIsFullForTheBufferLeavesNoGltf) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const Workshop workshop;
  workshop.write("s.json", scene_of(kBall));
  std::filesystem::create_symlink("/dev/full", workshop.folder() / "a.bin");
  const Outcome run = workshop.sweepkit({"generate", "s.json", "-o", "a.gltf"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "sweepkit: a.bin: cannot be written: No space left on device\n");
  EXPECT_FALSE(std::filesystem::exists(workshop.folder() / "a.gltf"));
}

TEST(GltfBadCases, AnObjectWithoutTrianglesIsNamedByItsPlace) {
  const Workshop workshop;
  workshop.write("dot.off", "OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n");
  workshop.write("s.json", scene_of(R"({"name": "dot", "mesh": {"file": "dot.off"}})"));
  const auto before = workshop.contents();
  const Outcome run = workshop.sweepkit({"generate", "s.json", "-o", "a.glb"});
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(
      run.err.find("/objects/0/mesh: dot.off: has no triangle with three corners at different places\n"),
      std::string::npos);
  EXPECT_EQ(workshop.contents(), before);
}

TEST(GltfBadCases, AModelOfMoreThanTwoGibibytesIsRefusedBeforeItIsMade) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(R"({"name": "rug", "plane": {"size": [1, 1]},
    "tessellation": {"contour": 7500, "trajectory": 7500}})"));
  const auto before = workshop.contents();
  const Outcome run = workshop.sweepkit({"generate", "s.json", "-o", "a.glb"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(
      run.err,
      "sweepkit: s.json:3:26: /objects/0/plane: the object \"rug\" would take 2.9 GiB, and a glTF file holds "
      "less than 2; ask for fewer cells, or for another format\n");
  EXPECT_LT(run.cpu_seconds, 1);
  EXPECT_EQ(workshop.contents(), before);
}

TEST(GltfBadCases, NamesWithSpacesSlashesAndUmlautsAreWrittenAndToldOf) {
  const Workshop workshop;
  workshop.write("s.json",
                 scene_of(R"({"name": "Käse / Brot #1", "material": "m", "plane": {"size": [1, 1]}})",
                          R"("textures": {"t / ä": {"procedural": "checker"}},
                                       "materials": {"m": {"texture": "t / ä"}})"));
  const Outcome made =
      workshop.sweepkit({"generate", "s.json", "-o", "ä b%.gltf", "--bake-size", "16", "--quiet"});
  EXPECT_EQ(made.status, 0) << made.err;
  for (const char* name : {"ä b%.gltf", "ä b%.bin", "ä b%_0.png"}) {
    EXPECT_TRUE(std::filesystem::exists(workshop.folder() / name)) << name;
  }
  EXPECT_NE(workshop.read("ä b%.gltf").find("%C3%A4%20b%25.bin"), std::string::npos);
  const Outcome told = workshop.sweepkit({"info", "ä b%.gltf"});
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_NE(told.out.find("Käse / Brot #1"), std::string::npos);
}

}  // namespace
}  // namespace sweepkit::test
