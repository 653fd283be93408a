// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Writing and reading stand side by side, so that an option that is written is read.

#include "sweepkit/scene/gltf_source.hpp"

#include "gltf_extras.hpp"
#include "gltf_file.hpp"
#include "json_text.hpp"
#include "object_reader.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/levels.hpp"
#include "sweepkit/scene/texel_density.hpp"

namespace sweepkit::scene {
namespace {

const std::vector<std::string> kLooks = {"full", "unlit", "compatible"};            // by GltfLook
const std::vector<std::string> kPlaces = {"by-container", "embedded", "separate"};  // by GltfImages
const std::vector<std::string> kFormats = {"png", "jpg"};                           // by ImageFormat
constexpr int kMostTexels = 32768;
constexpr double kMostSeconds = 86400;

JsonValue value(std::string text) {
  return {std::move(text), {}};
}

void read_options(const Node& node, GltfOptions& options) {
  ObjectReader reader(node);
  if (const auto object = reader.find("object")) options.object = object->text();
  if (const auto size = reader.find("bake_size"))
    options.bake_size = size->integer(1, kMostTexels, " texels");
  if (const auto density = reader.find("texel_density")) {
    options.texel_density =
        density->number({.low = kLeastDensity, .high = kMostDensity, .unit = " texels a metre"});
  }
  if (const auto has = reader.find("tangents")) options.has_tangents = has->boolean();
  if (const auto look = reader.find("look")) options.look = static_cast<GltfLook>(look->choice(kLooks));
  if (const auto in = reader.find("images")) options.images_in = static_cast<GltfImages>(in->choice(kPlaces));
  if (const auto format = reader.find("image_format")) {
    options.image_format = static_cast<texmap::ImageFormat>(format->choice(kFormats));
  }
  if (const auto size = reader.find("max_texture"))
    options.max_texture = size->integer(0, kMostTexels, " texels");
  const Range seconds{.low = 0, .high = kMostSeconds};
  if (const auto turn = reader.find("turntable")) options.turntable_seconds = turn->number(seconds);
  if (const auto levels = reader.find("lod")) options.levels = levels->integer(0, kMostLevels, " levels");
  if (const auto growth = reader.find("grow")) options.grow_seconds = growth->number(seconds);
  if (const auto text = reader.find("copyright")) options.copyright = text->text();
  if (const auto is = reader.find("quantize")) options.is_quantized = is->boolean();
  if (const auto bits = reader.find("position_bits")) options.position_bits = bits->integer(8, 16, " bits");
  if (const auto is = reader.find("meshopt")) options.is_packed = is->boolean();
  reader.finish();
}

}  // namespace

std::string gltf_extras(const GltfOptions& options) {
  if (options.scene.empty()) return "";
  const GltfOptions usual;
  JsonValue::Object members;
  const auto add = [&](const char* key, JsonValue what) { members.push_back({key, {}, std::move(what)}); };
  if (options.object) add("object", value(*options.object));
  if (options.bake_size != usual.bake_size) add("bake_size", {static_cast<double>(options.bake_size), {}});
  if (options.texel_density) add("texel_density", {*options.texel_density, {}});
  if (options.has_tangents) add("tangents", {true, {}});
  if (options.look != usual.look) add("look", value(kLooks[static_cast<std::size_t>(options.look)]));
  if (options.images_in != usual.images_in) {
    add("images", value(kPlaces[static_cast<std::size_t>(options.images_in)]));
  }
  if (options.image_format) {
    add("image_format", value(kFormats.at(static_cast<std::size_t>(*options.image_format))));
  }
  if (options.max_texture != usual.max_texture) {
    add("max_texture", {static_cast<double>(options.max_texture), {}});
  }
  if (options.turntable_seconds > 0) add("turntable", {options.turntable_seconds, {}});
  if (options.levels > 0) add("lod", {static_cast<double>(options.levels), {}});
  if (options.grow_seconds > 0) add("grow", {options.grow_seconds, {}});
  if (!options.copyright.empty()) add("copyright", value(options.copyright));
  if (options.is_quantized) add("quantize", {true, {}});
  if (options.position_bits) add("position_bits", {static_cast<double>(*options.position_bits), {}});
  if (options.is_packed) add("meshopt", {true, {}});
  std::string extras = R"({"sweepkit":{"scene":)" + options.scene;
  if (!members.empty()) extras += R"(,"options":)" + json_text({std::move(members), {}});
  return extras + "}}";
}

bool is_gltf_name(const std::filesystem::path& file) {
  return file.extension() == ".glb" || file.extension() == ".gltf";
}

GltfSource read_gltf_source(const std::filesystem::path& file) {
  const std::string name = file.string();
  const JsonDocument json = parse_json(split_gltf(read_whole_file(file), name).json, name);
  const std::optional<Node> extras = ObjectReader(Node(json.root, "")).find("extras");
  const std::optional<Node> own =
      extras && extras->is_object() ? ObjectReader(*extras).find("sweepkit") : std::nullopt;
  if (!own) {
    throw InputError({.file = name},
                     "does not hold the scene that it was made from; give the scene file itself");
  }
  ObjectReader reader(*own);
  GltfSource source{.scene = json_text(reader.get("scene").value())};
  if (const auto options = reader.find("options")) read_options(*options, source.options);
  reader.finish();
  return source;
}

}  // namespace sweepkit::scene
