// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <utility>

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

// What KHR_materials_specular mirrors at right angles where the index has this F0, also to readers that pass
// over its factor. Within float32's rounding of three products.
void expect_mirror(const GltfMaterial& terms, float f0, const glm::vec3& share) {
  EXPECT_FALSE(terms.specular.has_value());
  const glm::vec3 color = terms.specular_color.value_or(glm::vec3(1));
  for (glm::length_t k = 0; k < 3; ++k) EXPECT_NEAR(f0 * color[k] / share[k], 1, 4e-7);
}

// 1 / (4 alpha^2) of the share comes back in the middle, alpha^2 = 2 / (n + 2).
TEST(GltfMaterial, AHighlightIsAsHighAsWhitteds) {
  const glm::vec3 specular(0.6f, 0.48f, 0.22f);
  const GltfMaterial terms = to_gltf(material(glm::vec3(0.5f), specular, 120, 0));
  expect_mirror(terms, 0.04f, specular * (8.0f / 122));
  expect_mirror(to_gltf(material(glm::vec3(0.5f), glm::vec3(1), 0, 0)), 0.04f, glm::vec3(1));
  EXPECT_FALSE(to_gltf(material(glm::vec3(0.5f), specular, 120, 0), GltfLook::kCompatible).specular_color);
}

TEST(GltfMaterial, AShareReflectedIsACoatOfThatReflectance) {
  const GltfMaterial terms = to_gltf(material(glm::vec3(0.8f), glm::vec3(0), 50, 0.3f));
  EXPECT_EQ(terms.metallic, 0);
  expect_mirror(terms, 0.04f, glm::vec3(0.3f));
}

TEST(GltfMaterial, AMirrorWithoutAHighlightIsSharpAndWithOneItCanBeRead) {
  EXPECT_EQ(to_gltf(material(glm::vec3(0.8f), glm::vec3(0), 50, 0.3f)).roughness, 0);
  for (const float shininess : {0.0f, 1.0f, 10.0f}) {
    EXPECT_EQ(to_gltf(material(glm::vec3(0.8f), glm::vec3(0.5f), shininess, 0.3f)).roughness, 0.25f);
  }
}

// The lobe r D / (4 cos^2) of GGX, straight from its definition, where (N.H)^n is a half.
TEST(GltfMaterial, AMirrorsHighlightIsAsWideAsWhittedsAtHalfItsHeight) {
  for (const float shininess : {80.0f, 180.0f, 600.0f}) {
    for (const float reflect : {0.2f, 0.3f}) {
      const GltfMaterial terms = to_gltf(material(glm::vec3(0.8f), glm::vec3(0.5f), shininess, reflect));
      ASSERT_LT(terms.roughness, 0.25f);
      const double alpha = std::pow(terms.roughness, 2);
      const double cosine2 = std::pow(0.5, 2.0 / shininess);
      const double height = std::pow(alpha / (cosine2 * (alpha * alpha - 1) + 1), 2) * reflect / 4;
      // 1 - cosine2 in float32 has lost 1 / (2 ln 2 / n) of its digits: 600 / 1.4 x 6e-8, squared.
      EXPECT_NEAR(height / 0.25, 1, 2e-4);
      EXPECT_GT(reflect / (4 * alpha * alpha), 0.5) << "higher in its middle";
    }
  }
}

TEST(GltfMaterial, WhatReflectsMoreThanItScattersIsAMetal) {
  const GltfMaterial terms = to_gltf(material(glm::vec3(0.02f), glm::vec3(0), 50, 0.92f));
  EXPECT_EQ(terms.metallic, 1);
  EXPECT_EQ(terms.roughness, 0);
  EXPECT_EQ(terms.base_color, glm::vec3(0.92f));
}

Material glass(float transmit, float ior, glm::vec3 absorption = glm::vec3(0)) {
  Material material;
  material.diffuse = glm::vec3(0);
  material.transmit = transmit;
  material.reflect = 1;
  material.ior = ior;
  material.absorption = absorption;
  material.fresnel = Fresnel::kExact;
  return material;
}

TEST(GltfMaterial, ClosedGlassRefractsAndIsSeenFromTheFront) {
  const GltfMaterial terms = to_gltf(glass(1, 1.7f), GltfLook::kFull, {.thickness = 0.25});
  EXPECT_EQ(terms.base_color, glm::vec3(1)) << "a black body would tint it black";
  EXPECT_EQ(terms.transmission, 1);
  EXPECT_EQ(terms.metallic, 0);
  EXPECT_EQ(terms.roughness, 0);
  EXPECT_EQ(terms.ior, 1.7f);
  EXPECT_EQ(terms.alpha, 1) << "never blended too";
  EXPECT_FALSE(terms.is_double_sided);
  EXPECT_FALSE(terms.specular.has_value()) << "the index is the whole mirror";
  ASSERT_TRUE(terms.volume.has_value());
  EXPECT_EQ(*terms.volume, (GltfVolume{.thickness = 0.25f}));
}

