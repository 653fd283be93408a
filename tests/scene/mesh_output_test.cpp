// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// What is written is read back by the project's own readers and by OpenMesh, and held against the scene's
// meshes placed here once more, triangle by triangle.

#include "sweepkit/scene/mesh_output.hpp"

#include <gtest/gtest.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <cmath>
#include <cstring>
#include <set>
#include <sstream>

#include "outline_measures.hpp"
#include "scene_text.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/mesh_file.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/texmap/image_file.hpp"

namespace sweepkit::scene {
namespace {

constexpr const char* kFormats[] = {"m.obj", "m.ply", "m.stl", "m.off"};

struct Made {
  Document document;
  Model model;
  MeshOutput output;

  std::string_view bytes(std::size_t from_the_end = 0) const {
    const std::vector<std::byte>& data = output.files[output.files.size() - 1 - from_the_end].bytes;
    return {reinterpret_cast<const char*>(data.data()), data.size()};
  }
};

Made make(const std::string& text, const std::string& file) {
  Document document = parse_document(text, SWEEPKIT_SAMPLES "/scenes/s.json");
  const Plan plan = scene::plan(document, {.product = Request::Product::kMeshFile,
                                           .has_textures = holds_textures(file),
                                           .has_texcoords = holds_texcoords(file)});
  Model model = build(document, plan);
  MeshOutput output = make_mesh_output(model.scene, plan, file, {.bake_size = 32});
  return {std::move(document), std::move(model), std::move(output)};
}

std::string fault_of_making(const std::string& text, const std::string& file) {
  try {
    make(text, file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// Poles, caps, a closed surface, several parts, placements that turn, stretch and mirror, instances, one of
// which shears.
const std::string kRich = scene_text(
    R"("textures": {"tiles": {"procedural": "tiles", "scale": 4}, "stone": {"procedural": "marble"},
        "image": {"image": "../textures/floor_tiles.png"}},
       "materials": {"tiled": {"texture": "tiles"}, "marble": {"texture": "stone"}, "painted": {"texture": "image"}})",
    R"({"name": "vase", "material": "marble", "rotate_deg": [10, 20, 30], "scale": [1, 2, -0.5],
        "tessellation": {"contour": 8, "trajectory": 9}, "revolve": {"contour": {"bezier": [[0, -1], [1.3, -1], [1.3, 1], [0, 1]]}}},
       {"name": "rod", "material": "tiled", "translate": [3, 0, 1], "tessellation": {"contour": 7, "trajectory": 2},
        "instances": [{}, {"translate": [1, 0, 0], "scale": -1}, {"rotate_deg": [0, 45, 0], "scale": [2, 1, 1]}],
        "sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"line": [[0, 0, 0], [1, 1, 0]]}}},
       {"name": "pair", "material": "painted", "parts": [{"plane": {"size": [1, 2]}},
        {"translate": [0, 2, 0], "tessellation": {"contour": 6, "trajectory": 8},
         "sweep": {"contour": {"circle": {"radius": 0.2}}, "trajectory": {"circle": {"radius": 1}}}}]})");

struct Corner {
  glm::dvec3 position;
  glm::vec3 normal;
  glm::vec2 uv;
};

// The scene's triangles in the world, by a way of its own: normals from two tangents carried along.
std::vector<std::array<Corner, 3>> placed(const Scene& scene) {
  std::vector<std::array<Corner, 3>> all;
  for (const Object& object : scene.objects) {
    const MeshView& mesh = scene.meshes[object.mesh];
    const glm::dmat3 linear(object.world_from_object);
    for (const sweep::Triangle& t : mesh.triangles) {
      std::array<Corner, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 n(mesh.normals[t[k]]);
        const glm::dvec3 across =
            glm::cross(n, std::abs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
        glm::dvec3 turned = glm::cross(linear * across, linear * glm::cross(n, across));
        if (glm::determinant(linear) < 0) turned = -turned;
        corners[k] = {linear * (mesh.origin + glm::dvec3(mesh.positions[t[k]])) +
                          glm::dvec3(object.world_from_object[3]),
                      glm::vec3(glm::normalize(turned)), mesh.texcoords[t[k]]};
      }
      if (glm::determinant(linear) < 0) std::swap(corners[0], corners[2]);
      all.push_back(corners);
    }
  }
  return all;
}

// A number's text reads back the same: as a float where it is one, else as a double.
bool is_same_text(const glm::dvec3& read, const glm::dvec3& wanted) {
  for (glm::length_t k = 0; k < 3; ++k) {
    const bool is_float = static_cast<double>(static_cast<float>(wanted[k])) == wanted[k];
    const bool is_same_float = static_cast<float>(read[k]) == static_cast<float>(wanted[k]);
    if (read[k] != wanted[k] && !(is_float && is_same_float)) return false;
  }
  return true;
}

TEST(MeshOutput, EveryFormatReadsBackEqualByOurOwnReaders) {
  for (const std::string file : kFormats) {
    const Made made = make(kRich, file);
    const std::vector<std::array<Corner, 3>> expected = placed(made.model.scene);
    const MeshFile read = parse_mesh_file(made.bytes(), file);
    ASSERT_EQ(read.triangles.size(), expected.size()) << file;
    EXPECT_EQ(made.output.triangles, expected.size());
    EXPECT_EQ(read.degenerate, 0u);
    const bool is_text = file == "m.obj" || file == "m.off";
    for (std::size_t t = 0; t < expected.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner& corner = expected[t][k];
        const glm::dvec3 given = read.positions[read.triangles[t][k]];
        ASSERT_TRUE(is_text ? is_same_text(given, corner.position)
                            : given == glm::dvec3(glm::vec3(corner.position)))
            << file << " triangle " << t;
        if (file == "m.ply" || file == "m.obj") {
          // Both ways round in double and end in float32: a unit in the last place of 1, and that of the sum.
          ASSERT_LT(glm::distance(read.normals[t][k], corner.normal), 2e-7f) << file << " triangle " << t;
        }
        if (file == "m.ply") {
          ASSERT_EQ(read.texcoords[t][k], corner.uv);
        }
      }
    }
  }
}

TEST(MeshOutput, ObjHasTheTexcoordsOfItsImages) {
  const Made made = make(kRich, "m.obj");
  const MeshFile read = parse_mesh_file(made.bytes(), "m.obj");
  const std::vector<std::array<Corner, 3>> expected = placed(made.model.scene);
  const std::size_t vase = made.model.scene.meshes[0].triangles.size();
  for (std::size_t t = 0; t < expected.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (t >= vase) {
        ASSERT_EQ(read.texcoords[t][k], expected[t][k].uv) << "as the mesh has them";
      } else {
        // Marble lies on position: its image is the vase's own, which it fills but for the gutter.
        ASSERT_GE(std::min(read.texcoords[t][k].x, read.texcoords[t][k].y), 0.0f);
        ASSERT_LE(std::max(read.texcoords[t][k].x, read.texcoords[t][k].y), 1.0f);
      }
    }
  }
  EXPECT_EQ(made.output.ledger[Part::kBakes].calls, 2u) << "the tiles' square and the vase's marble";
}

TEST(MeshOutput, EveryFormatReadsBackEqualByOpenMesh) {
  const Folder folder;
  omlog().disable();
  for (const std::string file : kFormats) {
    const Made made = make(kRich, file);
    for (const NamedBytes& part : made.output.files) {
      folder.write(part.name, {reinterpret_cast<const char*>(part.bytes.data()), part.bytes.size()});
    }
    OpenMesh::TriMesh_ArrayKernelT<> theirs;
    ASSERT_TRUE(OpenMesh::IO::read_mesh(theirs, (folder.path() / file).string())) << file;
    const std::vector<std::array<Corner, 3>> expected = placed(made.model.scene);
    ASSERT_EQ(theirs.n_faces(), expected.size()) << file;
    for (const auto face : theirs.faces()) {
      std::size_t k = 0;
      for (const auto vertex : theirs.fv_range(face)) {
        const glm::vec3 wanted(expected[static_cast<std::size_t>(face.idx())][k++].position);
        const auto& p = theirs.point(vertex);
        // OpenMesh reads text as float itself: the double's digits are rounded once.
        EXPECT_EQ(glm::vec3(p[0], p[1], p[2]), wanted) << file;
      }
    }
  }
}

TEST(MeshOutput, AClosedSurfaceStaysClosedWherePositionsStandOnce) {
  const Folder folder;
  omlog().disable();
  const std::string torus = scene_text("", R"({"name": "t", "tessellation": {"contour": 12, "trajectory": 16},
              "sweep": {"contour": {"circle": {"radius": 0.2}}, "trajectory": {"circle": {"radius": 1}}}})");
  for (const std::string file : {"m.obj", "m.off"}) {
    const Made made = make(torus, file);
    folder.write(file, std::string(made.bytes()));
    OpenMesh::TriMesh_ArrayKernelT<> mesh;
    ASSERT_TRUE(OpenMesh::IO::read_mesh(mesh, (folder.path() / file).string()));
    std::size_t open = 0;
    for (const auto edge : mesh.edges()) open += mesh.is_boundary(edge) ? 1 : 0;
    EXPECT_EQ(open, 0u) << file;
    EXPECT_EQ(mesh.n_vertices() + mesh.n_faces(), mesh.n_edges()) << "Euler's number of a torus is 0";
  }
}

