// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Objects of mesh files, from the scene file to the mesh, the picture's plan and the findings.

#include <gtest/gtest.h>

#include "outline_measures.hpp"
#include "scene_text.hpp"
#include "sweepkit/scene/check.hpp"
#include "sweepkit/scene/gltf.hpp"
#include "sweepkit/scene/gltf_info.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/texmap/distortion.hpp"

namespace sweepkit::scene {
namespace {

using Product = Request::Product;
constexpr Request kFile{.product = Product::kMeshFile};

// A cube about (100, 0, 0) with outward faces.
const std::string kCube =
    "v 99 -1 -1\nv 101 -1 -1\nv 101 1 -1\nv 99 1 -1\nv 99 -1 1\nv 101 -1 1\nv 101 1 1\nv 99 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";
const std::string kCubeObject = R"({"name": "cube", "mesh": {"file": "cube.obj"}})";
// Two triangles of a square that share their edge with different (u,v).
const std::string kSeam =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0 0.5\n"
    "f 1/1 2/2 3/3\nf 1/5 3/3 4/4\n";

class MeshShapes : public testing::Test {
 protected:
  MeshShapes() {
    folder.write("cube.obj", kCube);
    folder.write("seam.obj", kSeam);
  }

  Document document(const std::string& objects, const std::string& beside = "") const {
    return parse_document(scene_text(beside, objects), folder.path() / "s.json");
  }
  Model model(const std::string& objects) const {
    const Document read = document(objects);
    return build(read, plan(read, kFile));
  }
  std::string fault(const std::string& objects) const {
    try {
      model(objects);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  Folder folder;
};

TEST_F(MeshShapes, HaveFlatFacesWhereTheyBendByMoreThanTheCrease) {
  const Model cube = model(kCubeObject);
  const MeshView& mesh = cube.scene.meshes[0];
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_EQ(mesh.origin.x, 100);
  for (const auto& triangle : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[triangle[0]]);
    const glm::dvec3 cross =
        glm::cross(glm::dvec3(mesh.positions[triangle[1]]) - a, glm::dvec3(mesh.positions[triangle[2]]) - a);
    for (const std::uint32_t vertex : triangle)
      EXPECT_NEAR(glm::dot(glm::normalize(cross), glm::dvec3(mesh.normals[vertex])), 1, 1e-6);
  }
}

// Each corner of a cube touches three faces; weighted by angle they count the same however a face is cut, so
// the mean points along the diagonal.
TEST_F(MeshShapes, AreSmoothBelowTheCreaseWithNormalsThatDoNotDependOnTheDiagonals) {
  const Model cube = model(R"({"name": "cube", "crease_deg": 91, "mesh": {"file": "cube.obj"}})");
  const MeshView& mesh = cube.scene.meshes[0];
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::dvec3 corner = glm::dvec3(mesh.positions[i]);
    EXPECT_NEAR(glm::dot(glm::normalize(corner), glm::dvec3(mesh.normals[i])), 1, 1e-6);
  }
}

TEST_F(MeshShapes, WithoutTexcoordsAreLaidOutOverTheTexture) {
  const Model cube = model(kCubeObject);
  const MeshView& mesh = cube.scene.meshes[0];
  const texmap::MappedSurface surface{mesh.positions, mesh.texcoords, mesh.triangles};
  EXPECT_EQ(texmap::find_overlap(surface), 0);
  // Its faces are squares, each one cell; a diagonal is always whole, and 6 of 18 edges are diagonals.
  const texmap::EdgeContinuity edges = texmap::count_continuous_edges(surface);
  EXPECT_EQ(edges.interior_edges, 18u);
  EXPECT_GT(edges.continuous_edges, 6u);
  EXPECT_EQ(sheet_ends(mesh), std::vector<std::uint32_t>{12});
  EXPECT_EQ(cube.ledger[Part::kLayouts].calls, 1u);
  // The right angle stands in the middle: one leg along u, the other along v.
  for (const auto& triangle : mesh.triangles) {
    const glm::vec2 a = mesh.texcoords[triangle[0]];
    const glm::vec2 b = mesh.texcoords[triangle[1]];
    const glm::vec2 c = mesh.texcoords[triangle[2]];
    EXPECT_TRUE((a.x == b.x && b.y == c.y) || (a.y == b.y && b.x == c.x));
  }
}

TEST_F(MeshShapes, KeepTheirOwnTexcoordsAndSplitVerticesAtSeams) {
  const Model square = model(R"({"name": "a", "uv": {"repeat": [2, 4]}, "mesh": {"file": "seam.obj"}})");
  const MeshView& mesh = square.scene.meshes[0];
  // Both ends of the diagonal are there twice: one differs in (u,v), the other is of another island.
  EXPECT_EQ(mesh.positions.size(), 6u);
  EXPECT_EQ(mesh.areas.size(), 2u);
  EXPECT_TRUE(mesh.areas[1].continues_sheet);
  EXPECT_EQ(mesh.texcoords[mesh.triangles[0][2]], glm::vec2(2, 4));
  EXPECT_EQ(mesh.texcoords[mesh.triangles[1][0]], glm::vec2(0, 2));
  EXPECT_EQ(square.ledger[Part::kLayouts].calls, 0u);
}

TEST_F(MeshShapes, KeepTheirOwnNormals) {
  folder.write("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 3e8 0 4e8\nvn 0 0 0\nf 1//1 2//1 3//2\n");
  const Model one = model(R"({"name": "a", "mesh": {"file": "n.obj"}})");
  const MeshView& mesh = one.scene.meshes[0];
  EXPECT_EQ(mesh.normals[mesh.triangles[0][0]].y, 0);
  for (const glm::vec3& normal : mesh.normals) EXPECT_NEAR(glm::length(glm::dvec3(normal)), 1, 1e-6);
}

TEST_F(MeshShapes, MayBePartsAndPlacedAndMirrored) {
  const Model both = model(
      R"({"name": "a", "tessellation": {"contour": 4, "trajectory": 4}, "parts": [{"plane": {"size": [1, 1]}},
      {"scale": [-1, 1, 1], "translate": [0, 5, 0], "mesh": {"file": "cube.obj"}}]})");
  EXPECT_EQ(both.scene.meshes[0].triangles.size(), 2u * 16 + 12);
  EXPECT_EQ(sheet_ends(both.scene.meshes[0]), (std::vector<std::uint32_t>{32, 44}));
}

