// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Objects from the command line alone: the same mesh as from a scene file, and messages that name the option.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

using Arguments = std::vector<std::string>;

Arguments with(Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

struct Same {
  std::string name;
  Arguments options;
  std::string sweep;      ///< the scene's
  std::string more = "";  ///< of its object
  std::string rest = "";  ///< of the scene
};

void PrintTo(const Same& same, std::ostream* stream) {
  *stream << same.sweep;
}

class CurveOptions : public testing::TestWithParam<Same> {};

TEST_P(CurveOptions, MakeWhatTheSceneFileMakes) {
  const Same& same = GetParam();
  const Workshop workshop;
  workshop.write("box.svg", R"(<svg xmlns="http://www.w3.org/2000/svg"><rect width="9" height="9"/>)"
                            R"(<rect id="low" width="30" height="10"/></svg>)");
  workshop.write("way.xyz", "0 0 0\n1 0 0\n1 1 0\n1 1 1\n");
  workshop.write("ring.json", R"({"circle": {"radius": 0.1}})");
  workshop.write("scene.json",
                 scene_of(R"({"name": "sweep", "sweep": {)" + same.sweep + "}" + same.more + "}", same.rest));
  const Outcome run = workshop.sweepkit(with({"generate", "-o", "options.glb", "--no-extras"}, same.options));
  ASSERT_EQ(run.status, 0) << run.err;
  ASSERT_EQ(workshop.sweepkit({"generate", "scene.json", "-o", "scene.glb", "--no-extras"}).status, 0);
  EXPECT_TRUE(workshop.read("options.glb") == workshop.read("scene.glb"));
}

const std::string kCircle = R"("contour": {"circle": {"radius": 0.1}})";
const std::string kLine = R"("trajectory": {"line": [[0, 0, 0], [0, 2, 0]]})";
const Arguments kOfCircle = {"--contour", "circle:0.1"};
const Arguments kOfLine = {"--trajectory", "line:0,0,0,0,2,0"};
const Arguments kOfBoth = with(kOfCircle, kOfLine);

INSTANTIATE_TEST_SUITE_P(
    Each, CurveOptions,
    testing::Values(
        Same{"Primitives", kOfBoth, kCircle + ", " + kLine},
        Same{"NamedValues", with(kOfCircle, {"--trajectory", "helix:turns=2,radius=1,pitch=0.5"}),
             kCircle + R"(, "trajectory": {"helix": {"radius": 1, "pitch": 0.5, "turns": 2}})"},
        Same{"ValuesInOrder",
             with({"--contour", "rectangle:0.2,0.1,corner_radius=0.02"},
                  {"--trajectory", "torus_knot:2,3,1,0.4"}),
             R"("contour": {"rectangle": {"width": 0.2, "height": 0.1, "corner_radius": 0.02}},
                "trajectory": {"torus_knot": {"p": 2, "q": 3, "radius": 1, "tube": 0.4}})"},
        Same{"APath", with({"--contour", "path:M0 0 L1 0 1 1Z"}, kOfLine),
             R"("contour": {"path": "M0 0 L1 0 1 1Z"}, )" + kLine},
        Same{"AFileOfJson", with({"--contour", "ring.json"}, kOfLine), kCircle + ", " + kLine},
        Same{"Json", with({"--contour", R"({"circle": {"radius": 0.1}})"}, kOfLine), kCircle + ", " + kLine},
        Same{"SvgWithIdAndScale", with({"--contour", "box.svg#low:scale=0.01"}, kOfLine),
             R"("contour": {"svg": "box.svg", "id": "low", "scale": 0.01}, )" + kLine},
        Same{"PointsClosedAndSmooth", with(kOfCircle, {"--trajectory", "way.xyz:closed=true,smooth=true"}),
             kCircle + R"(, "trajectory": {"csv": "way.xyz", "closed": true, "smooth": true})"},
        Same{"Laws", with(kOfBoth, {"--profile", "0:1,0.5:0.3,1:1", "--twist", "90"}),
             kCircle + ", " + kLine +
                 R"(, "profile": {"points": [[0, 1], [0.5, 0.3], [1, 1]]}, "twist_deg": 90)"},
        Same{"LawsAsJson", with(kOfBoth, {"--profile", R"({"x": 0.5})", "--twist", "0:0,1:-45"}),
             kCircle + ", " + kLine +
                 R"(, "profile": {"x": 0.5}, "twist_deg": {"points": [[0, 0], [1, -45]]})"},
        Same{"FramesCapsAndJoints",
             with(kOfCircle, {"--trajectory", "way.xyz", "--sweep-frames", "fixed-up", "--caps", "round",
                              "--joints", "bevel"}),
             kCircle + R"(, "trajectory": {"csv": "way.xyz"}, "frames": "fixed-up", "caps": "round",
                "joints": "bevel")"},
        Same{"AGuide", with(kOfBoth, {"--guide", "line:1,0,0,0,2,1"}),
             kCircle + ", " + kLine + R"(, "guide": {"line": [[1, 0, 0], [0, 2, 1]]})"},
        Same{"Tolerance", with(kOfBoth, {"--tolerance", "1e-3"}), kCircle + ", " + kLine,
             R"(, "tessellation": {"tolerance": 1e-3})"},
        Same{"Cells", with(kOfBoth, {"--cells", "7x5"}), kCircle + ", " + kLine,
             R"(, "tessellation": {"contour": 7, "trajectory": 5})"},
        Same{"ATexture", with(kOfBoth, {"--texture", "checker"}), kCircle + ", " + kLine,
             R"(, "material": "material")",
             R"("textures": {"texture": {"procedural": "checker"}}, "materials": {"material": {"texture":
                "texture"}})"},
        Same{"ASizeOfTexture", with(kOfBoth, {"--texture-size", "0.1x0.25"}), kCircle + ", " + kLine,
             R"(, "uv": {"size": [0.1, 0.25]})"},
        Same{"SetAfterAll", with(kOfBoth, {"--set", "/objects/0/sweep/twist_deg=30"}),
             kCircle + ", " + kLine + R"(, "twist_deg": 30)"}),
    [](const auto& test) { return test.param.name; });

