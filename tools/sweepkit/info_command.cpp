// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "memory.hpp"
#include "output.hpp"
#include "scene_input.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/gltf_info.hpp"
#include "sweepkit/scene/mesh_file.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/output_file.hpp"
#include "uv_report.hpp"

namespace sweepkit::tools {
namespace {

struct Info {
  std::string file;
  Output output;
  bool has_uv = false;
  std::string object;  ///< this one alone; empty: all
  std::string heat_map;
  std::string size;
  std::string measure = "aspect";
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
  if (const auto* procedural = std::get_if<texmap::Procedural>(&texture.source)) {
    return {{"texture", texture.name},
            {"kind", std::string(texmap::kProceduralNames[static_cast<std::size_t>(procedural->kind)])},
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

// Counting needs no pixels.
scene::Model build_shapes(const std::string& file, scene::Document& document) {
  require_memory(file, scene::estimate_memory(document), 0);
  limit_triangles(document, 0);
  scene::Plan plan = scene::plan(document, {.product = scene::Request::Product::kMeshFile});
  std::fill(plan.textures.begin(), plan.textures.end(), false);
  return scene::build(document, plan);
}

Report scene_report(const std::string& file) {
  scene::Document document = scene::read_document(file);
  const scene::Model model = build_shapes(file, document);

  Table objects{"objects", {}};
  Record total = {{"object", std::string("(all)")},
                  {"triangles", std::uint64_t{0}},
                  {"vertices", std::uint64_t{0}},
                  {"deviation", {}},
                  {"material", {}},
                  {"instances", std::uint64_t{model.scene.objects.size()}}};
  auto next = model.scene.objects.begin();
  for (const scene::ObjectEntry& entry : document.objects) {
    const scene::Object& object = *next;
    const std::size_t instances = std::max(entry.instances.size(), std::size_t{1});
    next += static_cast<std::ptrdiff_t>(instances);
    const scene::MeshView& mesh = model.scene.meshes[object.mesh];
    const std::optional<double> deviation = scene::deviation_of(model, object);
    objects.rows.push_back(
        {{"object", object.name},
         {"triangles", std::uint64_t{mesh.triangles.size()}},
         {"vertices", std::uint64_t{mesh.positions.size()}},
         {"deviation", deviation ? Value(*deviation) : Value()},
         {"material", object.material ? Value(document.materials[*object.material].name) : Value()},
         {"instances", std::uint64_t{instances}}});
    std::get<std::uint64_t>(total[1].second) += mesh.triangles.size();
    std::get<std::uint64_t>(total[2].second) += mesh.positions.size();
  }
  Table materials{"materials", {}};
  for (const scene::Material& material : document.materials) {
    materials.rows.push_back({{"material", material.name},
                              {"texture", texture_name(document, material)},
                              {"reflect", as_written(material.reflect)},
                              {"transmit", as_written(material.transmit)},
                              {"ior", as_written(material.ior)}});
  }
  Table textures{"textures", {}};
  for (const scene::TextureEntry& texture : document.textures) textures.rows.push_back(texture_row(texture));
  if (document.environment) textures.rows.push_back(texture_row(*document.environment));
  return {{{"file", file},
           {"kind", std::string("scene")},
           {"width", static_cast<std::uint64_t>(document.width)},
           {"height", static_cast<std::uint64_t>(document.height)},
           {"lights", std::uint64_t{document.lights.size()}},
           {"triangles", total[1].second},
           {"vertices", total[2].second}},
          {objects, materials, textures}};
}

Report mesh_report(const std::string& file) {
  const scene::MeshFile mesh = scene::read_mesh_file(file);
  Table bounds{"bounds", {}};
  glm::dvec3 low = mesh.positions.front();
  glm::dvec3 high = low;
  for (const glm::dvec3& p : mesh.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  for (glm::length_t k = 0; k < 3; ++k) {
    bounds.rows.push_back(
        {{"axis", std::string(1, "xyz"[k])}, {"from", low[k]}, {"to", high[k]}, {"size", high[k] - low[k]}});
  }
  return {{{"file", file},
           {"kind", "mesh, " + mesh.format},
           {"bytes", std::uint64_t{mesh.bytes}},
           {"places", std::uint64_t{mesh.positions.size()}},
           {"polygons", std::uint64_t{mesh.polygons}},
           {"triangles", std::uint64_t{mesh.triangles.size()}},
           {"left out", std::uint64_t{mesh.degenerate}},
           {"uv", !mesh.texcoords.empty()},
           {"normals", !mesh.normals.empty()}},
          {bounds}};
}

// A mesh file as the only object of a scene, named for it.
scene::Document mesh_document(const std::filesystem::path& file) {
  scene::ObjectEntry object;
  object.name = file.stem().string();
  object.pieces.push_back({.shape = scene::MeshShape{file}});
  scene::Document document;
  document.objects.push_back(std::move(object));
  return document;
}

Report uv_report(const Info& command, const std::string& extension) {
  HeatMapRequest heat_map{
      .file = command.heat_map,
      .measure = command.measure == "aspect" ? HeatMeasure::kAspectRatio : HeatMeasure::kHomogeneity};
  if (!command.size.empty()) heat_map.size = parse_size(command.size);
  if (!heat_map.file.empty()) {
    texmap::image_format(heat_map.file);
    scene::check_output(heat_map.file);
  }
  scene::Document document =
      extension == ".json" ? scene::read_document(command.file) : mesh_document(command.file);
  if (!command.object.empty()) keep_object(document, command.object);
  if (!heat_map.file.empty() && document.objects.size() > 1) {
    throw InputError({.file = "--heat-map"}, "is of one object, and the scene has " +
                                                 std::to_string(document.objects.size()) +
                                                 "; say which with --object");
  }
  const scene::Model model = build_shapes(command.file, document);
  if (!heat_map.file.empty()) write_heat_map(model.scene, heat_map, command.output);
  return {{{"file", command.file}}, {uv_table(model.scene), centroid_table(model.scene)}};
}

Report gltf_report(const std::string& file) {
  const scene::GltfInfo info = scene::read_gltf_info(file);
  Table meshes{"meshes", {}};
  for (const scene::GltfInfo::Mesh& mesh : info.meshes) {
    meshes.rows.push_back({{"mesh", or_nothing(mesh.name)},
                           {"triangles", mesh.triangles},
                           {"vertices", mesh.vertices},
                           {"material", or_nothing(mesh.material)},
                           {"targets", mesh.targets},
                           {"vertex bytes", mesh.vertex_bytes},
                           {"index bytes", mesh.index_bytes}});
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
                           {"file", or_nothing(image.file)},
                           {"format", or_nothing(image.format)},
                           {"missing", image.is_missing}});
  }
  Table textures{"textures", {}};
  for (const scene::GltfInfo::Texture& texture : info.textures) {
    textures.rows.push_back({{"texture", or_nothing(texture.name)}, {"image", or_nothing(texture.image)}});
  }
  Table cameras{"cameras", {}};
  for (const scene::GltfInfo::Camera& camera : info.cameras) {
    cameras.rows.push_back({{"camera", or_nothing(camera.name)}, {"type", camera.type}});
  }
  Table lights{"lights", {}};
  for (const scene::GltfInfo::Light& light : info.lights) {
    lights.rows.push_back(
        {{"light", or_nothing(light.name)}, {"type", light.type}, {"intensity", light.intensity}});
  }
  Table animations{"animations", {}};
  for (const scene::GltfInfo::Animation& animation : info.animations) {
    animations.rows.push_back({{"animation", or_nothing(animation.name)},
                               {"seconds", animation.seconds},
                               {"channels", animation.channels}});
  }
  Table buffers{"buffers", {}};
  for (const scene::GltfInfo::Buffer& buffer : info.buffers) {
    buffers.rows.push_back({{"buffer", static_cast<std::uint64_t>(buffers.rows.size())},
                            {"bytes", buffer.bytes},
                            {"file", or_nothing(buffer.file)},
                            {"missing", buffer.is_missing}});
  }
  Table extensions{"extensions", {}};
  for (const std::string& name : info.extensions_used) {
    const std::vector<std::string>& required = info.extensions_required;
    extensions.rows.push_back(
        {{"extension", name},
         {"required", std::find(required.begin(), required.end(), name) != required.end()}});
  }
  Table packed{"meshopt", {}};
  if (info.packed.views > 0) {
    packed.rows.push_back({{"views", info.packed.views},
                           {"bytes", info.packed.bytes},
                           {"unpacked bytes", info.packed.unpacked_bytes}});
  }
  return {{{"file", file},
           {"kind", std::string("glTF 2.0")},
           {"generator", or_nothing(info.generator)},
           {"copyright", or_nothing(info.copyright)},
           {"holds its scene", info.has_scene},
           {"bytes", info.bytes}},
          {meshes, materials, images, textures, cameras, lights, animations, buffers, extensions, packed}};
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
  const bool is_mesh = scene::is_mesh_name(command.file);
  if (command.has_uv) {
    if (extension != ".json" && !is_mesh) {
      throw InputError({.file = command.file},
                       "--uv tells of a scene (.json) or a mesh (.obj, .ply, .stl, .off)");
    }
    print(uv_report(command, extension), command.output);
  } else if (is_mesh) {
    print(mesh_report(command.file), command.output);
  } else if (extension == ".json") {
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
  CLI::App& sub = *app.add_subcommand("info", "Tell what is in a scene, mesh, glTF or image file");
  sub.add_option("FILE", command->file,
                 "Scene (.json), mesh (.obj, .ply, .stl, .off), glTF (.glb, .gltf) or image file")
      ->required()
      ->type_name("");
  sub.add_flag("--json", command->output.is_json, "As JSON");
  CLI::Option* uv = sub.add_flag("--uv", command->has_uv,
                                 "Of a scene or mesh: how the texture lies on each object, as told below");
  sub.add_option("--object", command->object, "With --uv: this object alone")->type_name("NAME")->needs(uv);
  CLI::Option* heat_map =
      sub.add_option("--heat-map", command->heat_map,
                     "With --uv: draw where one object's texture is distorted, as a texture for it; ends in "
                     ".png, .jpg, .tif or .exr")
          ->type_name("FILE")
          ->needs(uv);
  sub.add_option("--measure", command->measure,
                 "What the heat map shows: the aspect ratio, or the resolution against its mean")
      ->capture_default_str()
      ->check(CLI::IsMember({"aspect", "homogeneity"}))
      ->needs(heat_map);
  sub.add_option("--size", command->size, "Texels of the heat map; 1024x1024 without it")
      ->type_name("WxH")
      ->needs(heat_map);
  add_quiet(sub, command->output);
  sub.footer(
      "The table of --uv, all of it in the world; ratios are 1 at best, a share is from 0 to 1:\n"
      "  homogeneity u, v  the largest arc on the surface over the smallest for a step along that axis\n"
      "                    of the texture; 95%: between the shares 0.025 and 0.975 of the area\n"
      "  aspect            the larger over the smaller arc of two perpendicular steps: mean, median and\n"
      "                    95% by area, and the worst triangle's\n"
      "  density 95%       texels a square metre where they are many over where they are few\n"
      "  continuous        share of the inner edges with the same (u,v) on both sides\n"
      "  overlap           share of the covered texture that more than one triangle covers\n"
      "  degenerate        triangles without area in (u,v), in none of the ratios\n"
      "  mirrored          triangles on which the texture is mirrored\n\n"
      "Examples:\n  sweepkit info samples/scenes/vase_and_cup.json\n"
      "  sweepkit info samples/meshes/knot.obj\n"
      "  sweepkit info samples/scenes/vase_and_cup.json --uv --object vase --heat-map vase.png");
  sub.callback([command] { inform(*command); });
}

}  // namespace sweepkit::tools
