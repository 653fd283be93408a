// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// What there is no memory for is refused before work, with what it would need; and where memory runs out all
// the same, at any point, the program ends with a line and leaves nothing behind.

#include <gtest/gtest.h>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

std::string plane(const std::string& name, int cells) {
  return R"({"name": ")" + name + R"(", "plane": {"size": [1, 1]}, "tessellation": {"contour": )" +
         std::to_string(cells) + R"(, "trajectory": )" + std::to_string(cells) + "}}";
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Memory, RefusesWhatALimitHasNoRoomForWithWhatItNeeds) {
  const Workshop workshop;
  workshop.write("big.json", scene_of(plane("big", 6000)));
  const auto before = workshop.contents();
  for (const char* limit : {"ulimit -v 1500000", "ulimit -d 1000000"}) {
    const Outcome run = workshop.shell(std::string(limit) + "; sweepkit render big.json -o big.png");
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_EQ(run.err.rfind("sweepkit: big.json: needs about 2.3", 0), 0u) << run.err;
    EXPECT_TRUE(has(
        run.err, " GiB of memory, for 72000000 triangles, 1 object and what is made of them, and ulimit -" +
                     std::string(1, limit[8]) + " leaves "))
        << run.err;
    EXPECT_TRUE(has(run.err, "; ask for fewer cells or pixels, or run it where there is more\n")) << run.err;
    EXPECT_EQ(run.err.find('\n'), run.err.size() - 1);
    EXPECT_LT(run.cpu_seconds, 1);
    EXPECT_EQ(workshop.contents(), before);
  }
  for (const char* command : {"generate big.json -o big.glb", "generate big.json -o big.obj",
                              "generate big.json -o big.stl", "info big.json", "check big.json"}) {
    const Outcome run = workshop.shell("ulimit -v 1000000; sweepkit " + std::string(command));
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_TRUE(has(run.err, "needs about ")) << run.err;
    EXPECT_EQ(workshop.contents(), before);
  }
}

TEST(Memory, RefusesAToleranceThatTakesMoreTrianglesThanThereIsRoomFor) {
  const Workshop workshop;
  workshop.write("fine.json", scene_of(R"({"name": "ball", "tessellation": {"tolerance": 1e-6},
    "revolve": {"contour": {"arc": {"radius": 1, "from_deg": -90, "to_deg": 90}}}})"));
  const auto before = workshop.contents();
  const Outcome run = workshop.shell("ulimit -v 350000; sweepkit render fine.json -o fine.png");
  EXPECT_EQ(run.status, 2) << run.err;
  EXPECT_TRUE(has(run.err, "/objects/0/revolve: tolerance of 1e-06 m takes ")) << run.err;
  EXPECT_TRUE(has(run.err, " that memory and the file have room for; ")) << run.err;
  EXPECT_EQ(workshop.contents(), before);
}

// From limits under which the program cannot even start to those where all goes well, in steps of an eighth.
class RunningOut : public testing::TestWithParam<std::string> {};

TEST_P(RunningOut, AtAnyLimitEndsCleanlyAndLeavesNothing) {
  const Workshop workshop;
  workshop.write(
      "scene.json",
      scene_of(
          plane("a", 300) + ",\n" + plane("b", 100) +
              R"(, {"name": "t", "material": "m", "tessellation": {"tolerance": 1e-5}, "revolve": {"contour": {"arc": {"radius": 1, "from_deg": -90, "to_deg": 90}}}})",
          R"("textures": {"t": {"image": ")" SWEEPKIT_SAMPLES R"(/textures/floor_tiles.png"}},
                             "materials": {"m": {"texture": "t"}}, "camera": {"width": 256, "height": 256})"));
  const auto before = workshop.contents();
  int good = 0;
  int refused = 0;
  for (double kilobytes = 40000; kilobytes < 3e6 && good < 3; kilobytes *= 1.12) {
    const auto limit = std::to_string(static_cast<int>(kilobytes));
    const Outcome run = workshop.shell("ulimit -v " + limit + "; " + GetParam());
    if (run.status == 0) {
      ++good;
      const std::size_t made = workshop.contents().size() - before.size();
      EXPECT_EQ(made, GetParam().ends_with(".obj") ? 3u : 1u) << limit;  // and its .mtl and image
      for (const auto& [name, bytes] : workshop.contents()) {
        if (before.count(name) == 0) std::filesystem::remove(workshop.folder() / name);
      }
      continue;
    }
    EXPECT_EQ(workshop.contents(), before) << limit;
    // The system's own words where not even the libraries find room.
    if (has(run.err, "error while loading shared libraries") || run.status == 127 || run.status == 126)
      continue;
    ++refused;
    EXPECT_TRUE(run.status == 1 || run.status == 2) << limit << ": " << run.status << ": " << run.err;
    EXPECT_EQ(run.err.rfind("sweepkit: ", 0), 0u) << limit << ": " << run.err;
    EXPECT_TRUE(has(run.err, "memory")) << limit << ": " << run.err;
    EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << limit << ": " << run.err;
  }
  EXPECT_EQ(good, 3);
  EXPECT_GT(refused, 3);
}

INSTANTIATE_TEST_SUITE_P(Commands, RunningOut,
                         testing::Values("sweepkit render scene.json -o p.png",
                                         "sweepkit render scene.json -o p.exr --threads 4",
                                         "sweepkit render scene.json -o p.png --accelerator embree",
                                         "sweepkit generate scene.json -o p.glb",
                                         "sweepkit generate scene.json -o p.obj",
                                         "sweepkit generate scene.json -o p.ply"));

}  // namespace
}  // namespace sweepkit::test
