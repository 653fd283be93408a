// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "povray_scene.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <stdexcept>
#include <variant>

namespace sweepkit::bench {
namespace {

// Every digit of a double, so that both see the same triangles.
std::string text(const glm::dvec3& v) {
  char out[96];
  std::snprintf(out, sizeof out, "<%.17g,%.17g,%.17g>", v.x, v.y, v.z);
  return out;
}
std::string text(double value) {
  char out[32];
  std::snprintf(out, sizeof out, "%.17g", value);
  return out;
}

double grey(const glm::vec3& color, const std::string& what) {
  if (color.r != color.g || color.g != color.b)
    throw std::runtime_error(what + " is tinted: POV-Ray has a number for it");
  return static_cast<double>(color.r);
}

std::string pigment(const scene::Document& document, const scene::Material& material) {
  if (!material.texture) return "pigment { color rgb " + text(glm::dvec3(material.diffuse)) + " }";
  const scene::TextureEntry& texture = document.textures[*material.texture];
  const auto* image = std::get_if<scene::ImageEntry>(&texture.source);
  if (image == nullptr || image->wrap != texmap::Wrap::kRepeat)
    throw std::runtime_error("texture " + texture.name + " is no image that repeats");
  const std::string gamma = image->color_space == texmap::ColorSpace::kSrgb ? "srgb" : "1.0";
  return "pigment { uv_mapping image_map { png \"" + std::filesystem::absolute(image->file).string() +
         "\" gamma " + gamma + " } }";
}

std::string texture(const scene::Document& document, const scene::Scene& scene,
                    const scene::Material& material) {
  // The pigment is the diffuse colour, but for images, which are multiplied by a number.
  const double diffuse =
      material.texture ? grey(material.diffuse, "material " + material.name + "'s diffuse") : 1.0;
  const double specular = grey(material.specular, "material " + material.name + "'s specular");
  return "  texture {\n    " + pigment(document, material) + "\n    finish { ambient rgb " +
         text(diffuse * glm::dvec3(scene.ambient)) + " diffuse " + text(diffuse) + " specular " +
         text(specular) + " roughness " + text(1 / static_cast<double>(material.shininess)) + " reflection " +
         text(static_cast<double>(material.reflect)) + " }\n  }\n";
}

std::string mesh(const scene::Document& document, const scene::Scene& scene, const scene::Object& object) {
  const scene::MeshView& view = scene.meshes[object.mesh];
  const scene::Material material = object.material ? scene.materials[*object.material] : scene::Material{};
  const glm::dmat3 normal_to_world = glm::transpose(glm::inverse(glm::dmat3(object.world_from_object)));
  const std::string count = std::to_string(view.positions.size());
  std::string out = "// " + object.name + "\nmesh2 {\n  vertex_vectors { " + count;
  for (const glm::vec3& position : view.positions) {
    const glm::dvec4 local(view.origin + glm::dvec3(position), 1);
    out += ",\n" + text(glm::dvec3(object.world_from_object * local));
  }
  out += " }\n  normal_vectors { " + count;
  for (const glm::vec3& normal : view.normals)
    out += ",\n" + text(glm::normalize(normal_to_world * glm::dvec3(normal)));
  out += " }\n";
  if (material.texture) {
    out += "  uv_vectors { " + count;
    for (const glm::vec2& uv : view.texcoords)
      out += ",\n<" + text(static_cast<double>(uv.x)) + "," + text(static_cast<double>(uv.y)) + ">";
    out += " }\n";
  }
  out += "  face_indices { " + std::to_string(view.triangles.size());
  for (const auto& [a, b, c] : view.triangles)
    out += ",\n<" + std::to_string(a) + "," + std::to_string(b) + "," + std::to_string(c) + ">";
  return out + " }\n" + texture(document, scene, material) + "}\n";
}

std::string light(const scene::Light& light) {
  if (const auto* point = std::get_if<scene::PointLight>(&light))
    return "light_source { " + text(point->position) + " color rgb " + text(glm::dvec3(point->intensity)) +
           " }\n";
  const auto& directional = std::get<scene::DirectionalLight>(light);
  // Far enough that the scene lies between; parallel rays, so how far does not matter.
  const glm::dvec3 from = -1e4 * glm::normalize(directional.direction);
  return "light_source { " + text(from) + " color rgb " + text(glm::dvec3(directional.intensity)) +
         " parallel point_at <0,0,0> }\n";
}

}  // namespace

std::string povray_scene(const scene::Document& document, const scene::Scene& scene) {
  // A tree of ours is as many reflections deep; the eye ray is the first level there.
  std::string out = "#version 3.7;\nglobal_settings { assumed_gamma 1.0 max_trace_level " +
                    std::to_string(scene.depth + 1) + " ambient_light rgb 1 }\nbackground { color rgb " +
                    text(glm::dvec3(scene.background)) + " }\n";
  for (const scene::Light& each : scene.lights) out += light(each);
  for (const scene::Object& object : scene.objects) out += mesh(document, scene, object);
  return out;
}

std::string povray_camera(const scene::Scene& scene, glm::dvec2 shift) {
  const glm::dmat3 axes = scene::world_from_camera(scene.camera);
  const double height = 2 * std::tan(0.5 * scene.camera.fov_deg * std::numbers::pi / 180);
  const double pixel = height / scene.height;
  // Said as vectors, neither angle nor handedness is left to POV-Ray.
  return "camera { perspective location " + text(scene.camera.eye) + " direction " +
         text(-axes[2] + pixel * (shift.x * axes[0] - shift.y * axes[1])) + " up " + text(height * axes[1]) +
         " right " + text(pixel * scene.width * axes[0]) + " }\n";
}

}  // namespace sweepkit::bench