TEST(MeshOutput, TheSameSceneGivesTheSameBytes) {
  for (const std::string file : kFormats) {
    const Made first = make(kRich, file);
    const Made second = make(kRich, file);
    ASSERT_EQ(first.output.files.size(), second.output.files.size());
    for (std::size_t i = 0; i < first.output.files.size(); ++i) {
      EXPECT_EQ(first.output.files[i].name, second.output.files[i].name);
      EXPECT_EQ(first.output.files[i].bytes, second.output.files[i].bytes) << first.output.files[i].name;
    }
  }
}

std::vector<std::string> lines_with(std::string_view text, const std::string& key) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(key + " ")) lines.push_back(line.substr(key.size() + 1));
  }
  return lines;
}

TEST(MeshOutput, ObjNamesEachObjectAndInstanceByAWordOfItsOwn) {
  const Made made = make(
      scene_text(
          R"("materials": {"a b": {}, "a_b": {}})",
          R"({"name": "my vase", "material": "a b", "plane": {"size": [1, 1]}, "instances": [{}, {"translate": [2, 0, 0]}]},
                    {"name": "my_vase", "material": "a_b", "plane": {"size": [1, 1]}},
                    {"name": "Gefäß\n1", "plane": {"size": [1, 1]}})"),
      "an out.obj");
  EXPECT_EQ(lines_with(made.bytes(), "o"),
            (std::vector<std::string>{"my_vase", "my_vase_2", "my_vase_3", "Gefäß_1"}));
  EXPECT_EQ(lines_with(made.bytes(), "usemtl"), (std::vector<std::string>{"a_b", "a_b", "a_b_2", "default"}));
  EXPECT_EQ(lines_with(made.bytes(), "mtllib"), std::vector<std::string>{"an_out.mtl"});
  EXPECT_EQ(lines_with(made.bytes(1), "newmtl"), (std::vector<std::string>{"a_b", "a_b_2", "default"}));
  ASSERT_EQ(made.output.files.size(), 2u);
  EXPECT_EQ(made.output.files[0].name, "an_out.mtl");
  EXPECT_EQ(made.output.files[1].name, "an out.obj");
}