TEST_F(MeshShapes, RefuseKeysThatAreForCurves) {
  const auto with = [&](const std::string& key) {
    return fault(R"({"name": "a", )" + key + R"(, "mesh": {"file": "cube.obj"}})");
  };
  EXPECT_NE(
      with(R"("tessellation": {"contour": 4})").find("/objects/0/tessellation: divides surfaces of curves"),
      std::string::npos);
  EXPECT_NE(with(R"("uv": {"by": "parameter"})").find("/objects/0/uv/by: is for (u,v) that run along curves"),
            std::string::npos);
  EXPECT_NE(with(R"("uv": {"size": 1})").find("/objects/0/uv/size: "), std::string::npos);
  EXPECT_NE(fault(R"({"name": "a", "mesh": {"file": "a.xyz"}})")
                .find("/objects/0/mesh/file: needs a file that ends"),
            std::string::npos);
  EXPECT_NE(fault(R"({"name": "a", "mesh": {}})").find("file"), std::string::npos);
  EXPECT_NE(
      fault(R"({"name": "a", "mesh": {"file": "cube.obj"}, "plane": {"size": [1, 1]}})").find("one shape"),
      std::string::npos);
}

TEST_F(MeshShapes, TellFaultsOfTheFileWithBothPlaces) {
  folder.write("bad.obj", "v 0 0 0\nf 1 2 3\n");
  const std::string fault = this->fault(R"({"name": "a", "mesh": {"file": "bad.obj"}})");
  EXPECT_NE(fault.find("s.json:1:"), std::string::npos) << fault;
  EXPECT_NE(fault.find("/objects/0/mesh: "), std::string::npos) << fault;
  EXPECT_NE(fault.find("bad.obj:2:5: points at vertex 2, but there are 1"), std::string::npos) << fault;
  folder.write("flat.obj", "v 0 0 0\nv 1e-40 0 0\nv 0 1e-40 0\nf 1 2 3\n");
  EXPECT_NE(this->fault(R"({"name": "a", "mesh": {"file": "flat.obj"}})").find("float32 positions need"),
            std::string::npos);
}

