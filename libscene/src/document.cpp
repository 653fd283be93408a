// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/document.hpp"

#include <fstream>
#include <sstream>

#include "object_reader.hpp"
#include "read_look.hpp"
#include "read_objects.hpp"

namespace sweepkit::scene {
namespace {

constexpr int kMostPixels = 65536;  // a side

void read_camera(const Node& node, Document& document) {
  ObjectReader reader = read_object(node);
  const std::optional<Node> eye = reader.find("eye");
  const std::optional<Node> target = reader.find("target");
  Camera camera;
  if (const auto up = reader.find("up")) {
    camera.up = up->vector<3>();
    if (camera.up == glm::dvec3(0.0)) up->fail("needs a direction that is not zero");
  }
  if (const auto fov = reader.find("fov_deg")) {
    camera.fov_deg =
        fov->number({.low = 0, .high = 180, .unit = " degrees", .excludes_low = true, .excludes_high = true});
  }
  if (const auto width = reader.find("width")) document.width = width->integer(1, kMostPixels, " pixels");
  if (const auto height = reader.find("height")) document.height = height->integer(1, kMostPixels, " pixels");
  reader.finish();
  if (!eye && !target) return;  // the picture frames the scene
  if (!eye) node.fail("needs \"eye\" where there is \"target\"");
  if (!target) node.fail("needs \"target\" where there is \"eye\"");
  camera.eye = eye->vector<3>();
  camera.target = target->vector<3>();
  if (camera.eye == camera.target) target->fail("needs to differ from \"eye\"");
  document.camera = camera;
}

Document read_document(const JsonDocument& json, const std::filesystem::path& folder) {
  const Node root(json.root, "");
  ObjectReader reader = read_object(root);
  Document document;
  const Node version = reader.get("sweepkit");
  if (version.number() != 1)
    version.fail("this program reads version 1 of the scene format, got " + to_text(version.number()));
  reader.find("$schema");
  if (const auto node = reader.find("camera")) read_camera(*node, document);
  if (const auto node = reader.find("background")) document.background = node->color();
  if (const auto node = reader.find("ambient")) {
    document.ambient = node->color();
    document.has_ambient = true;
  }
  if (const auto node = reader.find("depth")) document.depth = node->integer(0, 64, " reflections");
  if (const auto node = reader.find("lights")) {
    for (const Node& light : node->items()) document.lights.push_back(read_light(light));
  }
  if (const auto node = reader.find("textures")) document.textures = read_textures(*node, folder);
  if (const auto node = reader.find("materials")) {
    ObjectReader materials = read_object(*node);
    for (const auto& [name, value] : std::get<JsonValue::Object>(node->value().data)) {
      document.materials.push_back(read_material(materials.get(name), document.textures));
      document.materials.back().name = name;
    }
  }
  const Node objects = reader.get("objects");
  reader.finish();
  document.objects = read_objects(objects, document.materials);
  return document;
}

}  // namespace

Document parse_document(const std::string& text, const std::filesystem::path& file,
                        const std::vector<Setting>& settings) {
  JsonDocument json = parse_json(text, file.string());
  for (const Setting& setting : settings) apply_setting(json, setting);
  return read_document(json, file.parent_path());
}

Document read_document(const std::filesystem::path& file, const std::vector<Setting>& settings) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw InputError({.file = file.string()}, "is a folder, not a scene file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    const bool exists = std::filesystem::exists(file, ignored);
    throw InputError({.file = file.string()},
                     exists ? "cannot be read; check its permissions" : "no such file");
  }
  std::ostringstream text;
  text << stream.rdbuf();
  if (stream.bad()) throw InputError({.file = file.string()}, "cannot be read to its end");
  return parse_document(text.str(), file, settings);
}

}  // namespace sweepkit::scene
