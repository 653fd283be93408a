// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Quantized files are unpacked by hand, as a viewer does, and laid beside the meshes that they were made
// from.

#include "gltf_quantize.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <set>

#include "gltf_transform.hpp"
#include "parsed_gltf.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

const std::string kMaterial = R"("materials": {"m": {}})";
const std::string kRing =
    R"({"name": "ring", "material": "m", "tessellation": {"contour": 20, "trajectory": 40},
        "sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"circle": {"radius": 0.5}}}})";

// The items of an accessor in double, normalized ones as glTF says.
template <class T>
std::vector<glm::dvec4> items(const Parsed& parsed, std::size_t index, double divisor) {
  const json& accessor = parsed.root["accessors"][index];
  const json& view = parsed.root["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  const std::size_t parts = accessor["type"] == "VEC2" ? 2 : accessor["type"] == "VEC3" ? 3 : 4;
  const std::size_t stride = view.value("byteStride", parts * sizeof(T));
  EXPECT_EQ(stride % 4, 0u);
  std::vector<glm::dvec4> values(accessor["count"].get<std::size_t>(), glm::dvec4(0.0));
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::array<T, 4> item = {};
    std::memcpy(item.data(), parsed.view(accessor["bufferView"]) + i * stride, parts * sizeof(T));
    for (std::size_t part = 0; part < parts; ++part) {
      values[i][static_cast<int>(part)] = static_cast<double>(item[part]) / divisor;
    }
  }
  return values;
}

glm::dmat4 matrix_of(const json& node) {
  glm::dmat4 matrix(1.0);
  const auto vector = [&](const char* key) {
    return glm::dvec3(node[key][0].get<double>(), node[key][1].get<double>(), node[key][2].get<double>());
  };
  const glm::dquat turn = node.contains("rotation") ? glm::dquat(node["rotation"][3], node["rotation"][0],
                                                                 node["rotation"][1], node["rotation"][2])
                                                    : glm::dquat(1, 0, 0, 0);
  glm::dmat3 axes = glm::mat3_cast(turn);
  if (node.contains("scale")) {
    for (int i = 0; i < 3; ++i) axes[i] *= vector("scale")[i];
  }
  matrix = glm::dmat4(axes);
  if (node.contains("translation")) matrix[3] = glm::dvec4(vector("translation"), 1);
  return matrix;
}

class Quantized {
 public:
  explicit Quantized(const std::string& text, int bits = 16)
      : document_(parse_document(text, SWEEPKIT_SAMPLES "/scenes/s.json")),
        model(build(document_, plan(document_, {.product = Request::Product::kMeshFile}))),
        parsed(glb(text, {.bake_size = 32, .is_quantized = true, .position_bits = bits})) {}

  std::size_t attribute(const char* name, std::size_t mesh = 0) const {
    return parsed.primitive(mesh)["attributes"][name];
  }
  double half_step(std::size_t mesh, int bits = 16) const {
    glm::dvec3 low(1e300);
    glm::dvec3 high(-1e300);
    for (const glm::vec3& position : model.scene.meshes[mesh].positions) {
      low = glm::min(low, glm::dvec3(position));
      high = glm::max(high, glm::dvec3(position));
    }
    const glm::dvec3 sides = high - low;
    return std::max({sides.x, sides.y, sides.z}) / ((1 << bits) - 1) / 2;
  }

 private:
  Document document_;

 public:
  Model model;
  Parsed parsed;
};

TEST(GltfQuantize, RequiresItsExtension) {
  const Quantized made(scene_text(kMaterial, kVase));
  EXPECT_EQ(made.parsed.root["extensionsRequired"], json{"KHR_mesh_quantization"});
  EXPECT_EQ(made.parsed.root["extensionsUsed"], json{"KHR_mesh_quantization"});
  EXPECT_FALSE(glb(scene_text(kMaterial, kVase)).root.contains("extensionsRequired"));
}

