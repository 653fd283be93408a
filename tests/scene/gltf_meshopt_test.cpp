// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Packed files are unpacked by meshoptimizer's own decoders and laid beside the files that are not packed.

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "gltf_meshopt.hpp"
#include "parsed_gltf.hpp"
#include "strip_order.hpp"

namespace sweepkit::scene {
namespace {

const std::string kMaterial = R"("materials": {"m": {}})";
const std::string kTextured =
    R"("textures": {"t": {"procedural": "checker"}}, "materials": {"m": {"texture": "t"}})";
const std::string kCup =
    R"({"name": "cup", "material": "m", "tessellation": {"contour": 30, "trajectory": 41},
        "revolve": {"contour": {"polyline": [[0, 0], [0.1, 0], [0.1, 0.2], [0.09, 0.2], [0.09, 0.01], [0, 0.01]]}}})";
const std::string kTube =
    R"({"name": "tube", "material": "m", "tessellation": {"contour": 24, "trajectory": 60}, "uv": {"repeat": [3, 1]},
        "sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"helix": {"radius": 1, "pitch": 0.5, "turns": 2}}}})";
const std::string kShapes = kCup + ", " + kTube;

// The bytes that a view unpacks to, by meshoptimizer.
std::vector<std::byte> unpacked(const Parsed& parsed, std::size_t index) {
  const json& view = parsed.root["bufferViews"][index];
  const std::size_t length = view["byteLength"];
  if (view["buffer"] == 0) return {parsed.view(index), parsed.view(index) + length};
  const json& packing = view["extensions"]["EXT_meshopt_compression"];
  const auto* source = reinterpret_cast<const unsigned char*>(parsed.buffer.data() +
                                                              packing.value("byteOffset", std::size_t{0}));
  const std::size_t size = packing["byteLength"];
  const std::size_t count = packing["count"];
  const std::size_t stride = packing["byteStride"];
  EXPECT_EQ(length, count * stride);
  EXPECT_LE(view.value("byteOffset", std::size_t{0}) + length,
            parsed.root["buffers"][1]["byteLength"].get<std::size_t>());
  std::vector<std::byte> bytes(length);
  if (packing["mode"] == "TRIANGLES") {
    EXPECT_EQ(source[0], 0xe1) << "the version that the extension fixes";
    EXPECT_EQ(meshopt_decodeIndexBuffer(bytes.data(), count, stride, source, size), 0);
    return bytes;
  }
  EXPECT_EQ(source[0], 0xa0) << "the version that the extension fixes";
  EXPECT_EQ(meshopt_decodeVertexBuffer(bytes.data(), count, stride, source, size), 0);
  const std::string filter = packing.value("filter", "NONE");
  if (filter == "OCTAHEDRAL") meshopt_decodeFilterOct(bytes.data(), count, stride);
  if (filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes.data(), count, stride);
  return bytes;
}

struct Corner {
  std::array<double, 3> position;
  std::array<double, 3> normal;
  std::array<double, 2> texcoord;
  auto operator<=>(const Corner&) const = default;
};

