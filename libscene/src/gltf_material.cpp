// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// [Walter07] B. Walter, S. Marschner, H. Li, K. Torrance, "Microfacet models for refraction through rough
// surfaces" (2007), for the width of a microfacet lobe that looks like a Blinn exponent n. A mirror of
// Whitted's is perfectly sharp and its highlight is not; glTF has one roughness for both, so the sharper of
// two guesses is taken. Glass is looked through, so that its highlight gives way to a clear view.
//
// What is mirrored is told by KHR_materials_specular. At right angles it is min(F0 colour, 1) factor, at the
// edge it is factor: colour 1 / F0 and factor r would be r at every angle, as Whitted's is. But there are
// readers that pass over the factor (Blender 3.4), to whom that is a perfect mirror; colour r / F0 says r to
// all.

#include "gltf_material.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sweepkit::scene {
namespace {

constexpr float kUsualIor = 1.5f;  // what glTF takes where none is written
constexpr float kUsualMirror = 0.04f;

float max_of(const glm::vec3& color) {
  return std::max({color.r, color.g, color.b});
}

// F0, the mirrored share at right angles; the same from inside and outside.
float mirror_of(float ior) {
  const float root = (ior - 1) / (ior + 1);
  return root * root;
}

float highlight_roughness(const Material& material) {
  const bool has_highlight = material.specular != glm::vec3(0.0f);
  return has_highlight ? std::pow(2 / (material.shininess + 2), 0.25f) : 1.0f;
}

// A lobe of alpha = sqrt(2 / (n + 2)) is 1 / (pi alpha^2) high, so that a light of pi I (docs/gltf.md) sends
// back f I / (4 alpha^2) in its middle; Whitted's highlight is specular I there.
void set_highlight(GltfMaterial& terms, const Material& material) {
  if (material.specular == glm::vec3(0.0f)) return;
  const glm::vec3 share = 8.0f / (material.shininess + 2) * material.specular;
  terms.specular_color = glm::min(share, glm::vec3(1.0f)) / kUsualMirror;
}

// Of what mirrors `share` of the light. A lobe of f A / (4 (S + A C)^2), A = alpha^2, S = sin^2 and C = cos^2
// of the angle where Whitted's highlight is half as high as in its middle, has the same height s / 2 there
// for 2 s C^2 A^2 - (f - 4 s S C) A + 2 s S^2 = 0: the smaller root is higher in its middle, and a sharper
// mirror.
float mirror_roughness(const Material& material, float share) {
  constexpr float kSharp = 0.25f;  // a reflection that can still be read
  const float height = max_of(material.specular);
  if (!(height > 0)) return 0;
  const float cosine2 = std::pow(0.5f, 2 / material.shininess);
  const float sine2 = 1 - cosine2;
  const float most = height * sine2 * cosine2;
  if (!(share > 8 * most)) return kSharp;
  const float alpha2 =
      4 * height * sine2 * sine2 / (share - 4 * most + std::sqrt(share * (share - 8 * most)));
  return std::min(std::pow(alpha2, 0.25f), kSharp);
}

// What is mirrored, with `ior` already settled.
void set_mirror(GltfMaterial& terms, const Material& material) {
  const float ior = terms.ior.value_or(kUsualIor);
  const float mirror = ior == kUsualIor ? kUsualMirror : mirror_of(ior);
  if (material.fresnel != Fresnel::kNone) {
    // Between equal indices nothing is mirrored, though glTF's edge would shine.
    const float share = material.ior == 1 ? 0 : material.reflect;
    if (share < 1) terms.specular = share;
  } else if (material.reflect == 0 || mirror == 0) {
    terms.specular = 0.0f;
  } else {
    terms.specular_color = glm::vec3(material.reflect / mirror);
  }
}

GltfMaterial opaque(const Material& material) {
  const glm::vec3& diffuse = material.diffuse;
  const bool has_fresnel = material.fresnel != Fresnel::kNone;
  const bool is_mirror = material.reflect > 0 && !(has_fresnel && material.ior == 1);
  GltfMaterial terms{.base_color = diffuse, .roughness = highlight_roughness(material)};
  if (!is_mirror) {
    set_highlight(terms, material);
    return terms;
  }
  if (!has_fresnel && material.reflect > max_of(diffuse)) {
    return {.base_color = glm::vec3(material.reflect), .metallic = 1, .roughness = 0};
  }
  float share = material.reflect;
  if (has_fresnel) {
    const float ior = std::max(material.ior, 1 / material.ior);
    if (ior != kUsualIor) terms.ior = ior;
    share *= mirror_of(ior);
  }
  terms.roughness = mirror_roughness(material, share);
  set_mirror(terms, material);
  return terms;
}

GltfVolume volume_of(const Material& material, double thickness) {
  GltfVolume volume{.thickness = static_cast<float>(thickness)};
  const float strongest = max_of(material.absorption);
  if (strongest >= std::numeric_limits<float>::min()) {
    volume.attenuation_distance = 1 / strongest;
    volume.attenuation_color = glm::exp(-material.absorption / strongest);
  }
  return volume;
}

GltfMaterial glass(const Material& material, const GltfBody& body) {
  const glm::vec3& d = material.diffuse;
  const float t = material.transmit;
  GltfMaterial terms{.base_color = glm::min(d + t, glm::vec3(1.0f)),
                     .roughness = 0,
                     .transmission = t / (t + (d.r + d.g + d.b) / 3),
                     .is_double_sided = !body.thickness};
  const bool is_denser = material.ior >= 1;
  const bool has_absorption = material.absorption != glm::vec3(0.0f);
  // glTF has no body thinner than what is round it: such a one is a wall without a body.
  if (body.thickness && is_denser && (material.ior > 1 || has_absorption)) {
    terms.volume = volume_of(material, *body.thickness);
  }
  const float ior = is_denser ? material.ior : 1 / material.ior;
  if (ior != kUsualIor && (ior > 1 || terms.volume)) terms.ior = ior;
  set_mirror(terms, material);
  return terms;
}

// What looks D + T b over every grey b, as nearly as o + s b can, o >= 0 for each colour and s for all: the
// least sum of squares over b from black to white. There o = max(D + (T - s) / 2, 0), and s is a mean, of T
// where o is not 0 and, weighing four times as much, of T + 3 D / 2 where it is. The first s is too large, if
// not right; each next one is smaller and leaves no more than three sets of colours to go through.
float share_behind(const glm::vec3& own, const glm::vec3& through) {
  float share = (through.r + through.g + through.b) / 3;
  for (int pass = 0; pass < 3; ++pass) {
    float sum = 0;
    float weights = 0;
    for (glm::length_t k = 0; k < 3; ++k) {
      const bool is_over_black = own[k] + 0.5f * (through[k] - share) > 0;
      const float weight = is_over_black ? 1 : 4;
      sum += weight * (is_over_black ? through[k] : through[k] + 1.5f * own[k]);
      weights += weight;
    }
    share = sum / weights;
  }
  return share;
}

// Of a body only the walls are drawn by which a ray enters it. Each stands for that by which the ray comes
// out as well, which scatters and dims once more: with w what a wall and a what the way between lets through
// it is d + w a (d + w b). Of ways inside the mean x is known; of their lengths' law, which differs from body
// to body, it is taken that it is exponential, whose mean of exp(-sigma length) is 1 / (1 + sigma x).
GltfMaterial blended(const Material& material, const GltfBody& body) {
  const float mirror = material.fresnel == Fresnel::kNone ? 0 : mirror_of(material.ior);
  const float wall = material.transmit * (1 - mirror);
  glm::vec3 own = material.diffuse;
  glm::vec3 through(wall);
  if (body.thickness) {
    const auto metres = static_cast<float>(*body.thickness * body.scale);
    const glm::vec3 behind = wall / (1.0f + material.absorption * metres);
    own += behind * material.diffuse;
    through *= behind;
  }
  const float share = share_behind(own, through);
  GltfMaterial terms{.alpha = 1 - share, .roughness = highlight_roughness(material)};
  own = glm::max(own + 0.5f * (through - share), 0.0f);
  terms.base_color = share < 1 ? own / (1 - share) : glm::vec3(0.0f);
  terms.is_double_sided = !body.thickness;
  return terms;
}

}  // namespace

GltfMaterial to_gltf(const Material& given, GltfLook look, const GltfBody& body) {
  Material material = given;
  material.diffuse = glm::clamp(given.diffuse, 0.0f, 1.0f);
  material.reflect = std::clamp(given.reflect, 0.0f, 1.0f);
  material.transmit = std::clamp(given.transmit, 0.0f, 1.0f);
  const bool is_glass = material.transmit > 0;
  if (look == GltfLook::kFull) return is_glass ? glass(material, body) : opaque(material);
  GltfMaterial terms = is_glass ? blended(material, body) : opaque(material);
  terms.base_color = glm::clamp(terms.base_color, 0.0f, 1.0f);
  terms.specular.reset();
  terms.specular_color.reset();
  terms.ior.reset();
  if (look == GltfLook::kUnlit) {
    terms.is_unlit = true;
    terms.metallic = 0;
    terms.roughness = 1;
  }
  return terms;
}

}  // namespace sweepkit::scene