TEST(GltfMaterial, OpenGlassIsAWallWithoutABody) {
  const GltfMaterial terms = to_gltf(glass(1, 1.7f, glm::vec3(3)), GltfLook::kFull, {});
  EXPECT_FALSE(terms.volume.has_value());
  EXPECT_TRUE(terms.is_double_sided);
  EXPECT_EQ(terms.transmission, 1);
}

// glTF scatters base (1 - transmission) and lets through base transmission.
TEST(GltfMaterial, WhatGlassScattersAndLetsThroughIsWhitteds) {
  for (const float d : {0.0f, 0.1f, 0.4f}) {
    for (const float t : {0.2f, 0.6f}) {
      Material material = glass(t, 1.5f);
      material.diffuse = glm::vec3(d);
      const GltfMaterial terms = to_gltf(material);
      EXPECT_NEAR(terms.base_color.g * (1 - terms.transmission), d, 1e-6);
      EXPECT_NEAR(terms.base_color.g * terms.transmission, t, 1e-6);
    }
  }
}

TEST(GltfMaterial, AbsorptionIsBeersLawOverAnyDistance) {
  const glm::vec3 sigma(90, 38, 0);
  const GltfMaterial terms = to_gltf(glass(1, 1.5f, sigma), GltfLook::kFull, {.thickness = 1});
  ASSERT_TRUE(terms.volume.has_value());
  for (const float metres : {0.001f, 0.02f, 0.1f}) {
    for (glm::length_t k = 0; k < 3; ++k) {
      const double ours =
          std::pow(terms.volume->attenuation_color[k], metres / terms.volume->attenuation_distance);
      // Float32: 6e-8 in the colour and the distance, times the exponent of at most 9.
      EXPECT_NEAR(ours / std::exp(-static_cast<double>(sigma[k]) * metres), 1, 3e-6);
    }
    EXPECT_GT(terms.volume->attenuation_color.r, 0.36) << "far from what float32 or a viewer could round off";
  }
}

TEST(GltfMaterial, WithoutFresnelGlassMirrorsItsShare) {
  Material material = glass(0.6f, 1.5f);
  material.fresnel = Fresnel::kNone;
  material.reflect = 0.2f;
  expect_mirror(to_gltf(material), 0.04f, glm::vec3(0.2f));
  material.ior = 2;
  expect_mirror(to_gltf(material), 1.0f / 9, glm::vec3(0.2f));
  material.reflect = 0;
  EXPECT_EQ(to_gltf(material).specular, 0.0f);
}

TEST(GltfMaterial, WithFresnelAShareIsAFactorOfTheMirror) {
  Material material = glass(1, 1.35f);
  material.reflect = 0.92f;
  EXPECT_EQ(to_gltf(material).specular, 0.92f);
  EXPECT_FALSE(to_gltf(material).specular_color.has_value());
  material.ior = 1;
  EXPECT_EQ(to_gltf(material).specular, 0.0f) << "equal indices mirror nothing, at the edge either";
}

TEST(GltfMaterial, AnOpaqueCoatByFresnelHasItsIndex) {
  Material material = glass(0, 2);
  material.diffuse = glm::vec3(0.5f);
  const GltfMaterial terms = to_gltf(material);
  EXPECT_EQ(terms.metallic, 0);
  EXPECT_EQ(terms.ior, 2.0f);
  EXPECT_EQ(terms.base_color, glm::vec3(0.5f));
  EXPECT_EQ(terms.roughness, 0);
}

// glTF's index is at least 1. F0 is that of the turned-round index; a body thinner than air it cannot have.
TEST(GltfMaterial, ABubbleIsAWall) {
  const GltfMaterial terms = to_gltf(glass(1, 0.5f), GltfLook::kFull, {.thickness = 1});
  EXPECT_EQ(terms.ior, 2.0f);
  EXPECT_FALSE(terms.volume.has_value());
}

TEST(GltfMaterial, GlassThatOnlyDimsHasABodyAndStraightRays) {
  const GltfMaterial terms = to_gltf(glass(1, 1, glm::vec3(2)), GltfLook::kFull, {.thickness = 1});
  EXPECT_EQ(terms.ior, 1.0f);
  EXPECT_TRUE(terms.volume.has_value());
  const GltfMaterial clear = to_gltf(glass(1, 1), GltfLook::kFull, {.thickness = 1});
  EXPECT_FALSE(clear.ior.has_value());
  EXPECT_FALSE(clear.volume.has_value());
}

