// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <span>

#include "commands.hpp"
#include "findings.hpp"
#include "memory.hpp"
#include "output.hpp"
#include "plan_table.hpp"
#include "progress.hpp"
#include "scene_input.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/render/render.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/output_file.hpp"

namespace sweepkit::tools {
namespace {

constexpr int kDeepest = 64;  // as the scene's "depth" has it

const std::map<std::string, render::Accelerator> kAccelerators = {
    {"seads", render::Accelerator::kSeads},   {"sweep", render::Accelerator::kSweep},
    {"linear", render::Accelerator::kLinear}, {"embree", render::Accelerator::kEmbree},
    {"auto", render::Accelerator::kAuto},
};

struct Render {
  SceneInput input;
  Output output;
  render::Options options;
  std::string size;
  std::string filter{texmap::filter_name(render::Options{}.filter)};
  std::string footprint = "auto";
  std::string antialias = "off";
  std::string accelerator = "auto";
  std::string statistics;  // a file
  std::size_t texture_megabytes = texmap::kDefaultTextureMemory >> 20;
  int depth = -1;  // the scene's
};

void check_names(const Render& command) {
  const Output& output = command.output;
  if (output.file.empty()) {
    if (!output.explains) throw InputError("-o FILE is needed (or --explain)");
    if (!command.statistics.empty()) throw InputError("--stats needs -o FILE");
    return;
  }
  picture_format(output);
  scene::check_output(output.file);
  if (command.statistics.empty()) return;
  if (command.statistics == output.file) {
    throw InputError({.file = "--stats"}, "needs another file than -o, got \"" + output.file + "\" for both");
  }
  scene::check_output(command.statistics);
}

scene::Document read_document(const Render& command) {
  scene::Document document = read_scene(command.input);
  if (!command.size.empty()) {
    const PixelSize size = parse_size(command.size);
    document.width = size.width;
    document.height = size.height;
  }
  if (std::int64_t{document.width} * document.height > kMostPixels) {
    throw InputError({.file = command.input.name(), .pointer = "/camera"},
                     "needs at most 2^28 pixels, got " + std::to_string(document.width) + " x " +
                         std::to_string(document.height) + "; give a smaller --size");
  }
  if (command.depth >= 0) document.depth = command.depth;
  return document;
}

// What image textures may hold, as far as their files tell: a file that cannot be read is told of when it is.
std::uint64_t texture_bytes(const scene::Document& document, const scene::Plan& plan) {
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < document.textures.size(); ++i) {
    if (!plan.sampled[i]) continue;
    try {
      const texmap::ImageFileInfo info =
          texmap::read_image_info(std::get<scene::ImageEntry>(document.textures[i].source).file);
      constexpr std::uint64_t kBytesATexel = 8;  // a tile's
      bytes +=
          kBytesATexel * static_cast<std::uint64_t>(info.width) * static_cast<std::uint64_t>(info.height);
    } catch (const InputError&) {
    }
  }
  return std::min<std::uint64_t>(bytes, plan.texture_memory);
}

// Refuses a scene that there is no memory for: before it is built what its counts of cells say, and while it
// is built what a tolerance has come to.
scene::Model build(const Render& command, scene::Document& document, const scene::Plan& plan) {
  scene::MemoryEstimate needed = scene::estimate_memory(document);
  const auto require = [&] {
    require_memory(command.input.name(), needed,
                   render::estimate_memory(needed, document.width, document.height, command.options) +
                       texture_bytes(document, plan));
  };
  require();
  limit_triangles(document, render::bytes_a_triangle(command.options.accelerator));
  scene::Model model = scene::build(document, plan);
  needed = {.objects = model.scene.objects.size()};
  for (const scene::MeshView& mesh : model.scene.meshes) needed.triangles += mesh.triangles.size();
  require();
  return model;
}

Report statistics_report(const render::Statistics& statistics, const scene::Plan& plan,
                         const scene::Ledger& ledger) {
  return {{{"eye_rays", statistics.eye_rays},
           {"reflected_rays", statistics.reflected_rays},
           {"refracted_rays", statistics.refracted_rays},
           {"shadow_rays", statistics.shadow_rays},
           {"nodes", statistics.nodes},
           {"textured_nodes", statistics.textured_nodes},
           {"filtered_nodes", statistics.filtered_nodes},
           {"differential_nodes", statistics.differential_nodes},
           {"build_seconds", statistics.build_seconds},
           {"picture_seconds", statistics.picture_seconds},
           {"shade_thread_seconds", statistics.shade_thread_seconds},
           {"accelerator_bytes", statistics.accelerator_bytes},
           {"voxels", statistics.voxels},
           {"median_triangles", std::uint64_t{statistics.median_triangles}},
           {"p99_triangles", std::uint64_t{statistics.p99_triangles}},
           {"max_triangles", std::uint64_t{statistics.max_triangles}}},
          {plan_table(plan, ledger)}};
}

void draw(Render& command) {
  const auto start = std::chrono::steady_clock::now();
  const Output& output = command.output;
  check_names(command);
  command.options.filter = static_cast<texmap::Filter>(
      std::ranges::find(texmap::kFilterNames, command.filter) - texmap::kFilterNames.begin());
  command.options.footprint = command.footprint == "neighbours"      ? render::Footprint::kNeighbours
                              : command.footprint == "differentials" ? render::Footprint::kDifferentials
                                                                     : render::Footprint::kAuto;
  command.options.supersampling = command.antialias == "3x3" ? 3 : 1;

  command.options.accelerator = kAccelerators.at(command.accelerator);
  if (command.options.accelerator == render::Accelerator::kEmbree && !render::has_embree()) {
    throw InputError({.file = "--accelerator"},
                     "embree is not in this build; install Embree 3 (Debian: libembree-dev) and build again, "
                     "or leave it to auto");
  }

  scene::Document document = read_document(command);
  const scene::Plan plan = scene::plan(document, {.product = scene::Request::Product::kPicture,
                                                  .filter = command.options.filter,
                                                  .texture_memory = command.texture_megabytes << 20,
                                                  .is_supersampled = command.options.supersampling > 1,
                                                  .has_neighbours = command.footprint != "differentials",
                                                  .has_differentials = command.footprint != "neighbours"});
  if (output.file.empty()) {
    print({{}, {plan_table(plan, {})}}, output);
    return;
  }
  const scene::Model model = build(command, document, plan);
  if (!output.is_quiet) warn(scene::check(document, model, scene::Thoroughness::kQuick), output);
  const render::Picture picture = [&] {
    Progress progress(output.is_quiet);
    command.options.on_progress = progress.callback();
    return render::render(model.scene, plan, command.options);
  }();
  scene::Ledger ledger = model.ledger;
  ledger.add(picture.ledger);

  const std::vector<std::byte> bytes = texmap::encode_image(picture.image, picture_format(output));
  std::vector<scene::OutputFile> files = {{output.file, bytes}};
  const std::string statistics =
      command.statistics.empty() ? "" : to_json(statistics_report(picture.statistics, plan, ledger));
  if (!command.statistics.empty()) {
    files.push_back({command.statistics, std::as_bytes(std::span(statistics))});
  }
  scene::write_files(files);

  if (output.explains) print({{}, {plan_table(plan, ledger)}}, output);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  say((output.is_standard() ? "standard output" : output.file) + ": " + std::to_string(document.width) +
          " x " + std::to_string(document.height) + " pixels in " + duration_text(seconds),
      output);
}

}  // namespace

