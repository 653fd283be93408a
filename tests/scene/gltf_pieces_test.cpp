// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "gltf_arrays.hpp"
#include "gltf_material.hpp"
#include "gltf_transform.hpp"
#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {
namespace {

glm::dmat4 recomposed(const NodeTransform& transform) {
  const glm::dvec4& r = transform.rotation;
  glm::dmat4 matrix = glm::mat4_cast(glm::dquat(r.w, r.x, r.y, r.z));
  for (int i = 0; i < 3; ++i) matrix[i] *= transform.scale[i];
  matrix[3] = glm::dvec4(transform.translation, 1);
  return matrix;
}

TEST(GltfTransform, DecomposesEveryPlacement) {
  const Placement placements[] = {
      {{1, 2, 3}, {0, 0, 0}, {1, 1, 1}},       {{0, 0, 0}, {10, 20, 30}, {1, 1, 1}},
      {{1e6, 0, 0}, {180, 0, 90}, {2, 3, 4}},  {{0, 0, 0}, {0, 180, 0}, {-1, 1, 1}},
      {{0, 0, 0}, {33, 44, 55}, {-1, -2, -3}}, {{0, 0, 0}, {0, 90, 270}, {1e-6, 1, 1e6}}};
  for (const Placement& placement : placements) {
    const glm::dmat4 matrix = to_matrix(placement);
    const auto transform = decompose(matrix);
    ASSERT_TRUE(transform.has_value());
    const glm::dmat4 again = recomposed(*transform);
    EXPECT_NEAR(glm::length(transform->rotation), 1, 1e-15);
    for (int column = 0; column < 4; ++column) {
      // A quaternion there and back: some tens of units in the last place of the column's length.
      const double length = std::max(glm::length(matrix[column]), 1e-300);
      EXPECT_LT(glm::distance(again[column], matrix[column]) / length, 1e-14) << column;
    }
  }
}

TEST(GltfTransform, AShiftAloneStaysExact) {
  const auto transform = decompose(to_matrix({{0.1, 0.2, 0.3}, {}, glm::dvec3(1)}));
  ASSERT_TRUE(transform.has_value());
  EXPECT_EQ(transform->translation, glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(transform->rotation, glm::dvec4(0, 0, 0, 1));
  EXPECT_EQ(transform->scale, glm::dvec3(1));
}

TEST(GltfTransform, AShearHasNone) {
  glm::dmat4 matrix(1.0);
  matrix[1][0] = 0.01;
  EXPECT_FALSE(decompose(matrix).has_value());
}

TEST(GltfArrays, VRunsDown) {
  const std::vector<glm::vec2> texcoords = {{0, 0}, {0.25f, 1}, {2, 0.75f}};
  const std::vector<sweep::Triangle> triangles = {{0, 1, 2}};
  MeshView mesh;
  mesh.texcoords = texcoords;
  mesh.triangles = triangles;
  EXPECT_EQ(gltf_texcoords(mesh, {}), (std::vector<glm::vec2>{{0, 1}, {0.25f, 0}, {2, 0.25f}}));
}

TEST(GltfArrays, ABakedTextureMovesEachAreaOnce) {
  const std::vector<glm::vec2> texcoords = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 0}, {0, 1}};
  const std::vector<sweep::Triangle> triangles = {{0, 1, 2}, {2, 1, 3}, {4, 5, 6}};  // 1 and 2 are shared
  const std::vector<sweep::Area> areas = {{0, 2}, {2, 1}};
  MeshView mesh;
  mesh.texcoords = texcoords;
  mesh.triangles = triangles;
  mesh.areas = areas;
  const std::vector<texmap::UvTransform> transforms = {{{0.5, 0.5}, {0, 0}}, {{0.25, 0.25}, {0.5, 0.5}}};
  EXPECT_EQ(gltf_texcoords(mesh, transforms),
            (std::vector<glm::vec2>{
                {0, 1}, {0.5f, 1}, {0, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}, {0.75f, 0.5f}, {0.5f, 0.25f}}));
}

TEST(GltfArrays, ShortIndicesReach65534) {
  const std::vector<sweep::Triangle> triangles = {{0, 65534, 1}};
  EXPECT_EQ(short_indices(triangles), (std::vector<std::uint16_t>{0, 65534, 1}));
}

TEST(GltfArrays, FileNamesBecomeUris) {
  EXPECT_EQ(percent_encoded("plain-name_1.0~.bin"), "plain-name_1.0~.bin");
  EXPECT_EQ(percent_encoded("a b#c?d%e/f"), "a%20b%23c%3Fd%25e%2Ff");
  EXPECT_EQ(percent_encoded("\xC3\xA9"), "%C3%A9");
}

Material material(glm::vec3 diffuse, glm::vec3 specular, float shininess, float reflect) {
  return {"m", diffuse, {}, specular, shininess, reflect};
}

TEST(GltfMaterial, MatteSurfacesAreRough) {
  const GltfMaterial terms = to_gltf(material(glm::vec3(0.3f, 0.4f, 0.5f), glm::vec3(0), 50, 0));
  EXPECT_EQ(terms.base_color, glm::vec3(0.3f, 0.4f, 0.5f));
  EXPECT_EQ(terms.metallic, 0);
  EXPECT_EQ(terms.roughness, 1);
  EXPECT_FALSE(terms.specular_color.has_value());
}

TEST(GltfMaterial, RoughnessIsTheFourthRootOfTheHighlight) {
  const GltfMaterial terms = to_gltf(material(glm::vec3(0.5f), glm::vec3(1), 30, 0));
  EXPECT_FLOAT_EQ(terms.roughness, 0.5f);  // (2 / 32)^(1/4)
  EXPECT_FLOAT_EQ(to_gltf(material(glm::vec3(0.5f), glm::vec3(1), 0, 0)).roughness, 1);
}

TEST(GltfMaterial, AShareReflectedIsACoatOfThatReflectance) {
  const GltfMaterial terms = to_gltf(material(glm::vec3(0.8f), glm::vec3(0), 50, 0.3f));
  EXPECT_EQ(terms.metallic, 0);
  EXPECT_FLOAT_EQ(terms.specular_color.value() * 0.04f, 0.3f);
  EXPECT_LE(terms.roughness, 0.25f);
}

TEST(GltfMaterial, WhatReflectsMoreThanItScattersIsAMetal) {
  const GltfMaterial terms = to_gltf(material(glm::vec3(0.02f), glm::vec3(0), 50, 0.92f));
  EXPECT_EQ(terms.metallic, 1);
  EXPECT_EQ(terms.roughness, 0);
  EXPECT_EQ(terms.base_color, glm::vec3(0.92f));
}

TEST(GltfMaterial, FactorsStayWithinTheFormat) {
  EXPECT_EQ(to_gltf(material(glm::vec3(2, -1, 0.5f), glm::vec3(0), 50, 0)).base_color, glm::vec3(1, 0, 0.5f));
}

}  // namespace
}  // namespace sweepkit::scene