// What a blended wall adds of its own, and lets through.
std::pair<glm::vec3, float> blend_of(const GltfMaterial& terms) {
  return {terms.alpha * terms.base_color, 1 - terms.alpha};
}

TEST(GltfMaterial, BlendedGreyGlassLooksAsWhittedsOverAnything) {
  Material material = glass(0.8f, 1);
  material.fresnel = Fresnel::kNone;
  material.diffuse = glm::vec3(0.1f, 0.05f, 0.12f);
  for (const GltfLook look : {GltfLook::kUnlit, GltfLook::kCompatible}) {
    const GltfMaterial sheet = to_gltf(material, look);
    EXPECT_EQ(sheet.transmission, 0) << "never both";
    EXPECT_FALSE(sheet.volume || sheet.ior || sheet.specular || sheet.specular_color);
    EXPECT_EQ(sheet.is_unlit, look == GltfLook::kUnlit);
    EXPECT_TRUE(sheet.is_double_sided);
    EXPECT_FLOAT_EQ(sheet.alpha, 0.2f) << "1 - transmit";
    const auto [own, through] = blend_of(sheet);
    const GltfMaterial body = to_gltf(material, look, {.thickness = 0.1});
    EXPECT_FALSE(body.is_double_sided) << "the walls by which a ray enters";
    const auto [own_of_two, through_two] = blend_of(body);
    EXPECT_NEAR(through_two, 0.64, 1e-6);
    for (glm::length_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(own[k], material.diffuse[k], 1e-6);
      EXPECT_NEAR(own_of_two[k], 1.8f * material.diffuse[k], 1e-6)
          << "the wall behind, through the one before";
    }
  }
}

// The sum over the colours of the integral over greys b of (own + share b - D - T b)^2.
double blend_error(const glm::dvec3& own, double share, const glm::dvec3& d, const glm::dvec3& t) {
  double sum = 0;
  for (glm::length_t k = 0; k < 3; ++k) {
    const double p = own[k] - d[k];
    const double q = share - t[k];
    sum += p * p + p * q + q * q / 3;
  }
  return sum;
}

// Against every share in steps of a thousandth, with the own light that is best for it.
TEST(GltfMaterial, BlendedTintedGlassIsAsNearToWhittedsOverGreysAsOneAlphaCan) {
  const glm::vec3 sigmas[] = {{1, 3, 0.5f}, {90, 38, 6}, {2, 9, 45}, {0, 0, 200}, {300, 300, 0}, {5, 5, 5}};
  for (const glm::vec3& sigma : sigmas) {
    for (const glm::vec3 diffuse : {glm::vec3(0), glm::vec3(0.06f, 0.02f, 0.08f)}) {
      Material material = glass(0.9f, 1.5f, sigma);
      material.diffuse = diffuse;
      const GltfMaterial terms = to_gltf(material, GltfLook::kUnlit, {.thickness = 0.01, .scale = 2});
      const double wall = 0.9 * 0.96;
      const glm::dvec3 behind = wall / (1.0 + glm::dvec3(sigma) * 0.02);
      const glm::dvec3 d = glm::dvec3(diffuse) * (1.0 + behind);
      const glm::dvec3 t = wall * behind;
      const auto [own, share] = blend_of(terms);
      const double ours = blend_error(own, share, d, t);
      for (int i = 0; i <= 1000; ++i) {
        const double other = i / 1000.0;
        const glm::dvec3 best = glm::max(d + 0.5 * (t - other), 0.0);
        EXPECT_LE(ours, blend_error(best, other, d, t) + 1e-6) << "float32's rounding";
      }
    }
  }
}

TEST(GltfMaterial, UnlitKeepsTheColourAlone) {
  const GltfMaterial terms = to_gltf(material(glm::vec3(0.3f), glm::vec3(1), 30, 0.2f), GltfLook::kUnlit);
  EXPECT_EQ(terms, (GltfMaterial{.base_color = glm::vec3(0.3f), .is_unlit = true}));
}

TEST(GltfMaterial, FactorsStayWithinTheFormat) {
  EXPECT_EQ(to_gltf(material(glm::vec3(2, -1, 0.5f), glm::vec3(0), 50, 0)).base_color, glm::vec3(1, 0, 0.5f));
}

}  // namespace
}  // namespace sweepkit::scene