// The corners of a mesh's triangles, each triangle beginning at its least corner, in order.
std::vector<std::array<Corner, 3>> triangles_of(const Parsed& parsed, std::size_t mesh) {
  const json& primitive = parsed.primitive(mesh);
  const auto part = [&](std::size_t accessor_index, const std::vector<std::byte>& bytes, std::size_t item,
                        std::size_t at) {
    const json& accessor = parsed.root["accessors"][accessor_index];
    const json& view = parsed.root["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const int component = accessor["componentType"];
    const std::size_t size = component == 5120 ? 1 : component == 5123 ? 2 : 4;
    const std::size_t parts = accessor["type"] == "SCALAR" ? 1 : accessor["type"] == "VEC2" ? 2 : 3;
    const std::byte* place = bytes.data() + item * view.value("byteStride", parts * size) + at * size;
    const auto value = [&]<class T>(T number, double divisor) {
      std::memcpy(&number, place, sizeof(T));
      return static_cast<double>(number) / (accessor.value("normalized", false) ? divisor : 1);
    };
    if (component == 5120) return value(std::int8_t(), 127.0);
    if (component == 5123) return value(std::uint16_t(), 65535.0);
    if (component == 5125) return value(std::uint32_t(), 1.0);
    return value(float(), 1.0);
  };
  const auto read = [&](std::size_t accessor) {
    return unpacked(parsed, parsed.root["accessors"][accessor]["bufferView"]);
  };
  const std::size_t indices = primitive["indices"];
  const std::size_t positions = primitive["attributes"]["POSITION"];
  const std::size_t normals = primitive["attributes"]["NORMAL"];
  const std::size_t texcoords = primitive["attributes"]["TEXCOORD_0"];
  const auto index_bytes = read(indices);
  const auto position_bytes = read(positions);
  const auto normal_bytes = read(normals);
  const auto texcoord_bytes = read(texcoords);
  const std::size_t count = parsed.root["accessors"][indices]["count"];
  std::vector<std::array<Corner, 3>> triangles(count / 3);
  for (std::size_t i = 0; i < count; ++i) {
    Corner& corner = triangles[i / 3][i % 3];
    const auto vertex = static_cast<std::size_t>(part(indices, index_bytes, i, 0));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      corner.position[axis] = part(positions, position_bytes, vertex, axis);
      corner.normal[axis] = part(normals, normal_bytes, vertex, axis);
      if (axis < 2) corner.texcoord[axis] = part(texcoords, texcoord_bytes, vertex, axis);
    }
  }
  for (auto& corners : triangles) {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

TEST(GltfMeshopt, WithoutQuantizingUnpacksToTheSameTrianglesBitForBit) {
  const std::string text = scene_text(kTextured, kShapes);
  const Parsed plain = glb(text);
  const Parsed packed = glb(text, {.is_packed = true});
  for (std::size_t mesh = 0; mesh < 2; ++mesh) {
    EXPECT_EQ(triangles_of(plain, mesh), triangles_of(packed, mesh));
  }
  EXPECT_LT(packed.file.files.back().bytes.size(), plain.file.files.back().bytes.size());
}

// Positions are the quantized file's own. (u,v) are whole numbers of 2^-12 and so off by 2^-13. On the
// octahedron x and y are off by 1/254 and z by as much as both; the sphere is up to sqrt(3) as far out; the
// bytes that come out are rounded once more: (2 sqrt(3) + 1) / 254 < 0.0176 a part.
TEST(GltfMeshopt, WithQuantizingPositionsAreExactAndTheRestIsWithinItsBound) {
  const std::string text = scene_text(kTextured, kShapes);
  const Parsed plain = glb(text, {.is_quantized = true, .position_bits = 12});
  const Parsed packed = glb(text, {.is_quantized = true, .position_bits = 12, .is_packed = true});
  const Parsed exact = glb(text);
  EXPECT_EQ(packed.root["nodes"], plain.root["nodes"]);
  const auto positions_of = [](const Parsed& parsed, std::size_t mesh) {
    std::multiset<std::array<std::array<double, 3>, 3>> all;
    for (const auto& corners : triangles_of(parsed, mesh)) {
      std::array<std::array<double, 3>, 3> triangle = {corners[0].position, corners[1].position,
                                                       corners[2].position};
      std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
      all.insert(triangle);
    }
    return all;
  };
  for (std::size_t mesh = 0; mesh < 2; ++mesh) {
    EXPECT_EQ(positions_of(packed, mesh), positions_of(plain, mesh));
    // Vertex by vertex against the floats, by place: the plain file keeps the mesh's order, and so is matched
    // with the floats; each packed corner must be near one at its place.
    std::map<std::array<double, 3>, std::vector<Corner>> by_place;
    for (const auto& corners : triangles_of(plain, mesh)) {
      for (const Corner& corner : corners) by_place[corner.position].push_back(corner);
    }
    for (const auto& corners : triangles_of(packed, mesh)) {
      for (const Corner& corner : corners) {
        double nearest = 1e300;
        for (const Corner& one : by_place[corner.position]) {
          double off = 0;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            // In units of what is allowed: 0.0176 and the plain file's own 1/254.
            off = std::max(off, std::abs(corner.normal[axis] - one.normal[axis]) / (0.0176 + 1.0 / 254));
            if (axis < 2) {
              off = std::max(off, std::abs(corner.texcoord[axis] - one.texcoord[axis]) /
                                      (1.0 / 8192 + 0.5 / 65535 + 1e-7));
            }
          }
          nearest = std::min(nearest, off);
        }
        ASSERT_LE(nearest, 1.0);
      }
    }
  }
}

TEST(GltfMeshopt, LeavesOutTexcoordsAndTangentsThatNoTextureReads) {
  const std::string text = scene_text(kMaterial, kCup);
  for (const bool is_packed : {false, true}) {
    const Parsed parsed = glb(text, {.has_tangents = true, .is_packed = is_packed});
    EXPECT_EQ(parsed.primitive()["attributes"].contains("TEXCOORD_0"), !is_packed);
    EXPECT_EQ(parsed.primitive()["attributes"].contains("TANGENT"), !is_packed);
  }
  EXPECT_TRUE(glb(scene_text(kTextured, kCup), {.bake_size = 8, .is_packed = true})
                  .primitive()["attributes"]
                  .contains("TEXCOORD_0"));
}

TEST(GltfMeshopt, RequiresItsExtensionWhereSomethingIsPackedAndSaysWhatItUnpacksTo) {
  const Parsed parsed = glb(scene_text(kMaterial, kShapes), {.is_quantized = true, .is_packed = true});
  EXPECT_EQ(parsed.root["extensionsRequired"], (json{"KHR_mesh_quantization", "EXT_meshopt_compression"}));
  EXPECT_EQ(parsed.root["extensionsUsed"], (json{"EXT_meshopt_compression", "KHR_mesh_quantization"}));
  ASSERT_EQ(parsed.root["buffers"].size(), 2u);
  EXPECT_FALSE(parsed.root["buffers"][1].contains("uri"));
  EXPECT_EQ(parsed.root["buffers"][1]["extensions"]["EXT_meshopt_compression"], (json{{"fallback", true}}));
  EXPECT_EQ(parsed.root["buffers"][0]["byteLength"], parsed.buffer.size());
  const Parsed small = glb(scene_text(kMaterial, R"({"name": "p", "plane": {"size": [1, 1]}, "tessellation": {
      "contour": 1, "trajectory": 1}})"),
                           {.is_packed = true});
  EXPECT_FALSE(small.root.contains("extensionsUsed")) << "four vertices are smaller as they are";
  EXPECT_EQ(small.root["buffers"].size(), 1u);
}