TEST(CurveOptions, AreTakenByEveryCommandThatTakesAScene) {
  const Workshop workshop;
  const Outcome render = workshop.sweepkit(with({"render", "-o", "a.png", "--size", "32x32"}, kOfBoth));
  EXPECT_EQ(render.status, 0) << render.err;
  const Outcome bake = workshop.sweepkit(
      with({"bake", "-o", "b.png", "--object", "sweep", "--size", "8x8", "--texture", "bands"}, kOfBoth));
  EXPECT_EQ(bake.status, 0) << bake.err;
  const Outcome check =
      workshop.sweepkit(with({"check", "--strict", "--trajectory", "circle:0.05"}, kOfCircle));
  EXPECT_EQ(check.status, 3);
  EXPECT_NE(check.out.find("fold"), std::string::npos);
  workshop.write("values.csv", "/objects/0/sweep/twist_deg\n10\n20\n");
  const Outcome each =
      workshop.sweepkit(with({"generate", "--each", "values.csv", "-o", "v{row}.glb"}, kOfBoth));
  EXPECT_EQ(each.status, 0) << each.err;
  EXPECT_FALSE(workshop.read("v1.glb") == workshop.read("v2.glb"));
}

struct Refused {
  std::string name;
  Arguments options;
  std::string message;
};

void PrintTo(const Refused& refused, std::ostream* stream) {
  *stream << refused.message;
}

class RefusedOptions : public testing::TestWithParam<Refused> {};

TEST_P(RefusedOptions, AreNamed) {
  const Workshop workshop;
  workshop.write("half.json", "{\"circle\":\n {\"radius\": ");
  workshop.write("small.json", "{\"circle\":\n {\"radius\": -1}}");
  const auto before = workshop.contents();
  const Outcome run = workshop.sweepkit(with({"generate", "-o", "out.glb"}, GetParam().options));
  EXPECT_EQ(run.err, "sweepkit: " + GetParam().message + "\n");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(workshop.contents(), before);
}