void add_render(CLI::App& app) {
  const auto command = std::make_shared<Render>();
  CLI::App& sub = *app.add_subcommand("render", "Draw the scene as a picture by ray tracing");
  add_scene_input(sub, command->input);
  add_picture_output(sub, command->output, "The picture");
  sub.add_option("--size", command->size, "Pixels, instead of the scene's")->type_name("WxH");
  sub.add_option("--filter", command->filter,
                 "How image textures are looked up; ewa is the elliptical average; auto is bilinear where a "
                 "texture is magnified and elsewhere ewa, from coarser copies the longer the footprint; "
                 "integral-1, -2 and -3 average one, two or three boxes convolved, by tables of sums: the "
                 "paper's way")
      ->capture_default_str()
      ->check(
          CLI::IsMember(std::vector<std::string>(texmap::kFilterNames.begin(), texmap::kFilterNames.end())));
  sub.add_option(
         "--footprint", command->footprint,
         "What the filter covers: auto, a pixel, by the next neighbours, and by the ray's derivatives "
         "where there are none; differentials, by those alone; neighbours, as the paper has it, only "
         "where all eight hit the same surface, and integral-1, -2 and -3 take their box, two pixels wide, "
         "as all that they cover")
      ->capture_default_str()
      ->check(CLI::IsMember({"neighbours", "differentials", "auto"}));
  sub.add_option("--antialias", command->antialias, "3x3: nine eye rays a pixel, weighted")
      ->capture_default_str()
      ->check(CLI::IsMember({"off", "3x3"}));
  sub.add_option(
         "--accelerator", command->accelerator,
         "How the triangles that rays meet are found: seads, the paper's grids; sweep, boxes over the blocks "
         "of a sweep's own grid; embree, Intel's tree, "
         "where this build has it: a few pixels may differ; linear, all of them in turn; auto, the "
         "fastest of ours. The picture is the same with any of ours")
      ->capture_default_str()
      ->check(CLI::IsMember({"seads", "sweep", "linear", "embree", "auto"}));
  sub.add_option("--depth", command->depth, "Levels of reflection and refraction, instead of the scene's")
      ->type_name("N")
      ->check(CLI::Range(0, kDeepest));
  sub.add_option(
         "--texture-memory", command->texture_megabytes,
         "What image textures may fill of the memory; larger ones are read piece by piece. The picture is "
         "the same")
      ->type_name("MB")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{16}, std::size_t{1} << 20));
  sub.add_option("--threads", command->options.threads,
                 "Threads; without it as many as the machine has. The picture is the same")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
  sub.add_option("--stats", command->statistics, "Write counters, times and the plan as JSON")
      ->type_name("FILE");
  add_explain(sub, command->output);
  add_json(sub, command->output, "Print the table of --explain as JSON")->needs(sub.get_option("--explain"));
  add_quiet(sub, command->output);
  sub.footer(
      "Examples:\n"
      "  sweepkit render samples/scenes/vase_and_cup.json -o vase_and_cup.png --antialias 3x3\n"
      "  sweepkit render --contour star:5,0.3,0.18 --trajectory line:0,0,0,0,1.5,0 --twist 120 -o "
      "column.png");
  sub.callback([command] { draw(*command); });
}

}  // namespace sweepkit::tools
