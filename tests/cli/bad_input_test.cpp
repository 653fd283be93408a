// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Bad input and bad usage: one line that says where and what, the right exit status, and no file left behind.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

const std::vector<std::string> kGenerate = {"generate", "scene.json", "-o", "out.glb"};
const std::vector<std::string> kRender = {"render", "scene.json", "-o", "out.png"};

struct Case {
  std::string name;
  std::string scene;    ///< scene.json; none where it is empty
  std::string message;  ///< after "sweepkit: "
  std::vector<std::string> arguments = kGenerate;
  int status = 2;
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.message;
}

class BadInput : public testing::TestWithParam<Case> {};

TEST_P(BadInput, IsRefusedInOneLineAndLeavesNoFile) {
  const Case& c = GetParam();
  const Workshop workshop;
  std::filesystem::create_directory(workshop.folder() / "folder");
  workshop.write("notes.txt", "no image");
  workshop.write("old.glb", "what was there before");
  std::ifstream whole(SWEEPKIT_SAMPLES "/textures/floor_tiles.png", std::ios::binary);
  std::string head(300, '\0');
  whole.read(head.data(), static_cast<std::streamsize>(head.size()));
  workshop.write("cut.png", head);
  if (!c.scene.empty()) workshop.write("scene.json", c.scene);
  const auto before = workshop.contents();

  const Outcome run = workshop.sweepkit(c.arguments);
  EXPECT_EQ(run.err, "sweepkit: " + c.message + "\n");
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.status, c.status);
  EXPECT_EQ(workshop.contents(), before);
}

// One object on line 3.
std::string with_object(const std::string& object) {
  return scene_of(object);
}
std::string with_plane(const std::string& more) {
  return scene_of(R"({"name": "x", "plane": {"size": [1, 1]}, )" + more + "}");
}
std::string with_tube(const std::string& contour, const std::string& more = "") {
  return scene_of(R"({"name": "x", "sweep": {"trajectory": {"line": [[0, 0, 0], [0, 1, 0]]}, "contour": )" +
                  contour + "}" + more + "}");
}
// A textured plane; the image's name is on line 5.
std::string with_image(const std::string& file) {
  return scene_of(
      R"({"name": "x", "material": "m", "plane": {"size": [1, 1]}})",
      R"( "textures": {"t": {"image": ")" + file + R"("}}, "materials": {"m": {"texture": "t"}})");
}
const std::string kPlain = with_object(R"({"name": "x", "plane": {"size": [1, 1]}})");