TEST(MeshOutput, MaterialsGoOverAsTheFormatHasThem) {
  const Made made = make(
      scene_text(
          R"("materials": {"plain": {"diffuse": [0.5, 0.25, 1]},
          "shiny": {"specular": [0.1, 0.2, 0.3], "shininess": 5000}, "mirror": {"reflect": 0.5, "specular": [0.6, 0, 0]},
          "glass": {"diffuse": [0, 0, 0], "reflect": 1, "transmit": 0.75, "ior": 1.5, "fresnel": "exact"}})",
          R"({"name": "1", "material": "plain", "plane": {"size": [1, 1]}}, {"name": "2", "material": "shiny", "plane": {"size": [1, 1]}},
                    {"name": "3", "material": "mirror", "plane": {"size": [1, 1]}}, {"name": "4", "material": "glass", "plane": {"size": [1, 1]}})"),
      "m.obj");
  const std::string_view library = made.bytes(1);
  EXPECT_EQ(lines_with(library, "Kd"),
            (std::vector<std::string>{"0.5 0.25 1", "0.8 0.8 0.8", "0.8 0.8 0.8", "0 0 0"}));
  EXPECT_EQ(lines_with(library, "Ks"),
            (std::vector<std::string>{"0 0 0", "0.1 0.2 0.3", "0.6 0.5 0.5", "1 1 1"}));
  EXPECT_EQ(lines_with(library, "Ns"), (std::vector<std::string>{"50", "1000", "50", "50"}));
  EXPECT_EQ(lines_with(library, "Ni"), (std::vector<std::string>{"1", "1", "1", "1.5"}));
  EXPECT_EQ(lines_with(library, "d"), (std::vector<std::string>{"1", "1", "1", "0.25"}));
  EXPECT_EQ(lines_with(library, "Tf"), std::vector<std::string>{"0.75 0.75 0.75"});
  EXPECT_EQ(lines_with(library, "illum"), (std::vector<std::string>{"1", "2", "3", "7"}));
  EXPECT_EQ(lines_with(library, "map_Kd"), std::vector<std::string>{});
}

