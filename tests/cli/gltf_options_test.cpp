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
  for (const std::vector<std::string>& option :
       std::vector<std::vector<std::string>>{{"--unlit"},
                                             {"--compatible"},
                                             {"--tangents"},
                                             {"--images", "separate"},
                                             {"--image-format", "jpg"},
                                             {"--max-texture", "64"},
                                             {"--quantize"},
                                             {"--position-bits", "12"},
                                             {"--meshopt"},
                                             {"--minimal"},
                                             {"--turntable", "8"},
                                             {"--grow", "8"}}) {
    std::vector<std::string> arguments = {"generate", "s.json", "-o", "b.stl"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    const Outcome run = workshop.sweepkit(arguments);
    EXPECT_EQ(run.status, 2);
    const std::string start = "sweepkit: " + option[0] + ": is for .glb and .gltf";
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

TEST(GltfOptions, QuantizingIsNotForCompatibleFilesAndItsBitsNotForOthers) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(kBall));
  const Outcome both = workshop.sweepkit({"generate", "s.json", "-o", "b.glb", "--quantize", "--compatible"});
  EXPECT_EQ(both.status, 2);
  EXPECT_EQ(
      both.err,
      "sweepkit: --quantize: is an extension, and --compatible is for viewers that know none; leave one "
      "out\n");
  const Outcome bits = workshop.sweepkit({"generate", "s.json", "-o", "b.glb", "--position-bits", "12"});
  EXPECT_EQ(bits.status, 2);
  EXPECT_EQ(bits.err, "sweepkit: --position-bits: is for quantized positions; add --quantize\n");
}

TEST(GltfOptions, TrianglesThatQuantizingLeavesNoAreaAreTold) {
  const Workshop workshop;
  // A tube of 1 mm along 1 km of line: at 8 bits a step is 4 m.
  workshop.write("s.json",
                 scene_of(R"({"name": "wire", "tessellation": {"contour": 8, "trajectory": 4}, "sweep": {
      "contour": {"circle": {"radius": 0.001}}, "trajectory": {"line": [[0, 0, 0], [0, 1000, 0]]}}})"));
  const Outcome wire =
      workshop.sweepkit({"generate", "s.json", "-o", "w.glb", "--quantize", "--position-bits", "8"});
  EXPECT_EQ(wire.status, 2);
  EXPECT_NE(wire.err.find("the object \"wire\" is too thin to be quantized: no triangle keeps its area"),
            std::string::npos)
      << wire.err;
  workshop.write("t.json", scene_of(std::string(kBall)));
  const Outcome ball =
      workshop.sweepkit({"generate", "t.json", "-o", "b.glb", "--quantize", "--position-bits", "8", "--set",
                         "/objects/0/tessellation={\"contour\":400,\"trajectory\":400}"});
  EXPECT_EQ(ball.status, 0) << ball.err;
  EXPECT_NE(ball.err.find(" without area when quantized are left out)"), std::string::npos) << ball.err;
}

TEST(GltfOptions, SeparateImagesNeedAFolder) {
  const Workshop workshop;
  workshop.write("s.json", scene_of(kBall));
  const Outcome run = workshop.sweepkit({"generate", "s.json", "-o", "-", "--images", "separate"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "sweepkit: --images: separate needs a folder, and -o - is standard output alone\n");
  EXPECT_EQ(run.out, "");
}

TEST(GltfOptions, PutImagesBesideAGlbAndIntoAGltfsBuffer) {
  const Workshop workshop;
  workshop.write(
      "s.json",
      scene_of(R"({"name": "x", "material": "m", "plane": {"size": [1, 1]}})",
               R"("textures": {"t": {"procedural": "checker"}}, "materials": {"m": {"texture": "t"}})"));
  const auto names = [&] {
    std::string all;
    for (const auto& [name, content] : workshop.contents()) all += name + " ";
    return all;
  };
  ASSERT_EQ(workshop
                .sweepkit({"generate", "s.json", "-o", "a.glb", "--images", "separate", "--image-format",
                           "jpg", "--max-texture", "32"})
                .status,
            0);
  EXPECT_EQ(names(), "a.glb a_0.jpg s.json ");
  EXPECT_EQ(workshop.read("a_0.jpg").substr(0, 2), "\xff\xd8");
  ASSERT_EQ(
      workshop.sweepkit({"generate", "s.json", "-o", "b.gltf", "--images", "embedded", "--bake-size", "32"})
          .status,
      0);
  EXPECT_EQ(names(), "a.glb a_0.jpg b.bin b.gltf s.json ");
}

}  // namespace
}  // namespace sweepkit::test
