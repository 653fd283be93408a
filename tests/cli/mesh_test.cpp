// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Mesh files through every command, and what info --uv tells of a mapping.

#include <gtest/gtest.h>

#include <algorithm>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

constexpr const char* kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
constexpr const char* kObject = R"({"name": "t", "material": "m", "mesh": {"file": "t.obj"}})";
constexpr const char* kMaterial =
    R"("camera": {"width": 32, "height": 32}, "textures": {"c": {"procedural": "checker"}}, "materials": {"m": {"texture": "c"}})";

class MeshCommands : public testing::Test {
 protected:
  MeshCommands() {
    workshop.write("t.obj", kTetrahedron);
    workshop.write("t.json", scene_of(kObject, kMaterial));
  }
  Workshop workshop;
};

TEST_F(MeshCommands, GenerateRenderBakeAndCheckTakeAMesh) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"generate", "t.json", "-o", "t.glb", "--tangents"},
           {"generate", "t.json", "-o", "t.gltf"},
           {"render", "t.json", "-o", "t.png"},
           {"bake", "t.json", "--object", "t", "-o", "b.png", "--size", "16x16"},
           {"check", "t.json", "--strict"},
           {"generate", "t.json", "--explain"},
           {"info", "t.json"}}) {
    const Outcome run = workshop.sweepkit(arguments);
    EXPECT_EQ(run.status, 0) << arguments[0] << ": " << run.err;
  }
  const Outcome info = workshop.sweepkit({"info", "t.glb", "--json"});
  EXPECT_TRUE(has(info.out, R"({"mesh": "t", "triangles": 4, )")) << info.out;
}

TEST_F(MeshCommands, EachRowMayNameAnotherMesh) {
  workshop.write("u.obj", std::string(kTetrahedron) + "f 2 1 3\n");
  workshop.write("v.csv", "/objects/0/mesh/file\nt.obj\nu.obj\nmissing.obj\n");
  const Outcome run = workshop.sweepkit({"generate", "t.json", "--each", "v.csv", "-o", "m{row}.glb"});
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(has(run.err, "missing.obj: no such file")) << run.err;
  EXPECT_TRUE(has(workshop.sweepkit({"info", "m2.glb"}).out, "t             5"))
      << workshop.sweepkit({"info", "m2.glb"}).out;
}

TEST_F(MeshCommands, InfoTellsWhatAMeshFileHolds) {
  const Outcome run = workshop.sweepkit({"info", "t.obj"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(has(run.out, "kind: mesh, OBJ\n")) << run.out;
  EXPECT_TRUE(has(run.out, "places: 4\npolygons: 4\ntriangles: 4\nleft out: 0\nuv: no\nnormals: no\n"))
      << run.out;
  const Outcome json = workshop.sweepkit({"info", "t.obj", "--json"});
  EXPECT_TRUE(has(json.out, R"({"axis": "x", "from": 0, "to": 1, "size": 1})")) << json.out;
}

TEST_F(MeshCommands, ABadMeshIsRefusedBeforeAnythingIsWritten) {
  workshop.write("t.obj", "v 0 0 0\nf 1 2 3\n");
  const auto before = workshop.contents();
  const Outcome run = workshop.sweepkit({"generate", "t.json", "-o", "t.glb"});
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(has(run.err, "t.json:3:")) << run.err;
  EXPECT_TRUE(has(run.err, "/objects/0/mesh: t.obj:2:5: points at vertex 2, but there are 1")) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
  EXPECT_EQ(workshop.sweepkit({"info", "t.obj"}).status, 2);
  EXPECT_EQ(workshop.contents(), before);
}

// A plane of 4 m x 1 m under the unit square, whose scale makes it 8 x 1.
TEST_F(MeshCommands, InfoUvTellsTheDistortionInTheWorld) {
  workshop.write("p.json", scene_of(R"({"name": "p", "scale": [2, 1, 1], "plane": {"size": [4, 1]}})"));
  const Outcome run = workshop.sweepkit({"info", "p.json", "--uv", "--json"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(
      has(run.out, R"({"object": "p", "homogeneity u": 1, "homogeneity u 95%": 1, "homogeneity v": 1, )"))
      << run.out;
  EXPECT_TRUE(has(run.out, R"("aspect mean": 8, "aspect median": 8, "aspect 95%": 8, "aspect worst": 8)"))
      << run.out;
  EXPECT_TRUE(has(run.out, R"("continuous": 1, "overlap": 0, "degenerate": 0, "mirrored": 0})")) << run.out;
}

TEST_F(MeshCommands, InfoUvTakesAMeshFileAndOneObject) {
  const Outcome mesh = workshop.sweepkit({"info", "t.obj", "--uv"});
  EXPECT_EQ(mesh.status, 0) << mesh.err;
  EXPECT_TRUE(has(mesh.out, "homogeneity u")) << mesh.out;
  workshop.write("two.json", scene_of(std::string(kObject) + ",\n" + kBall, kMaterial));
  const Outcome one = workshop.sweepkit({"info", "two.json", "--uv", "--object", "ball"});
  EXPECT_TRUE(has(one.out, "ball")) << one.out;
  EXPECT_FALSE(has(one.out, "\nt ")) << one.out;
}

TEST_F(MeshCommands, AHeatMapIsWrittenWithItsScaleTold) {
  const Outcome run = workshop.sweepkit({"info", "t.json", "--uv", "--heat-map", "h.png", "--size", "20x10"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(has(run.err, "h.png: aspect ratio of \"t\", dark 1 to bright ")) << run.err;
  EXPECT_TRUE(has(workshop.sweepkit({"info", "h.png"}).out, "width: 20\nheight: 10\n"));
}

TEST_F(MeshCommands, AHeatMapThatCannotBeIsRefused) {
  workshop.write("two.json", scene_of(std::string(kObject) + ",\n" + kBall, kMaterial));
  const auto before = workshop.contents();
  for (const auto& [arguments, message] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"info", "two.json", "--uv", "--heat-map", "h.png"}, "say which with --object"},
           {{"info", "two.json", "--uv", "--heat-map", "h.xyz", "--object", "t"}, "h.xyz"},
           {{"info", "t.json", "--uv", "--heat-map", "no/h.png"}, "no"},
           {{"info", "t.json", "--uv", "--heat-map", "h.png", "--size", "0x5"}, "--size"},
           {{"info", "t.json", "--uv", "--object", "x"}, "there is no object \"x\""},
           {{"info", "t.json", "--heat-map", "h.png"}, "--uv"},
           {{"info", "t.png", "--uv"}, "--uv tells of a scene"}}) {
    const Outcome run = workshop.sweepkit(arguments);
    EXPECT_EQ(run.status, 2) << message;
    EXPECT_TRUE(has(run.err, message)) << run.err;
  }
  EXPECT_EQ(workshop.contents(), before);
}

}  // namespace
}  // namespace sweepkit::test
