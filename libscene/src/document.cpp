// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/document.hpp"

#include "json_text.hpp"
#include "object_reader.hpp"
#include "read_look.hpp"
#include "read_objects.hpp"
#include "text_file.hpp"

namespace sweepkit::scene {
namespace {

constexpr std::size_t kLargestScene = std::size_t{256} << 20;

constexpr int kMostPixels = 65536;  // a side
// Between them a pixel's width keeps its digits.
constexpr Range kFieldOfView{.low = 0.001, .high = 179, .unit = " degrees"};

void read_camera(const Node& node, Document& document) {
  ObjectReader reader(node);
  const std::optional<Node> eye = reader.find("eye");
  const std::optional<Node> target = reader.find("target");
  Camera& camera = document.camera;
  if (const auto up = reader.find("up")) {
    camera.up = up->vector<3>(kCoordinate);
    if (glm::length(camera.up) < kExtent.low) up->fail("needs a direction that is not zero");
  }
  if (const auto fov = reader.find("fov_deg")) camera.fov_deg = fov->number(kFieldOfView);
  if (const auto width = reader.find("width")) document.width = width->integer(1, kMostPixels, " pixels");
  if (const auto height = reader.find("height")) document.height = height->integer(1, kMostPixels, " pixels");
  reader.finish();
  if (!eye && !target) return;
  if (!eye) node.fail("needs \"eye\" where there is \"target\"");
  if (!target) node.fail("needs \"target\" where there is \"eye\"");
  camera.eye = eye->vector<3>(kCoordinate);
  camera.target = target->vector<3>(kCoordinate);
  if (glm::distance(camera.eye, camera.target) < kExtent.low) target->fail("needs to differ from \"eye\"");
  document.has_view = true;
}

void read_background(const Node& node, const std::filesystem::path& folder, Document& document) {
  if (!node.is_object()) {
    document.background = node.color();
    return;
  }
  ObjectReader reader(node);
  const Node image = reader.get("image");
  document.environment = TextureEntry{"background", ImageEntry{folder / image.text()}, image.place()};
  reader.finish();
}

// A normal map holds numbers, not light. One image cannot be read both ways.
void settle_normal_maps(Document& document) {
  for (std::size_t i = 0; i < document.materials.size(); ++i) {
    const std::optional<std::size_t>& map = document.materials[i].normal_map;
    if (!map) continue;
    TextureEntry& texture = document.textures[*map];
    for (const Material& other : document.materials) {
      if (other.texture == map) {
        throw InputError(document.material_places[i], "its normal map \"" + texture.name +
                                                          "\" is the colours of \"" + other.name +
                                                          "\" too; name the image twice under \"textures\"");
      }
    }
    std::get<ImageEntry>(texture.source).color_space = texmap::ColorSpace::kLinear;
  }
}

Document read_document(const JsonDocument& json, const std::filesystem::path& folder) {
  const Node root(json.root, "");
  ObjectReader reader(root);
  Document document;
  if (const auto schema = reader.find("$schema")) schema->text();  // for editors
  const Node version = reader.get("sweepkit");
  if (version.number() != 1)
    version.fail("this program reads version 1 of the scene format, got " + to_text(version.number()));
  if (const auto node = reader.find("camera")) read_camera(*node, document);
  if (const auto node = reader.find("background")) read_background(*node, folder, document);
  if (const auto node = reader.find("ambient")) {
    document.ambient = node->color();
    document.has_ambient = true;
  }
  if (const auto node = reader.find("depth")) document.depth = node->integer(0, 64, " levels");
  if (const auto node = reader.find("lights")) {
    for (const Node& light : node->items()) document.lights.push_back(read_light(light));
  }
  if (const auto node = reader.find("textures")) document.textures = read_textures(*node, folder);
  if (const auto node = reader.find("materials")) {
    for (const auto& [name, material] : ObjectReader(*node).members()) {
      document.materials.push_back(read_material(name, material, document.textures));
      document.material_places.push_back(material.place());
    }
  }
  settle_normal_maps(document);
  const Node objects = reader.get("objects");
  reader.finish();
  document.objects = read_objects(objects, document.materials, folder);
  return document;
}

}  // namespace

SceneFile::SceneFile(const std::filesystem::path& file)
    : SceneFile(read_text_file(file, kLargestScene, "a scene file"), file) {}

SceneFile::SceneFile(const std::string& text, const std::filesystem::path& file)
    : SceneFile(text, file, file.parent_path()) {}

SceneFile::SceneFile(const std::string& text, const std::filesystem::path& file, std::filesystem::path folder)
    : json_(std::make_unique<JsonDocument>(parse_json(text, file.string()))), folder_(std::move(folder)) {}

SceneFile::SceneFile(SceneFile&&) noexcept = default;
SceneFile& SceneFile::operator=(SceneFile&&) noexcept = default;
SceneFile::~SceneFile() = default;

void SceneFile::set(const Setting& setting) {
  apply_setting(*json_, setting);
}

Document SceneFile::document(std::span<const Setting> settings) const {
  if (settings.empty()) return read_document(*json_, folder_);
  // Places in the copy go on naming this file's own sources.
  JsonDocument changed{{}, json_->root};
  for (const Setting& setting : settings) apply_setting(changed, setting);
  return read_document(changed, folder_);
}

std::string SceneFile::text(std::span<const Setting> settings) const {
  JsonDocument changed{{}, json_->root};
  for (const Setting& setting : settings) apply_setting(changed, setting);
  if (auto* members = std::get_if<JsonValue::Object>(&changed.root.data)) {
    std::erase_if(*members, [](const JsonMember& member) { return member.key == "$schema"; });
  }
  return json_text(changed.root);
}

void SceneFile::check_pointer(const std::string& pointer, const Place& place) const {
  JsonDocument scratch{{}, json_->root};
  apply_setting(scratch, {pointer, "null", place, place});
}

Document parse_document(const std::string& text, const std::filesystem::path& file,
                        const std::vector<Setting>& settings) {
  return SceneFile(text, file).document(settings);
}

Document read_document(const std::filesystem::path& file, const std::vector<Setting>& settings) {
  return SceneFile(file).document(settings);
}

}  // namespace sweepkit::scene
