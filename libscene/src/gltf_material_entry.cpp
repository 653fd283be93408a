// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_material_entry.hpp"

#include "gltf_number.hpp"

namespace sweepkit::scene {
namespace {

tinygltf::Value number(float value) {
  return tinygltf::Value(in_few_digits(value));
}

tinygltf::Value color(const glm::vec3& value) {
  return tinygltf::Value(tinygltf::Value::Array{number(value.r), number(value.g), number(value.b)});
}

}  // namespace

tinygltf::Material material_entry(const std::string& name, const GltfMaterial& terms, const GltfMaps& maps,
                                  std::set<std::string>& extensions) {
  tinygltf::Material entry;
  entry.name = name;
  entry.doubleSided = terms.is_double_sided;
  if (terms.alpha < 1) entry.alphaMode = "BLEND";
  tinygltf::PbrMetallicRoughness& pbr = entry.pbrMetallicRoughness;
  pbr.baseColorFactor = {in_few_digits(terms.base_color.r), in_few_digits(terms.base_color.g),
                         in_few_digits(terms.base_color.b), in_few_digits(terms.alpha)};
  pbr.metallicFactor = in_few_digits(terms.metallic);
  pbr.roughnessFactor = in_few_digits(terms.roughness);
  if (maps.base_color) pbr.baseColorTexture.index = *maps.base_color;
  if (maps.normals) {
    entry.normalTexture.index = maps.normals->texture;
    entry.normalTexture.scale = maps.normals->scale;
    entry.normalTexture.texCoord = maps.normals->texcoord;
  }

  const auto extend = [&](const std::string& extension, tinygltf::Value::Object values) {
    extensions.insert(extension);
    entry.extensions[extension] = tinygltf::Value(std::move(values));
  };
  if (terms.specular || terms.specular_color) {
    tinygltf::Value::Object values;
    if (terms.specular) values["specularFactor"] = number(*terms.specular);
    if (terms.specular_color) values["specularColorFactor"] = color(*terms.specular_color);
    extend("KHR_materials_specular", std::move(values));
  }
  if (terms.ior) extend("KHR_materials_ior", {{"ior", number(*terms.ior)}});
  if (terms.transmission > 0) {
    extend("KHR_materials_transmission", {{"transmissionFactor", number(terms.transmission)}});
  }
  if (terms.volume) {
    tinygltf::Value::Object values{{"thicknessFactor", number(terms.volume->thickness)}};
    if (terms.volume->attenuation_distance > 0) {
      values["attenuationDistance"] = number(terms.volume->attenuation_distance);
      values["attenuationColor"] = color(terms.volume->attenuation_color);
    }
    extend("KHR_materials_volume", std::move(values));
  }
  if (terms.is_unlit) extend("KHR_materials_unlit", {});
  return entry;
}

}  // namespace sweepkit::scene