TEST(MeshOutput, WithoutMaterialsThereIsNoLibrary) {
  const Made made = make(scene_text(""), "m.obj");
  EXPECT_EQ(made.output.files.size(), 1u);
  EXPECT_TRUE(lines_with(made.bytes(), "usemtl").empty());
  EXPECT_TRUE(lines_with(made.bytes(), "mtllib").empty());
}

TEST(MeshOutput, AnImageIsWrittenOnceAndAMirroredOneAsTheFourThatRepeat) {
  const std::string image = R"({"image": "../textures/floor_tiles.png")";
  const Made made = make(
      scene_text(
          R"("textures": {"r": )" + image + R"(}, "c": )" + image + R"(, "wrap": "clamp"}, "m": )" + image +
              R"(, "wrap": "mirror"}}, "materials": {"r": {"texture": "r"}, "r2": {"texture": "r"}, "c": {"texture": "c"}, "m": {"texture": "m"}})",
          R"({"name": "1", "material": "r", "plane": {"size": [1, 1]}}, {"name": "2", "material": "r2", "plane": {"size": [1, 1]}},
                    {"name": "3", "material": "c", "plane": {"size": [1, 1]}},
                    {"name": "4", "material": "m", "plane": {"size": [1, 1]}, "uv": {"repeat": [4, 2]}})"),
      "m.obj");
  EXPECT_EQ(lines_with(made.bytes(1), "map_Kd"),
            (std::vector<std::string>{"m_0.png", "m_0.png", "-clamp on m_1.png", "m_2.png"}));
  ASSERT_EQ(made.output.files.size(), 5u);
  const MeshFile read = parse_mesh_file(made.bytes(), "m.obj");
  glm::vec2 largest(0.0f);
  for (std::size_t t = 6; t < 8; ++t) {
    for (const glm::vec2& uv : read.texcoords[t]) largest = glm::max(largest, uv);
  }
  EXPECT_EQ(largest, glm::vec2(2, 1)) << "of a repeat of 4 and 2";

  // Under repeat at half the (u,v) it shows what the image itself shows mirrored, texel for texel.
  const Folder folder;
  const auto& png = made.output.files[2].bytes;
  folder.write("four.png", {reinterpret_cast<const char*>(png.data()), png.size()});
  const auto own = std::make_shared<const texmap::Image>(
      texmap::read_image(SWEEPKIT_SAMPLES "/textures/floor_tiles.png", texmap::ColorSpace::kSrgb));
  const auto four = std::make_shared<const texmap::Image>(
      texmap::read_image(folder.path() / "four.png", texmap::ColorSpace::kSrgb));
  ASSERT_EQ(four->width, 2 * own->width);
  for (int y = -own->height; y < 2 * own->height; y += 3) {
    for (int x = -own->width; x < 2 * own->width; x += 3) {
      const glm::dvec2 uv((x + 0.5) / own->width, (y + 0.5) / own->height);
      ASSERT_EQ(texmap::point_sample(texmap::ImageTexture{four, texmap::Wrap::kRepeat}, 0.5 * uv, {}),
                texmap::point_sample(texmap::ImageTexture{own, texmap::Wrap::kMirror}, uv, {}))
          << x << " " << y;
    }
  }
}