TEST(GltfMeshopt, IsTheSameEachTimeAndEqualShapesAreOne) {
  const std::string text = scene_text(kMaterial, kTube + R"(, {"name": "second", "material": "m",)" +
                                                     kTube.substr(kTube.find(R"( "tessellation")")));
  const GltfOptions options = {.is_quantized = true, .is_packed = true};
  const Parsed parsed = glb(text, options);
  EXPECT_EQ(parsed.primitive(0), parsed.primitive(1));
  EXPECT_EQ(parsed.file.files.back().bytes, glb(text, options).file.files.back().bytes);
}

// A byte for each triangle, three for the start of each line of cells, and the fixed table at the end.
TEST(StripOrder, TakesOneByteForATriangleOfAGrid) {
  const std::string plane =
      R"({"name": "p", "plane": {"size": [1, 1]}, "tessellation": {"contour": 90, "trajectory": 70}})";
  const Document document = parse_document(scene_text("", plane), "s.json");
  const Model model = build(document, plan(document, {.product = Request::Product::kMeshFile}));
  const MeshView& mesh = model.scene.meshes[0];
  const MeshOrder order = strip_order(mesh);
  const std::size_t bytes = pack_triangles(order.triangles, order.vertices.size()).size();
  EXPECT_LE(bytes, mesh.triangles.size() + 4 * 90 + 17);
  EXPECT_LT(bytes, pack_triangles(mesh.triangles, mesh.positions.size()).size() + 1);
}