// The node is made from double and the accessor's whole numbers are exact: what is over half a step is the
// rounding of a few products, under 1e-9 of the step.
TEST(GltfQuantize, PositionsAreOffByHalfAStepAtMost) {
  for (const int bits : {8, 14, 16}) {
    const Quantized made(scene_text(kMaterial, kRing), bits);
    const MeshView& mesh = made.model.scene.meshes[0];
    const glm::dmat4 world_from_mesh = matrix_of(made.parsed.root["nodes"][0]);
    const auto positions = items<std::uint16_t>(made.parsed, made.attribute("POSITION"), 1);
    ASSERT_EQ(positions.size(), mesh.positions.size());
    double worst = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const glm::dvec3 is(world_from_mesh * glm::dvec4(glm::dvec3(positions[i]), 1));
      const glm::dvec3 off = glm::abs(is - (glm::dvec3(mesh.positions[i]) + mesh.origin));
      worst = std::max({worst, off.x, off.y, off.z});
    }
    const double bound = made.half_step(0, bits);
    EXPECT_LE(worst, bound * (1 + 1e-9)) << bits;
    EXPECT_GE(worst, bound * 0.5) << "the bound is no empty one";
    const json& accessor = made.parsed.root["accessors"][made.attribute("POSITION")];
    EXPECT_EQ(accessor["min"], (json{0, 0, 0}));
    EXPECT_EQ(accessor["max"][0], (1 << bits) - 1);
    EXPECT_EQ(accessor["componentType"], 5123);
    EXPECT_FALSE(accessor.value("normalized", false));
  }
}

// Half a step is 1 / 254 in each part; the angle of three such errors is at most asin(sqrt(3) / 254 / 0.99).
TEST(GltfQuantize, NormalsAndTangentsAreOffByHalfOf127th) {
  const std::string text = scene_text(kMaterial, kRing);
  const Quantized made(text);
  const MeshView& mesh = made.model.scene.meshes[0];
  const auto normals = items<std::int8_t>(made.parsed, made.attribute("NORMAL"), 127);
  ASSERT_EQ(normals.size(), mesh.normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(normals[i][axis], mesh.normals[i][axis], 1.0 / 254 + 1e-7);
  }
  EXPECT_EQ(made.parsed.root["accessors"][made.attribute("NORMAL")]["normalized"], true);

  const Parsed plain = glb(text, {.has_tangents = true});
  const Parsed quantized = glb(text, {.has_tangents = true, .is_quantized = true});
  const auto are = items<float>(plain, plain.primitive()["attributes"]["TANGENT"], 1);
  const auto were = items<std::int8_t>(quantized, quantized.primitive()["attributes"]["TANGENT"], 127);
  ASSERT_EQ(are.size(), were.size());
  for (std::size_t i = 0; i < are.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(are[i][axis], were[i][axis], 1.0 / 254 + 1e-7);
    EXPECT_EQ(are[i].w, were[i].w) << "handedness is whole";
  }
}

TEST(GltfQuantize, TexcoordsAreShortWhereTheyDoNotRepeatAndFloatsWhereTheyDo) {
  const Quantized made(scene_text(kMaterial, kRing));
  const MeshView& mesh = made.model.scene.meshes[0];
  const auto texcoords = items<std::uint16_t>(made.parsed, made.attribute("TEXCOORD_0"), 65535);
  for (std::size_t i = 0; i < texcoords.size(); ++i) {
    EXPECT_NEAR(texcoords[i].x, mesh.texcoords[i].x, 0.5 / 65535 + 1e-7);
    EXPECT_NEAR(texcoords[i].y, 1 - mesh.texcoords[i].y, 0.5 / 65535 + 1e-7);
  }
  std::string repeated = kRing;
  repeated.insert(repeated.size() - 1, R"(, "uv": {"repeat": [3, 1]})");
  const Quantized more(scene_text(kMaterial, repeated));
  const json& accessor = more.parsed.root["accessors"][more.attribute("TEXCOORD_0")];
  EXPECT_EQ(accessor["componentType"], 5126);
  const auto floats = items<float>(more.parsed, more.attribute("TEXCOORD_0"), 1);
  for (std::size_t i = 0; i < floats.size(); ++i)
    EXPECT_EQ(floats[i].x, more.model.scene.meshes[0].texcoords[i].x);
}

