// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "output.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/gltf_info.hpp"
#include "sweepkit/scene/model.hpp"

namespace sweepkit::tools {
namespace {

struct Info {
  std::string file;
  Output output;
};

Value or_nothing(const std::string& text) {
  return text.empty() ? Value() : Value(text);
}

// As it stood in the file: 0.22 and not 0.2199999988079071.
double as_written(float value) {
  return std::round(1e6 * static_cast<double>(value)) / 1e6;
}

Value texture_name(const scene::Document& document, const scene::Material& material) {
  return material.texture ? Value(document.textures[*material.texture].name) : Value();
}

Record texture_row(const scene::TextureEntry& texture) {
  static constexpr const char* kKinds[] = {"checker", "tiles", "bands", "marble"};
  if (const auto* procedural = std::get_if<texmap::Procedural>(&texture.source)) {
    return {{"texture", texture.name},
            {"kind", std::string(kKinds[static_cast<std::size_t>(procedural->kind)])},
            {"width", {}},
            {"height", {}},
            {"file", {}}};
  }
  const std::filesystem::path& file = std::get<scene::ImageEntry>(texture.source).file;
  texmap::ImageFileInfo image;
  try {
    image = texmap::read_image_info(file);
  } catch (const InputError& error) {
    throw InputError(texture.place, error.what());
  }
  return {{"texture", texture.name},
          {"kind", std::string("image")},
          {"width", static_cast<std::uint64_t>(image.width)},
          {"height", static_cast<std::uint64_t>(image.height)},
          {"file", file.lexically_normal().string()}};
}

Report scene_report(const std::string& file) {
  scene::Document document = scene::read_document(file);
  scene::Plan plan = scene::plan(document, {.product = scene::Request::Product::kMeshFile});
  std::fill(plan.textures.begin(), plan.textures.end(), false);  // counting needs no pixels
  const scene::Model model = scene::build(document, plan);

  Table objects{"objects", {}};
  Record total = {{"object", std::string("(all)")},
                  {"triangles", std::uint64_t{0}},
                  {"vertices", std::uint64_t{0}},
                  {"deviation", {}},
                  {"material", {}}};
  for (const scene::Object& object : model.scene.objects) {
    const scene::MeshView& mesh = model.scene.meshes[object.mesh];
    const std::optional<double> deviation = scene::deviation_of(model, object);
    objects.rows.push_back(
        {{"object", object.name},
         {"triangles", std::uint64_t{mesh.triangles.size()}},
         {"vertices", std::uint64_t{mesh.positions.size()}},
         {"deviation", deviation ? Value(*deviation) : Value()},
         {"material", object.material ? Value(document.materials[*object.material].name) : Value()}});
    std::get<std::uint64_t>(total[1].second) += mesh.triangles.size();
    std::get<std::uint64_t>(total[2].second) += mesh.positions.size();
  }
  Table materials{"materials", {}};
  for (const scene::Material& material : document.materials) {
    materials.rows.push_back({{"material", material.name},
                              {"texture", texture_name(document, material)},
                              {"reflect", as_written(material.reflect)}});
  }
  Table textures{"textures", {}};
  for (const scene::TextureEntry& texture : document.textures) textures.rows.push_back(texture_row(texture));
  return {{{"file", file},
           {"kind", std::string("scene")},
           {"width", static_cast<std::uint64_t>(document.width)},
           {"height", static_cast<std::uint64_t>(document.height)},
           {"lights", std::uint64_t{document.lights.size()}},
           {"triangles", total[1].second},
           {"vertices", total[2].second}},
          {objects, materials, textures}};
}

Report gltf_report(const std::string& file) {
  const scene::GltfInfo info = scene::read_gltf_info(file);
  Table meshes{"meshes", {}};
  for (const scene::GltfInfo::Mesh& mesh : info.meshes) {
    meshes.rows.push_back({{"mesh", or_nothing(mesh.name)},
                           {"triangles", mesh.triangles},
                           {"vertices", mesh.vertices},
                           {"material", or_nothing(mesh.material)}});
  }
  Table materials{"materials", {}};
  for (const scene::GltfInfo::Material& material : info.materials) {
    materials.rows.push_back({{"material", or_nothing(material.name)}, {"textured", material.is_textured}});
  }
  Table images{"images", {}};
  for (const scene::GltfInfo::Image& image : info.images) {
    const bool has_size = image.width > 0 && image.height > 0;
    images.rows.push_back({{"image", or_nothing(image.name)},
                           {"width", has_size ? Value(static_cast<std::uint64_t>(image.width)) : Value()},
                           {"height", has_size ? Value(static_cast<std::uint64_t>(image.height)) : Value()},
                           {"bytes", image.bytes},
                           {"file", or_nothing(image.file)}});
  }
  return {{{"file", file},
           {"kind", std::string("glTF 2.0")},
           {"generator", or_nothing(info.generator)},
           {"bytes", info.bytes}},
          {meshes, materials, images}};
}

Report image_report(const std::string& file) {
  const texmap::ImageFileInfo image = texmap::read_image_info(file);
  return {{{"file", file},
           {"kind", "image, " + image.format},
           {"width", static_cast<std::uint64_t>(image.width)},
           {"height", static_cast<std::uint64_t>(image.height)},
           {"channels", static_cast<std::uint64_t>(image.channels)},
           {"samples", image.sample_type}},
          {}};
}

void inform(const Info& command) {
  const std::string extension = std::filesystem::path(command.file).extension();
  if (extension == ".json") {
    print(scene_report(command.file), command.output);
  } else if (extension == ".glb" || extension == ".gltf") {
    print(gltf_report(command.file), command.output);
  } else {
    print(image_report(command.file), command.output);
  }
}

}  // namespace

void add_info(CLI::App& app) {
  const auto command = std::make_shared<Info>();
  CLI::App& sub = *app.add_subcommand("info", "Tell what is in a scene, glTF or image file");
  sub.add_option("FILE", command->file, "Scene (.json), glTF (.glb, .gltf) or image file")
      ->required()
      ->type_name("");
  sub.add_flag("--json", command->output.is_json, "As JSON");
  sub.footer("Example:\n  sweepkit info samples/scenes/vase_and_cup.json");
  sub.callback([command] { inform(*command); });
}

}  // namespace sweepkit::tools