// Fourteen narrow patches between a star's corners, walked by rows of eight cells: two bytes for the start of
// a line, and for each patch a first line that numbers two lines of vertices at once, at most four bytes a
// cell.
TEST(StripOrder, TakesTwoBytesMoreForALineOfANarrowPatch) {
  const std::string star =
      R"({"name": "s", "tessellation": {"contour": 112, "trajectory": 96}, "sweep": {"caps": "none",
          "contour": {"star": {"points": 7, "radius": 0.22, "inner_radius": 0.13}},
          "trajectory": {"line": [[0, 0, 0], [0, 7, 0]]}, "twist_deg": 120}})";
  const Document document = parse_document(scene_text("", star), "s.json");
  const Model model = build(document, plan(document, {.product = Request::Product::kMeshFile}));
  const MeshView& mesh = model.scene.meshes[0];
  ASSERT_EQ(mesh.patches.size(), 14u);
  const MeshOrder order = strip_order(mesh);
  EXPECT_LE(pack_triangles(order.triangles, order.vertices.size()).size(),
            mesh.triangles.size() + 2 * 14 * 96 + 4 * 14 * 8 + 17);
}

TEST(StripOrder, HasEveryTriangleOnceWithPolesCapsAndSeveralPatches) {
  for (const std::string& shape : {kCup, kTube, kFloor}) {
    const Document document = parse_document(scene_text(kMaterial, shape), "s.json");
    const Model model = build(document, plan(document, {.product = Request::Product::kMeshFile}));
    const MeshView& mesh = model.scene.meshes[0];
    const MeshOrder order = strip_order(mesh);
    const auto least_first = [](sweep::Triangle triangle) {
      std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
      return triangle;
    };
    std::multiset<sweep::Triangle> was;
    for (const sweep::Triangle& triangle : mesh.triangles) was.insert(least_first(triangle));
    std::multiset<sweep::Triangle> is;
    for (sweep::Triangle triangle : order.triangles) {
      for (std::uint32_t& vertex : triangle) vertex = order.vertices.at(vertex);
      is.insert(least_first(triangle));
    }
    EXPECT_EQ(is, was);
    EXPECT_EQ(std::set(order.vertices.begin(), order.vertices.end()).size(), order.vertices.size());
  }
}

TEST(Exponential, HoldsWhatTwentyFourBitsReach) {
  const std::vector<glm::vec2> values = {{0.0f, -2047.0f}, {1.0f / 3, 100.7f}};
  auto words = to_exponential(values);
  ASSERT_TRUE(words);
  meshopt_decodeFilterExp(words->data(), words->size(), 8);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::array<float, 2> out = {};
    std::memcpy(out.data(), (*words)[i].data(), 8);
    EXPECT_NEAR(out[0], values[i].x, 1.0 / 8192);
    EXPECT_NEAR(out[1], values[i].y, 1.0 / 8192);
  }
  EXPECT_FALSE(to_exponential(std::vector<glm::vec2>{{2049.0f, 0.0f}}));
}

TEST(GltfMinimal, HasNoNamesNoCameraNoExtrasAndNoTexcoordsWithoutTexture) {
  const std::string text =
      scene_text(R"("textures": {"t": {"procedural": "checker"}}, "materials": {"m": {"texture": "t"}})",
                 kCup + R"(, {"name": "bare", "plane": {"size": [1, 1]}})");
  const Parsed parsed = glb(text, {.bake_size = 8, .has_tangents = true, .is_minimal = true, .scene = "{}"});
  EXPECT_TRUE(parsed.primitive(0)["attributes"].contains("TEXCOORD_0"));
  EXPECT_TRUE(parsed.primitive(0)["attributes"].contains("TANGENT"));
  EXPECT_FALSE(parsed.primitive(1)["attributes"].contains("TEXCOORD_0"));
  EXPECT_FALSE(parsed.primitive(1)["attributes"].contains("TANGENT"));
  EXPECT_FALSE(parsed.root.contains("cameras"));
  EXPECT_FALSE(parsed.root.contains("extras"));
  EXPECT_EQ(parsed.root.dump().find("\"name\""), std::string::npos);
  EXPECT_EQ(parsed.root["scenes"][0]["nodes"], (json{0, 1}));
}

TEST(GltfMinimal, HasNoNamesWhereItMovesEither) {
  const json root = glb(scene_text(R"("materials": {"m": {}})", kCup),
                        {.turntable_seconds = 2, .grow_seconds = 3, .is_minimal = true})
                        .root;
  EXPECT_EQ(root["animations"].size(), 2u);
  EXPECT_EQ(root.dump().find("\"name\""), std::string::npos);
}

}  // namespace
}  // namespace sweepkit::scene