// Each edge is gone along as often one way as the other, vertices in one place being one.
bool is_closed(std::span<const sweep::Triangle> triangles, std::span<const ShortPosition> positions) {
  std::map<std::pair<ShortPosition, ShortPosition>, int> edges;
  for (const sweep::Triangle& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const ShortPosition& from = positions[triangle[i]];
      const ShortPosition& to = positions[triangle[(i + 1) % 3]];
      if (from == to) continue;
      from < to ? ++edges[{from, to}] : --edges[{to, from}];
    }
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

// At 8 bits cells of a 300 x 300 ball are smaller than a step: many triangles become edges and points.
TEST(GltfQuantize, ClosedMeshesStayClosedWhereTrianglesCollapse) {
  const std::string ball =
      R"({"name": "ball", "tessellation": {"contour": 300, "trajectory": 300},
          "revolve": {"contour": {"arc": {"radius": 1, "from_deg": -90, "to_deg": 90}}}})";
  const Document document = parse_document(scene_text("", ball), "s.json");
  const Model model = build(document, plan(document, {.product = Request::Product::kMeshFile}));
  const MeshView& mesh = model.scene.meshes[0];
  for (const int bits : {8, 16}) {
    const auto positions = to_grid(mesh.positions, position_grid(mesh.positions, bits));
    ASSERT_TRUE(is_closed(mesh.triangles, positions));
    const std::vector<sweep::Triangle> kept = with_area(mesh.triangles, positions);
    EXPECT_TRUE(is_closed(kept, positions)) << bits;
    if (bits == 8) {
      EXPECT_LT(kept.size(), mesh.triangles.size());
    }
    const GltfFile file = make(model, document, "b.glb", {.is_quantized = true, .position_bits = bits});
    EXPECT_EQ(file.triangles_without_area, mesh.triangles.size() - kept.size());
  }
}

TEST(GltfQuantize, PositionsOfTheSameBitsStayTheSame) {
  const Quantized made(scene_text(kMaterial, kRing));
  const MeshView& mesh = made.model.scene.meshes[0];
  const auto places = to_grid(mesh.positions, position_grid(mesh.positions, 16));
  std::map<std::array<float, 3>, std::set<ShortPosition>> by_place;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::vec3& at = mesh.positions[i];
    by_place[{at.x, at.y, at.z}].insert(places[i]);
  }
  EXPECT_LT(by_place.size(), places.size()) << "seams are there to be looked at";
  for (const auto& [at, ones] : by_place) EXPECT_EQ(ones.size(), 1u);
}

TEST(GltfQuantize, InstancesShareTheMeshAndAreScaledUnevenlyWithoutShear) {
  std::string many = kRing;
  many.insert(
      many.size() - 1,
      R"(, "scale": 2, "rotate_deg": [10, 20, 30], "instances": [{"translate": [5, 0, 0], "rotate_deg": [0, 40, 0]},
                  {"scale": 3, "translate": [0, 7, 0]}])");
  const Quantized made(scene_text(kMaterial, many + R"(, {"name": "flat", "material": "m", "scale": [1, 2, 3],
      "rotate_deg": [5, 6, 7], "sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"circle": {"radius": 0.5}}}})"));
  const Scene& scene = made.model.scene;
  ASSERT_EQ(scene.objects.size(), 3u);
  EXPECT_EQ(made.parsed.root["meshes"].size(), 2u);
  const std::array<std::size_t, 3> nodes = {1, 2, 3};
  for (std::size_t i = 0; i < 3; ++i) {
    const json& node = made.parsed.root["nodes"][nodes[i]];
    const std::size_t entry = node["mesh"];
    const Object& object = scene.objects[i];
    const MeshView& mesh = scene.meshes[object.mesh];
    const auto positions = items<std::uint16_t>(made.parsed, made.attribute("POSITION", entry), 1);
    const glm::dmat4 is_at = matrix_of(node);
    double stretch = 0;
    for (int axis = 0; axis < 3; ++axis)
      stretch = std::max(stretch, glm::length(glm::dvec3(object.world_from_object[axis])));
    for (std::size_t vertex = 0; vertex < positions.size(); ++vertex) {
      const glm::dvec3 is(is_at * glm::dvec4(glm::dvec3(positions[vertex]), 1));
      const glm::dvec3 was(object.world_from_object *
                           glm::dvec4(glm::dvec3(mesh.positions[vertex]) + mesh.origin, 1));
      // Half a step in each of three axes, stretched; the sum of products rounds by far less than 1e-12.
      EXPECT_LE(glm::length(is - was), std::sqrt(3.0) * stretch * made.half_step(object.mesh) + 1e-12);
    }
  }
}

