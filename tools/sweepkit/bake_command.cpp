// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "commands.hpp"
#include "output.hpp"
#include "scene_input.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/bake_over.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/output_file.hpp"
#include "sweepkit/scene/texel_density.hpp"
#include "sweepkit/texmap/bake.hpp"
#include "sweepkit/texmap/normal_image.hpp"
#include "texel_density_option.hpp"

namespace sweepkit::tools {
namespace {

constexpr double kMostDepth = 1e6;  // metres

struct Bake {
  SceneInput input;
  Output output;
  std::string object;
  std::string size;
  std::optional<double> density;
  std::optional<double> depth;  // of a normal map
  int threads = 0;              // as many as the machine has
};

texmap::Image bake_only_object(const scene::Scene& scene, const Bake& command) {
  const scene::Object& object = scene.objects.front();
  const scene::MeshView& mesh = scene.meshes[object.mesh];
  const texmap::Texture& texture = scene.textures[*scene.materials[*object.material].texture];
  const glm::dmat3 world_from_object(object.world_from_object);
  texmap::BakeOptions options{.threads = command.threads};
  if (!command.size.empty()) {
    const PixelSize size = parse_size(command.size);
    options.width = size.width;
    options.height = size.height;
  } else {
    const glm::ivec2 size =
        scene::bake_size_of(mesh, world_from_object, texture, {.density = command.density});
    options.width = size.x;
    options.height = size.y;
  }
  texmap::BakedTexture baked = scene::bake_over(mesh, texture, options);
  if (!command.depth) return std::move(baked.image);
  const auto* procedural = std::get_if<texmap::Procedural>(&texture);
  if (procedural != nullptr && !texmap::repeats_in_unit_square(*procedural)) {
    throw InputError({.file = "--normals"},
                     "needs a texture that repeats with (u,v), an image or a procedural one on (u,v) with a "
                     "whole scale; this one is laid out over the object");
  }
  const glm::dvec2 lengths = scene::texcoord_lengths(mesh, world_from_object);
  if (!(lengths.x > 0 && lengths.y > 0)) {
    throw InputError({.file = "--normals"}, "needs a surface whose (u,v) have an area");
  }
  return texmap::normals_from_heights(baked.image,
                                      {.texel = lengths / glm::dvec2(options.width, options.height),
                                       .depth = *command.depth,
                                       .repeats_across = true,
                                       .repeats_down = true});
}

void bake(const Bake& command) {
  const auto start = std::chrono::steady_clock::now();
  const Output& output = command.output;
  const texmap::ImageFormat format = picture_format(output);
  scene::check_output(output.file);
  scene::Document document = read_scene(command.input);
  keep_object(document, command.object);
  const auto& material = document.objects.front().material;
  if (!material || !document.materials[*material].texture) {
    throw InputError(document.objects.front().place,
                     "the object \"" + command.object + "\" has no texture; give its material one");
  }
  const scene::Plan plan = scene::plan(document, {.product = scene::Request::Product::kTexture});
  const scene::Model model = scene::build(document, plan);
  const texmap::Image image = bake_only_object(model.scene, command);
  const std::vector<std::byte> bytes = texmap::encode_image(
      image, format, command.depth ? texmap::ColorSpace::kLinear : texmap::ColorSpace::kSrgb);
  scene::write_files(std::vector<scene::OutputFile>{{output.file, bytes}});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  say((output.is_standard() ? "standard output" : output.file) + ": " + std::to_string(image.width) + " x " +
          std::to_string(image.height) + " texels in " + duration_text(seconds),
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
  sub.add_option(
         "--size", command->size,
         "Texels; without it 1024 on the longer side, the other as the object's lengths along u and v "
         "ask for; strips have more along them")
      ->type_name("WxH");
  add_texel_density(sub, command->density)->excludes("--size");
  sub.add_option(
         "--normals", command->depth,
         "A normal map in place of colours: the grey value is a height, white DEPTH metres above black")
      ->type_name("DEPTH")
      ->check(CLI::Range(-kMostDepth, kMostDepth));
  sub.add_option("--threads", command->threads,
                 "Threads; without it as many as the machine has. The image is the same")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
  add_quiet(sub, command->output);
  sub.footer(
      "Example:\n  sweepkit bake samples/scenes/textures.json --object floor_tiles -o tiles.png --size "
      "512x512\n"
      "  sweepkit bake samples/scenes/textures.json --object floor_tiles -o relief.png --texel-density 200 "
      "--normals 0.004");
  sub.callback([command] { bake(*command); });
}

}  // namespace sweepkit::tools
