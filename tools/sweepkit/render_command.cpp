// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <span>

#include "commands.hpp"
#include "findings.hpp"
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

struct Render {
  SceneInput input;
  Output output;
  render::Options options;
  std::string size;
  std::string filter{texmap::filter_name(render::Options{}.filter)};
  std::string footprint = "auto";
  std::string antialias = "off";
  std::string shadows = "smooth";
  render::Adaptive adaptive;
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

Report statistics_report(const render::Statistics& statistics, const scene::Plan& plan,
                         const scene::Ledger& ledger) {
  return {{{"eye_rays", statistics.eye_rays},
           {"refined_pixels", statistics.refined_pixels},
           {"refining_rays", statistics.refining_rays},
           {"reflected_rays", statistics.reflected_rays},
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
  if (command.antialias == "adaptive") command.options.adaptive = command.adaptive;
  command.options.shadows = command.shadows == "hard" ? render::Shadows::kHard : render::Shadows::kSmooth;

  const scene::Document document = read_document(command);
  const scene::Plan plan = scene::plan(document, {.product = scene::Request::Product::kPicture,
                                                  .filter = command.options.filter,
                                                  .texture_memory = command.texture_megabytes << 20,
                                                  .is_supersampled = command.options.supersampling > 1,
                                                  .is_refined = command.options.adaptive.has_value(),
                                                  .has_smooth_shadows = command.shadows == "smooth",
                                                  .has_neighbours = command.footprint != "differentials",
                                                  .has_differentials = command.footprint != "neighbours"});
  if (output.file.empty()) {
    print({{}, {plan_table(plan, {})}}, output);
    return;
  }
  const scene::Model model = scene::build(document, plan);
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
                 "paper's way; box is the mean under the pixel itself")
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
  sub.add_option(
         "--antialias", command->antialias,
         "3x3: nine eye rays a pixel, weighted; adaptive: more rays only where a pixel differs from its "
         "neighbours, averaged over the pixel, its textures too (--filter auto then is box)")
      ->capture_default_str()
      ->check(CLI::IsMember({"off", "3x3", "adaptive"}));
  sub.add_option(
         "--antialias-contrast", command->adaptive.contrast,
         "For adaptive: the difference from a neighbour, in linear light from 0 to 1, that asks for more "
         "rays; it also says when they are enough")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 1.0));
  sub.add_option("--antialias-rays", command->adaptive.most_rays,
                 "For adaptive: the most rays more in a pixel")
      ->type_name("N")
      ->capture_default_str()
      ->check(CLI::Range(render::kFewestRefiningRays, render::kMostRefiningRays));
  sub.add_option(
         "--shadows", command->shadows,
         "What a light without a radius throws: hard edges, or smooth ones, by averaging its shadow rays "
         "over the neighbouring pixels")
      ->capture_default_str()
      ->check(CLI::IsMember({"hard", "smooth"}));
  sub.add_option("--depth", command->depth, "Levels of reflection, instead of the scene's")
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
      "  sweepkit render samples/scenes/vase_and_cup.json -o vase_and_cup.png --antialias adaptive\n"
      "  sweepkit render --contour star:5,0.3,0.18 --trajectory line:0,0,0,0,1.5,0 --twist 120 -o "
      "column.png");
  sub.callback([command] { draw(*command); });
}

}  // namespace sweepkit::tools