// A viewer scales thicknessFactor by the node, and so by the step.
TEST(GltfQuantize, GlassIsAsThickAsWithout) {
  const std::string text =
      scene_text(R"("materials": {"m": {"transmit": 0.9, "ior": 1.5, "absorption": [1, 2, 3]}})", kRing);
  const json plain = glb(text).root;
  const json quantized = glb(text, {.is_quantized = true}).root;
  const auto volume = [](const json& root) {
    return root["materials"][0]["extensions"]["KHR_materials_volume"];
  };
  const double step = quantized["nodes"][0]["scale"][0];
  EXPECT_LT(step, 1e-4);
  const double thickness = volume(plain)["thicknessFactor"];
  EXPECT_NEAR(volume(quantized)["thicknessFactor"].get<double>() * step, thickness, 1e-6 * thickness);
  EXPECT_EQ(volume(quantized)["attenuationDistance"], volume(plain)["attenuationDistance"]);
  const auto blended = [&](bool is_quantized) {
    return glb(text, {.look = GltfLook::kUnlit, .is_quantized = is_quantized}).root["materials"][0];
  };
  EXPECT_NEAR(blended(true)["pbrMetallicRoughness"]["baseColorFactor"][3].get<double>(),
              blended(false)["pbrMetallicRoughness"]["baseColorFactor"][3].get<double>(), 1e-6);
}

TEST(GltfQuantize, EqualShapesOfUnlikeSizeShareTheirArrays) {
  const auto ball = [](const std::string& name, const std::string& radius) {
    return R"({"name": ")" + name + R"(", "revolve": {"contour": {"arc": {"radius": )" + radius +
           R"(, "from_deg": -90, "to_deg": 90}}}})";
  };
  const Quantized made(scene_text("", ball("small", "1") + ", " + ball("large", "4")));
  EXPECT_EQ(made.parsed.primitive(0)["attributes"], made.parsed.primitive(1)["attributes"]);
  EXPECT_NEAR(made.parsed.root["nodes"][1]["scale"][0].get<double>(),
              4 * made.parsed.root["nodes"][0]["scale"][0].get<double>(), 1e-12);
}

TEST(GltfQuantize, WhatIsOnePointAndWhatIsTooThinIsRefused) {
  EXPECT_EQ(position_grid(std::vector<glm::vec3>(3, glm::vec3(2.0f)), 16).step, 1);
  const std::string wire =
      R"({"name": "wire", "tessellation": {"contour": 4, "trajectory": 2}, "sweep": {
          "contour": {"circle": {"radius": 1e-6}}, "trajectory": {"line": [[0, 0, 0], [0, 1, 0]]}}})";
  try {
    make(scene_text("", wire), "a.glb", {.is_quantized = true});
    FAIL() << "should be refused";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(), "the object \"wire\" is too thin to be quantized: no triangle keeps its area");
  }
}

}  // namespace
}  // namespace sweepkit::scene
