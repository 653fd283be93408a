// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "commands.hpp"
#include "output.hpp"
#include "scene_input.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/output_file.hpp"
#include "sweepkit/texmap/bake.hpp"

namespace sweepkit::tools {
namespace {

struct Bake {
  SceneInput input;
  Output output;
  std::string object;
  std::string size;
};

texmap::BakedTexture bake_only_object(const scene::Scene& scene, const texmap::BakeOptions& options) {
  const scene::Object& object = scene.objects.front();
  const scene::MeshView& mesh = scene.meshes[object.mesh];
  const std::vector<std::uint32_t> ends = scene::sheet_ends(mesh);
  const std::size_t texture = *scene.materials[*object.material].texture;
  return texmap::bake(scene.textures[texture],
                      {mesh.positions, mesh.texcoords, mesh.triangles, ends, mesh.origin}, options);
}

void bake(const Bake& command) {
  const auto start = std::chrono::steady_clock::now();
  const Output& output = command.output;
  const texmap::ImageFormat format = picture_format(output);
  scene::check_output(output.file);
  texmap::BakeOptions options;
  if (!command.size.empty()) {
    const PixelSize size = parse_size(command.size);
    options = {size.width, size.height};
  }
  scene::Document document = read_scene(command.input);
  keep_object(document, command.object);
  const auto& material = document.objects.front().material;
  if (!material || !document.materials[*material].texture) {
    throw InputError(document.objects.front().place,
                     "the object \"" + command.object + "\" has no texture; give its material one");
  }
  const scene::Plan plan = scene::plan(document, {.product = scene::Request::Product::kTexture});
  const scene::Model model = scene::build(document, plan);
  const texmap::BakedTexture baked = bake_only_object(model.scene, options);
  const std::vector<std::byte> bytes = texmap::encode_image(baked.image, format);
  scene::write_files(std::vector<scene::OutputFile>{{output.file, bytes}});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  say((output.is_standard() ? "standard output" : output.file) + ": " + std::to_string(baked.image.width) +
          " x " + std::to_string(baked.image.height) + " texels in " + duration_text(seconds),
      output);
}

}  // namespace

void add_bake(CLI::App& app) {
  const auto command = std::make_shared<Bake>();
  CLI::App& sub =
      *app.add_subcommand("bake", "Turn an object's texture, a procedural one too, into an image");
  add_scene_input(sub, command->input);
  sub.add_option("--object", command->object, "The object")->required()->type_name("NAME");
  add_picture_output(sub, command->output, "The image");
  sub.get_option("-o")->required();
  sub.add_option("--size", command->size, "Texels; 1024x1024 without it")->type_name("WxH");
  add_quiet(sub, command->output);
  sub.footer(
      "Example:\n  sweepkit bake samples/scenes/textures.json --object floor_tiles -o tiles.png --size "
      "512x512");
  sub.callback([command] { bake(*command); });
}

}  // namespace sweepkit::tools
