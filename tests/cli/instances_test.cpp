// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string kFolded =
    R"({"name": "folded", "sweep": {"contour": {"circle": {"radius": 0.3}}, "trajectory": {"circle": {"radius": 0.1}}},
  "translate": [0, 0, 5], "instances": [{"translate": [7, 0, 0]}, {"translate": [9, 0, 0]}]})";

TEST(Instances, AreCountedBesideWhatTheyShare) {
  const Workshop workshop;
  workshop.write("s.json",
                 scene_of(R"({"name": "many", "instances": [{}, {"translate": [3, 0, 0]}, {"scale": 2}],
    "tessellation": {"contour": 16, "trajectory": 24}, "revolve": {"contour": {"bezier": [[0, -1], [1.3, -1], [1.3, 1], [0, 1]]}}},
    {"name": "one", "plane": {"size": [1, 1]}})"));
  const Outcome info = workshop.sweepkit({"info", "s.json", "--json"});
  ASSERT_EQ(info.status, 0) << info.err;
  EXPECT_TRUE(has(info.out, R"("object": "many", "triangles": 720,)")) << info.out;
  EXPECT_TRUE(has(info.out, R"("instances": 3})")) << info.out;
  EXPECT_TRUE(has(info.out, R"("instances": 1})")) << info.out;
  const Outcome generate = workshop.sweepkit({"generate", "s.json", "-o", "s.glb"});
  EXPECT_TRUE(has(generate.err, "s.glb: 2 objects, 4 instances, 722 triangles, ")) << generate.err;
  const Outcome uv = workshop.sweepkit({"info", "s.json", "--uv", "--json"});
  const std::size_t first = uv.out.find(R"({"object": "many", "homogeneity u")");
  ASSERT_NE(first, std::string::npos) << uv.out;
  EXPECT_EQ(uv.out.find(R"({"object": "many", "homogeneity u")", first + 1), std::string::npos) << "once";
}

TEST(Instances, FindingsAreToldOnceInTheFirst) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(kFolded + R"(, {"name": "after", "plane": {"size": [1, 1]}})"));
  const Outcome run = workshop.sweepkit({"check", "s.json", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::size_t found = run.out.find(R"("kind": "fold")");
  ASSERT_NE(found, std::string::npos) << run.out;
  EXPECT_TRUE(has(run.out, R"("objects": 2)")) << run.out;
  // The first stands at (7, 0, 5), within the reach of 0.4.
  const std::size_t x = run.out.find(R"("x": )", found);
  EXPECT_NEAR(std::stod(run.out.substr(x + 5)), 7, 0.5) << run.out;
}

TEST(Instances, StayWithTheObjectThatIsAskedFor) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(kFolded + R"(, {"name": "after", "plane": {"size": [1, 1]}})"));
  const Outcome run =
      workshop.sweepkit({"generate", "s.json", "-o", "s.glb", "--object", "folded", "--quiet"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(has(workshop.read("s.glb"), R"("children":[1,2])"));
}

}  // namespace
}  // namespace sweepkit::test