TEST_F(MeshShapes, AreLaidOutOnlyWhereSomeoneReadsTheTexcoords) {
  const std::string uv =
      R"("textures": {"t": {"procedural": "checker"}, "p": {"procedural": "marble", "on": "position"}},
    "materials": {"uv": {"texture": "t"}, "position": {"texture": "p"}})";
  const auto layouts = [&](const std::string& material, Product product) {
    const std::string object =
        R"({"name": "cube", "material": ")" + material + R"(", "mesh": {"file": "cube.obj"}})";
    const Document read = document(object, uv);
    const Plan needs = plan(read, {.product = product});
    const Model made = build(read, needs);
    EXPECT_EQ(made.ledger[Part::kLayouts].calls > 0, needs.needs_part(Part::kLayouts));
    return made.ledger[Part::kLayouts].calls;
  };
  EXPECT_EQ(layouts("uv", Product::kPicture), 1u);
  EXPECT_EQ(layouts("position", Product::kPicture), 0u);
  EXPECT_EQ(layouts("position", Product::kMeshFile), 1u);
  const Document floor = parse(scene_text(""));
  EXPECT_FALSE(plan(floor, kFile).needs_part(Part::kLayouts));
}

TEST_F(MeshShapes, AreWrittenAsGltfWithTangents) {
  const Document read = document(kCubeObject + R"(, {"name": "s", "mesh": {"file": "seam.obj"}})");
  const Plan needs = plan(read, kFile);
  const Model made = build(read, needs);
  const GltfFile gltf = make_gltf(made.scene, needs, "m.glb", {.has_tangents = true});
  const std::vector<std::byte>& bytes = gltf.files.back().bytes;
  folder.write("m.glb", std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  const GltfInfo info = read_gltf_info(folder.path() / "m.glb");
  ASSERT_EQ(info.meshes.size(), 2u);
  EXPECT_EQ(info.meshes[0].triangles, 12u);
  EXPECT_EQ(info.meshes[1].vertices, 6u);
}

// Two cubes, one half inside the other, in one file.
TEST_F(MeshShapes, AreLookedAtForCrossings) {
  const Document sound = document(kCubeObject);
  EXPECT_TRUE(check(sound, build(sound, plan(sound, kFile))).empty());
  std::string two = kCube;
  two +=
      "v 99.4 -0.5 -0.4\nv 101.3 -0.5 -0.4\nv 101.3 1.4 -0.4\nv 99.4 1.4 -0.4\n"
      "v 99.4 -0.5 1.5\nv 101.3 -0.5 1.5\nv 101.3 1.4 1.5\nv 99.4 1.4 1.5\n";
  two += "f 9 12 11 10\nf 13 14 15 16\nf 9 10 14 13\nf 11 12 16 15\nf 10 11 15 14\nf 12 9 13 16\n";
  folder.write("two.obj", two);
  const Document crossing = document(R"({"name": "a", "mesh": {"file": "two.obj"}})");
  const std::vector<SceneFinding> found = check(crossing, build(crossing, plan(crossing, kFile)));
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].finding.kind, sweep::FindingKind::kCrossing);
  EXPECT_EQ(found[0].finding.cure, "mend the file's mesh there");
}

}  // namespace
}  // namespace sweepkit::scene