const std::string kKinds =
    "needs a file (.svg .csv .txt .xyz .dat .json), JSON or a primitive (circle, ellipse, rectangle, "
    "polygon, "
    "star, arc, helix, torus_knot, line, path), got ";

INSTANTIATE_TEST_SUITE_P(
    Each, RefusedOptions,
    testing::Values(
        Refused{"NoTrajectory", kOfCircle, "--trajectory: is needed where there is no scene file"},
        Refused{"NoContour", kOfLine, "--contour: is needed where there is no scene file"},
        Refused{"ASceneTo", with({"scene.json"}, kOfBoth),
                "scene.json: is a scene file; beside one change values with --set, or leave it out"},
        Refused{"NoSuchKind", with({"--contour", "squircle:1"}, kOfLine),
                "--contour: " + kKinds + "\"squircle:1\""},
        Refused{"ManyValues", with({"--contour", "circle:1,2"}, kOfLine),
                "--contour: circle takes at most 1 value, got \"2\""},
        Refused{"NoNumber", with({"--contour", "circle:wide"}, kOfLine),
                "--contour: /objects/0/sweep/contour/circle/radius: needs a number, got a string"},
        Refused{"AValueMissing", with(kOfCircle, {"--trajectory", "helix:1,2"}),
                "--trajectory: /objects/0/sweep/trajectory/helix: needs \"turns\""},
        Refused{"ALineOfFive", with(kOfCircle, {"--trajectory", "line:0,0,0,1,1"}),
                "--trajectory: a line is line:X,Y,X,Y or line:X,Y,Z,X,Y,Z, got \"line:0,0,0,1,1\""},
        Refused{"NoFile", with({"--contour", "none.json"}, kOfLine), "none.json: no such file"},
        Refused{
            "HalfAFile", with({"--contour", "half.json"}, kOfLine),
            "half.json:2:13: not valid JSON: while parsing value - unexpected end of input; expected '[', "
            "'{', or a literal"},
        Refused{
            "AFilesValue", with({"--contour", "small.json"}, kOfLine),
            "small.json:2:13: /objects/0/sweep/contour/circle/radius: needs to be at least 1e-09 and at most "
            "1e+09 m, got -1"},
        Refused{
            "NoLaw", with(kOfBoth, {"--profile", "0:1,1"}),
            "--profile: needs a number, values along the way such as 0:1,0.5:0.3,1:1, a .json file or JSON, "
            "got \"0:1,1\""},
        Refused{
            "NoCells", with(kOfBoth, {"--cells", "12"}),
            "--cells: needs two numbers of cells, along contour and trajectory, such as 48x200, got \"12\""},
        Refused{"NoTolerance", with(kOfBoth, {"--tolerance", "fine"}),
                "--tolerance: needs metres, such as 0.001, got \"fine\""},
        Refused{"NoSizeOfTexture", with(kOfBoth, {"--texture-size", "1x2x3"}),
                "--texture-size: needs metres, such as 0.5 or 0.5x0.25, got \"1x2x3\""},
        Refused{"NoImage", with(kOfBoth, {"--texture", "none.png"}),
                "--texture: /textures/texture/image: none.png: no such file"},
        Refused{"NoFrames", with(kOfBoth, {"--sweep-frames", "loose"}),
                "--sweep-frames: /objects/0/sweep/frames: needs \"rotation-minimizing\", \"frenet\" or "
                "\"fixed-up\", got "
                "\"loose\""},
        Refused{
            "WhatTheSweepRefuses",
            with(kOfCircle, {"--trajectory", R"({"polyline": [[0, 0, 0], [1, 0, 0], [0.5, 0, 0]]})"}),
            "command line: /objects/0/sweep: trajectory turns back on itself at 1 m along it; no joint bends "
            "that sharply: lead it round"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace sweepkit::test
