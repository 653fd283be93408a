// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "output.hpp"
#include "plan_table.hpp"
#include "scene_input.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/gltf.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/output_file.hpp"

namespace sweepkit::tools {
namespace {

constexpr int kMostTexels = 16384;  // a side: kMostPixels in all

struct Generate {
  SceneInput input;
  Output output;
  std::string object;
  scene::GltfOptions gltf;
};

void check_name(const std::string& file) {
  if (file == "-") return;
  const std::string extension = std::filesystem::path(file).extension();
  if (extension != ".glb" && extension != ".gltf") {
    throw InputError({.file = file}, "a model's name ends in .glb or .gltf");
  }
  scene::check_output(file);
}

void write(const scene::GltfFile& gltf, const std::filesystem::path& file) {
  std::vector<scene::OutputFile> files;
  for (const scene::NamedBytes& part : gltf.files) {
    const bool is_whole = &part == &gltf.files.back();
    files.push_back({is_whole ? file : file.parent_path() / part.name, part.bytes});
  }
  scene::write_files(files);
}

void generate(const Generate& command) {
  const auto start = std::chrono::steady_clock::now();
  const Output& output = command.output;
  if (output.file.empty() && !output.explains) throw InputError("-o FILE is needed (or --explain)");
  if (!output.file.empty()) check_name(output.file);

  scene::Document document = read_scene(command.input);
  if (!command.object.empty()) keep_object(document, command.object);
  const scene::Plan plan = scene::plan(document, {.product = scene::Request::Product::kMeshFile});
  if (output.file.empty()) {
    print({{}, {plan_table(plan, {})}}, output);
    return;
  }
  const scene::Model model = scene::build(document, plan);
  const scene::GltfFile gltf = scene::make_gltf(model.scene, plan, output.file, command.gltf);
  write(gltf, output.file);

  if (output.explains) {
    scene::Ledger ledger = model.ledger;
    ledger.add(gltf.ledger);
    print({{}, {plan_table(plan, ledger)}}, output);
  }
  std::size_t triangles = 0;
  for (const scene::MeshView& mesh : model.scene.meshes) triangles += mesh.triangles.size();
  std::size_t bytes = 0;
  for (const scene::NamedBytes& part : gltf.files) bytes += part.bytes.size();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  say((output.is_standard() ? "standard output" : output.file) + ": " +
          std::to_string(model.scene.objects.size()) +
          (model.scene.objects.size() == 1 ? " object, " : " objects, ") + std::to_string(triangles) +
          " triangles, " + std::to_string(bytes) + " bytes in " + duration_text(seconds),
      output);
}

}  // namespace

void add_generate(CLI::App& app) {
  const auto command = std::make_shared<Generate>();
  CLI::App& sub = *app.add_subcommand("generate", "Make the scene's objects a textured glTF file");
  add_scene_input(sub, command->input);
  sub.add_option("-o", command->output.file,
                 "Ends in .glb (all in one) or .gltf (buffer and images beside it); - is a .glb to standard "
                 "output")
      ->type_name("FILE");
  sub.add_option("--object", command->object, "This object alone")->type_name("NAME");
  sub.add_option("--bake-size", command->gltf.bake_size,
                 "Texels on a side of the image that a procedural texture becomes")
      ->capture_default_str()
      ->type_name("N")
      ->check(CLI::Range(1, kMostTexels));
  add_explain(sub, command->output);
  add_quiet(sub, command->output);
  sub.footer("Example:\n  sweepkit generate samples/scenes/vase_and_cup.json -o vase_and_cup.glb");
  sub.callback([command] { generate(*command); });
}

}  // namespace sweepkit::tools