INSTANTIATE_TEST_SUITE_P(
    InTheScene, BadInput,
    testing::Values(
        Case{"MissingFile", "", "scene.json: no such file"},
        Case{"FolderForAScene",
             "",
             "folder: is a folder, not a scene file",
             {"generate", "folder", "-o", "out.glb"}},
        Case{"EmptyFile", "\n",
             "scene.json:2:1: not valid JSON: while parsing value - unexpected end of input; expected '[', "
             "'{', or a "
             "literal"},
        Case{"BrokenJson", "{\"sweepkit\": 1,\n \"objects\": [}",
             "scene.json:2:14: not valid JSON: while parsing value - unexpected '}'; expected '[', '{', or a "
             "literal"},
        Case{
            "UnknownKey", with_plane(R"("colour": 3)"),
            R"(scene.json:3:42: /objects/0/colour: unknown key "colour"; there is "name", "material", "translate", "rotate_deg", "scale", "instances", "tessellation", "uv", "crease_deg", "sweep", "revolve", "plane", "mesh", "parts")"},
        Case{"MisspeltKey", with_plane(R"("materiel": "m")"),
             R"(scene.json:3:42: /objects/0/materiel: unknown key "materiel"; did you mean "material"?)"},
        Case{"NoInstances", with_plane(R"("instances": [])"),
             "scene.json:3:55: /objects/0/instances: needs at least one instance; leave it out for the "
             "object by "
             "itself"},
        Case{"WrongType", with_object(R"({"name": "x", "plane": {"size": "big"}})"),
             "scene.json:3:33: /objects/0/plane/size: needs 2 numbers in an array, got a string"},
        Case{"OneControlPoint", with_tube(R"({"bezier": [[0, 0]]})"),
             "scene.json:3:95: /objects/0/sweep/contour/bezier: needs at least 2 control points, got 1"},
        Case{"NaN", with_object(R"({"name": "x", "plane": {"size": [1, NaN]}})"),
             "scene.json:3:37: not valid JSON: while parsing value - invalid literal"},
        Case{"NumberBeyondADouble", with_object(R"({"name": "x", "plane": {"size": [1, 1e999]}})"),
             "scene.json:3:37: the number '1e999' is too large"},
        Case{"NumberBeyondAFloat", with_object(R"({"name": "x", "plane": {"size": [1, 1e39]}})"),
             "scene.json:3:37: /objects/0/plane/size/1: needs to be at least 1e-09 and at most 1e+09 m, got "
             "1e+39"},
        Case{"ZeroRadius", with_tube(R"({"circle": {"radius": 0}})"),
             "scene.json:3:106: /objects/0/sweep/contour/circle/radius: needs to be at least 1e-09 and at "
             "most 1e+09 "
             "m, got 0"},
        Case{"NegativeRadius", with_tube(R"({"circle": {"radius": -1}})"),
             "scene.json:3:106: /objects/0/sweep/contour/circle/radius: needs to be at least 1e-09 and at "
             "most 1e+09 "
             "m, got -1"},
        Case{"NegativeCount", with_plane(R"("tessellation": {"contour": -4})"),
             "scene.json:3:70: /objects/0/tessellation/contour: needs to be at least 1 and at most 32768 "
             "cells, got -4"},
        Case{"CountOfNone", with_plane(R"("tessellation": {"contour": 0})"),
             "scene.json:3:70: /objects/0/tessellation/contour: needs to be at least 1 and at most 32768 "
             "cells, got 0"},
        Case{"EnormousCount", with_plane(R"("tessellation": {"contour": 1000000000})"),
             "scene.json:3:70: /objects/0/tessellation/contour: needs to be at least 1 and at most 32768 "
             "cells, got "
             "1e+09"},
        Case{"HalfACell", with_plane(R"("tessellation": {"contour": 2.5})"),
             "scene.json:3:70: /objects/0/tessellation/contour: needs a whole number, got 2.5"},
        Case{"CountsEnormousTogether",
             with_tube(R"({"circle": {"radius": 1}})",
                       R"(, "tessellation": {"contour": 32768, "trajectory": 32768})"),
             "scene.json:3:24: /objects/0/sweep: has too many triangles for 32-bit indices; ask for fewer "
             "cells"},
        Case{"UnknownMaterial", with_plane(R"("material": "gold")"),
             R"(scene.json:3:54: /objects/0/material: there is no material "gold": the scene has none)"},
        Case{"ContourOfOnePlace", with_tube(R"({"polyline": [[1, 1], [1, 1], [1, 1]]})"),
             "scene.json:3:97: /objects/0/sweep/contour/polyline: has no length: all its points are the "
             "same; give "
             "two that differ"},
        Case{"RevolvedContourAcrossTheAxis",
             with_object(R"({"name": "x", "revolve": {"contour": {"polyline": [[-1, 0], [1, 1]]}}})"),
             "scene.json:3:26: /objects/0/revolve: contour crosses the axis: x is -1 m at height 0 m; keep "
             "x, the "
             "distance from it, at 0 or above"},
        Case{"NoObjects", "{\"sweepkit\": 1, \"objects\": []}",
             "scene.json:1:28: /objects: needs at least one object"},
        Case{"TwoObjectsOfOneName",
             scene_of("{\"name\": \"x\", \"plane\": {\"size\": [1, 1]}},\n{\"name\": \"x\", \"plane\": "
                      "{\"size\": [1, 1]}}"),
             R"(scene.json:4:1: /objects/1: the name "x" is taken by an object before; choose another)"},
        Case{"AnotherVersion", "{\"sweepkit\": 2, \"objects\": []}",
             "scene.json:1:14: /sweepkit: this program reads version 1 of the scene format, got 2"},
        Case{"NestingWithoutEnd", std::string(100000, '['),
             "scene.json:1:65: values are nested deeper than 64 levels; the scene needs fewer"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    InATexture, BadInput,
    testing::Values(
        Case{"MissingImage", with_image("none.png"),
             "scene.json:5:30: /textures/t/image: none.png: no such file"},
        Case{"FolderForAnImage", with_image("folder"),
             "scene.json:5:30: /textures/t/image: folder: is a folder, not an image"},
        Case{"TextForAnImage", with_image("notes.txt"),
             "scene.json:5:30: /textures/t/image: notes.txt: cannot be read as an image: OpenImageIO could "
             "not find a "
             "format reader for \"notes.txt\". Is it a file format that OpenImageIO doesn't know about?"},
        Case{
            "ImageCutShort", with_image("cut.png"),
            "scene.json:5:30: /textures/t/image: cut.png: cannot be read as an image: Read error: hit end of "
            "file PNG read error: IDAT: Read error: hit end of file PNG library error"},
        Case{
            "ImageCutShortInARender", with_image("cut.png"),
            "scene.json:5:30: /textures/t/image: cut.png: cannot be read as an image: Read error: hit end of "
            "file PNG read error: IDAT: Read error: hit end of file PNG library error",
            kRender},
        Case{"NothingToBake",
             kPlain,
             "scene.json:3:1: /objects/0: the object \"x\" has no texture; give its material one",
             {"bake", "scene.json", "--object", "x", "-o", "out.png"}}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    InTheOutput, BadInput,
    testing::Values(Case{"MissingFolder",
                         kPlain,
                         "none/out.glb: there is no folder none; make it first",
                         {"generate", "scene.json", "-o", "none/out.glb"}},
                    Case{"MissingFolderIsFoundBeforeAnyWork",
                         "",
                         "none/out.png: there is no folder none; make it first",
                         {"render", "scene.json", "-o", "none/out.png"}},
                    Case{"FolderForAFile",
                         kPlain,
                         "folder.glb/: a model's name ends in .glb, .gltf, .obj, .ply, .stl or .off",
                         {"generate", "scene.json", "-o", "folder.glb/"}},
                    Case{"FolderForAPicture",
                         kPlain,
                         "folder: is a folder; name a file in it",
                         {"render", "scene.json", "-o", "folder", "--format", "png"}},
                    Case{"FolderForStatistics",
                         kPlain,
                         "folder: is a folder; name a file in it",
                         {"render", "scene.json", "-o", "out.png", "--stats", "folder"}},
                    Case{"OneFileForTwoOutputs",
                         kPlain,
                         "--stats: needs another file than -o, got \"out.png\" for both",
                         {"render", "scene.json", "-o", "out.png", "--stats", "out.png"}},
                    Case{"FullDisk",
                         kPlain,
                         "/dev/full: cannot be written: No space left on device",
                         {"render", "scene.json", "-o", "/dev/full", "--format", "png", "--size", "9x9"},
                         1},
                    Case{"FullDiskForTheSecondFile",
                         kPlain,
                         "/dev/full: cannot be written: No space left on device",
                         {"render", "scene.json", "-o", "out.png", "--size", "9x9", "--stats", "/dev/full"},
                         1},
                    Case{"UnknownModelFormat",
                         kPlain,
                         "out.fbx: a model's name ends in .glb, .gltf, .obj, .ply, .stl or .off",
                         {"generate", "scene.json", "-o", "out.fbx"}},
                    Case{"UnknownPictureFormat",
                         kPlain,
                         "out.bmp: a picture's name ends in .png, .jpg, .tif or .exr",
                         {"render", "scene.json", "-o", "out.bmp"}}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    OnTheCommandLine, BadInput,
    testing::Values(
        Case{"NoCommand",
             "",
             "needs a command (generate, render, assemble, bake, info, check, report, view, schema); see "
             "sweepkit "
             "--help",
             {}},
        Case{"UnknownCommand",
             "",
             "needs a command (generate, render, assemble, bake, info, check, report, view, schema), got "
             "\"draw\"; "
             "see "
             "sweepkit "
             "--help",
             {"draw", "scene.json"}},
        Case{"NoScene",
             "",
             "needs a scene file, or --contour and --trajectory",
             {"generate", "-o", "out.glb"}},
        Case{"NoOutput", kPlain, "-o FILE is needed (or --explain)", {"render", "scene.json"}},
        Case{"UnknownOption",
             kPlain,
             "The following argument was not expected: --frobnicate; see sweepkit render --help",
             {"render", "scene.json", "-o", "out.png", "--frobnicate"}},
        Case{"OneFileTooMany",
             kPlain,
             "The following argument was not expected: more; see sweepkit generate --help",
             {"generate", "scene.json", "-o", "out.glb", "more"}},
        Case{"ThreadsInWords",
             kPlain,
             "--threads: Value many not in range 1 to 1024; see sweepkit render --help",
             {"render", "scene.json", "-o", "out.png", "--threads", "many"}},
        Case{"NoThreads",
             kPlain,
             "--threads: Value 0 not in range 1 to 1024; see sweepkit render --help",
             {"render", "scene.json", "-o", "out.png", "--threads", "0"}},
        Case{"UnknownFilter",
             kPlain,
             "--filter: magic not in "
             "{point,bilinear,trilinear,integral-1,integral-2,integral-3,ewa,box,auto}; "
             "see sweepkit render "
             "--help",
             {"render", "scene.json", "-o", "out.png", "--filter", "magic"}},
        Case{"HalfASize",
             kPlain,
             "--size: needs WIDTHxHEIGHT in pixels, each 1 to 32768, such as 640x480, got \"640\"",
             {"render", "scene.json", "-o", "out.png", "--size", "640"}},
        Case{"EnormousSize",
             kPlain,
             "--size: needs at most 2^28 pixels (16384x16384), got 32768x32768",
             {"render", "scene.json", "-o", "out.png", "--size", "32768x32768"}},
        Case{"EnormousSizeInTheScene",
             kPlain,
             "scene.json: /camera: needs at most 2^28 pixels, got 65536 x 65536; give a smaller --size",
             {"render", "scene.json", "-o", "out.png", "--set",
              R"(/camera={"width": 65536, "height": 65536})"}},
        Case{"SettingWithoutAValue",
             kPlain,
             "--set: needs POINTER=VALUE, such as /objects/0/name=vase, got \"/ambient\"",
             {"generate", "scene.json", "-o", "out.glb", "--set", "/ambient"}},
        Case{"SettingOfAWrongType",
             kPlain,
             "--set: /ambient: needs 3 numbers in an array, got a string",
             {"generate", "scene.json", "-o", "out.glb", "--set", "/ambient=bright"}},
        Case{"SettingOfNothing",
             kPlain,
             "--set: /objects/7/name: there is no entry \"7\": /objects has the entries 0 to 0; append with "
             "\"-\"",
             {"generate", "scene.json", "-o", "out.glb", "--set", "/objects/7/name=y"}},
        Case{"UnknownObject",
             kPlain,
             "--object: there is no object \"y\"; there is \"x\"",
             {"generate", "scene.json", "-o", "out.glb", "--object", "y"}},
        Case{"FileThatIsNotThere", "", "none.png: no such file", {"info", "none.png"}},
        Case{"TextForAModel",
             "",
             "old.glb:1:1: not valid JSON: while parsing value - invalid literal",
             {"info", "old.glb"}}),
    [](const auto& test) { return test.param.name; });

TEST(FailedWrite, LeavesTheFileThatWasThereBefore) {
  const Workshop workshop;
  workshop.write("scene.json", kPlain);
  workshop.write("out.png", "what was there before");
  const auto before = workshop.contents();
  EXPECT_EQ(
      workshop.sweepkit({"render", "scene.json", "-o", "out.png", "--stats", "/dev/full", "--size", "9x9"})
          .status,
      1);
  EXPECT_EQ(workshop.contents(), before);
}

TEST(FailedWrite, BeyondTheLargestFileAllowedSaysSoAndLeavesNothing) {
  const Workshop workshop;
  workshop.write("scene.json", scene_of(kBall));
  const auto before = workshop.contents();
  // 4 KiB, of which the ball needs some 20.
  const Outcome run = workshop.shell("ulimit -f 4; sweepkit generate scene.json -o out.glb");
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "sweepkit: out.glb: cannot be written: File too large\n");
  EXPECT_EQ(workshop.contents(), before);
}

TEST(LockedFolder, IsRefusedBeforeAnyWork) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const Workshop workshop;
  workshop.write("scene.json", kPlain);
  const std::filesystem::path locked = workshop.folder() / "locked";
  std::filesystem::create_directory(locked);
  std::filesystem::permissions(locked,
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  const Outcome run = workshop.sweepkit({"generate", "scene.json", "-o", "locked/out.glb"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "sweepkit: locked/out.glb: cannot be written: Permission denied\n");
}

TEST(MemoryLimit, RefusesAPictureThatItLeavesNoRoomFor) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer needs terabytes of addresses";
#endif
  const Workshop workshop;
  workshop.write("scene.json", scene_of(kBall));
  const auto before = workshop.contents();
  // 200 MB, of which a picture of 8192 x 8192 pixels needs four times as much.
  const Outcome run =
      workshop.shell("ulimit -d 200000; sweepkit render scene.json -o out.png --size 8192x8192");
  EXPECT_EQ(run.status, 2);
  const std::regex message(
      "sweepkit: scene\\.json: needs about [0-9.]+ GiB of memory, for 768 triangles, 1 object and what is "
      "made "
      "of them, and ulimit -d leaves 1[0-9][0-9] MiB; ask for fewer cells or pixels, or run it where there "
      "is "
      "more\n");
  EXPECT_TRUE(std::regex_match(run.err, message)) << run.err;
  EXPECT_EQ(workshop.contents(), before);
}

}  // namespace
}  // namespace sweepkit::test