TEST(MeshOutput, FarFromTheOriginTextAndPlyKeepTheSurface) {
  const std::string far = scene_text(
      "", R"({"name": "f", "translate": [1e7, 0, 0], "tessellation": {"contour": 8, "trajectory": 8},
              "sweep": {"contour": {"circle": {"radius": 0.01}}, "trajectory": {"circle": {"radius": 0.1}}}})");
  for (const std::string file : {"m.obj", "m.off", "m.ply"}) {
    const Made made = make(far, file);
    const std::vector<std::array<Corner, 3>> expected = placed(made.model.scene);
    const MeshFile read = parse_mesh_file(made.bytes(), file);
    ASSERT_EQ(read.triangles.size(), expected.size());
    for (std::size_t t = 0; t < expected.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_TRUE(is_same_text(read.positions[read.triangles[t][k]], expected[t][k].position)) << file;
      }
    }
  }
}

TEST(MeshOutput, FacetsOfStlFaceOutwardsAlsoWhereTheObjectIsMirrored) {
  for (const std::string scale : {"1", "-1", "[1, -2, 1]"}) {
    const Made made = make(
        scene_text(
            "",
            R"({"name": "b", "scale": )" + scale +
                R"(, "tessellation": {"contour": 8, "trajectory": 12}, "revolve": {"contour": {"bezier": [[0, -1], [1.3, -1], [1.3, 1], [0, 1]]}}})"),
        "m.stl");
    const std::string_view bytes = made.bytes();
    EXPECT_NE(bytes.substr(0, 5), "solid");
    ASSERT_EQ(bytes.size(), 84 + 50 * made.output.triangles);
    double volume = 0;
    for (std::size_t t = 0; t < made.output.triangles; ++t) {
      std::array<glm::vec3, 4> v;  // the normal, then the corners
      std::memcpy(v.data(), bytes.data() + 84 + 50 * t, 48);
      EXPECT_GT(glm::dot(v[0], v[1] + v[2] + v[3]), 0) << "convex about 0";
      EXPECT_NEAR(static_cast<double>(glm::length(v[0])), 1, 1e-6);
      volume += glm::dot(glm::dvec3(v[1]), glm::cross(glm::dvec3(v[2]), glm::dvec3(v[3]))) / 6;
    }
    EXPECT_GT(volume, 0) << "counter-clockwise seen from outside";
  }
}

TEST(MeshOutput, WhatTheFormatCannotHoldIsLeftOut) {
  for (const std::string file : {"m.ply", "m.stl", "m.off"}) {
    const Made made = make(kRich, file);
    EXPECT_EQ(made.output.files.size(), 1u) << file;
    EXPECT_EQ(made.model.ledger[Part::kTextures].calls, 0u) << file;
    EXPECT_EQ(made.output.ledger[Part::kBakes].calls, 0u) << file;
  }
  EXPECT_GT(make(kRich, "m.obj").model.ledger[Part::kTextures].calls, 0u);
}

TEST(MeshOutput, RefusesAnotherNameMoreThan32BitsCountAndAnObjectWithoutTriangles) {
  EXPECT_NE(
      fault_of_making(scene_text(""), "m.fbx").find("its name needs to end in .obj, .ply, .stl or .off"),
      std::string::npos);

  Scene scene;
  const std::vector<glm::vec3> positions(3, glm::vec3(0.0f));
  const std::vector<glm::vec3> normals(3, glm::vec3(0, 1, 0));
  const std::vector<glm::vec2> texcoords(3, glm::vec2(0.0f));
  const std::vector<sweep::Triangle> triangles(1 << 21, sweep::Triangle{0, 1, 2});
  scene.meshes.push_back({positions, normals, texcoords, triangles, {}, {}});
  scene.objects.push_back({.name = "dot"});
  const auto fault = [&] {
    try {
      make_mesh_output(scene, {}, "m.ply");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(fault(),
            "the object \"dot\" has no triangles; give it an extent, or write the other objects by name");
  scene.objects.resize(1024, scene.objects.front());  // 2^21 triangles in each
  EXPECT_EQ(fault(),
            "m.ply: would hold 2147483648 triangles, more than the 2147483647 that mesh files count in 32 "
            "bits; ask "
            "for fewer cells or instances, one object at a time, or glTF, whose instances share their mesh");
}

}  // namespace
}  // namespace sweepkit::scene
