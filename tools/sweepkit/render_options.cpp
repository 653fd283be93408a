// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

#include "commands.hpp"
#include "render.hpp"

namespace sweepkit::tools {
namespace {

constexpr int kDeepest = 64;  // as the scene's "depth" has it

void add_part_options(CLI::App& sub, Render& command) {
  sub.add_option("--crop", command.crop, "Draw this part alone; EXR files keep its place in the picture")
      ->type_name("X,Y,W,H");
  sub.add_option("--tile", command.tile,
                 "Draw part I of 1 to N: bands of rows from the top, which sweepkit assemble puts together")
      ->type_name("I/N");
  CLI::Option* frames =
      sub.add_option("--frames", command.frames,
                     "Draw a turntable: for frame k of n the camera is carried round its target about +Y by "
                     "360 k/n degrees; such as 1-120, 1-120:2 (every other), 3,5-10. -o has {frame} in its "
                     "name, or {frame:04} with so many digits")
          ->type_name("LIST");
  sub.add_option("--frames-per-turn", command.frames_per_turn,
                 "The n of a full turn; without it the largest number in LIST, and one more where LIST has "
                 "frame 0")
      ->type_name("N")
      ->check(CLI::Range(1, kLastFrame))
      ->needs(frames);
  sub.add_flag("--skip-existing", command.skips_existing,
               "Leave files as they are that were drawn from the same scene, files it names, options and "
               "program, by what they say of themselves");
  sub.add_flag("--progressive", command.is_progressive,
               "Write the file early and again: with one ray for each 8 x 8 pixels, 4 x 4, 2 x 2, then the "
               "picture itself");
}

void add_picture_options(CLI::App& sub, Render& command) {
  sub.add_option("--bits", command.bits,
                 "Bits a sample: 8 or 16 for .png and .tif, 8 for .jpg, 16 (half) or 32 (float) for .exr; "
                 "8 without it, for .exr 16")
      ->type_name("N")
      ->check(CLI::IsMember({8, 16, 32}));
  sub.add_option("--exposure", command.exposure, "Stops: light is doubled so many times, or halved")
      ->type_name("EV")
      ->capture_default_str();
  sub.add_flag("--alpha", command.options.has_alpha,
               "Leave the background out where nothing stands before it, and write what is covered as alpha; "
               "not for .jpg");
  std::string kinds = "Write these too, of what the ray through a pixel's middle meets, apart by commas: ";
  std::vector<std::string> names;
  names.reserve(render::kLayerCount);
  for (std::size_t i = 0; i < render::kLayerCount; ++i) {
    const render::LayerKind& kind = render::kind_of(static_cast<render::Layer>(i));
    kinds += (i == 0 ? "" : ", ") + std::string(kind.name) + " (" + std::string(kind.meaning) + ")";
    names.emplace_back(kind.name);
  }
  sub.add_option("--aov", command.layers,
                 kinds + ". As layers of an .exr file, else as files beside it: vase.depth.exr for vase.png")
      ->type_name("NAMES")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(names));
}

void add_method_options(CLI::App& sub, Render& command) {
  sub.add_option("--filter", command.filter,
                 "How image textures are looked up; ewa is the elliptical average; auto is bilinear where a "
                 "texture is magnified and elsewhere ewa, from coarser copies the longer the footprint; "
                 "integral-1, -2 and -3 average one, two or three boxes convolved, by tables of sums: the "
                 "paper's way; box is the mean under the pixel itself")
      ->capture_default_str()
      ->check(
          CLI::IsMember(std::vector<std::string>(texmap::kFilterNames.begin(), texmap::kFilterNames.end())));
  sub.add_option(
         "--footprint", command.footprint,
         "What the filter covers: auto, a pixel, by the next neighbours, and by the ray's derivatives "
         "where there are none; differentials, by those alone; neighbours, as the paper has it, only "
         "where all eight hit the same surface, and integral-1, -2 and -3 take their box, two pixels wide, "
         "as all that they cover")
      ->capture_default_str()
      ->check(CLI::IsMember({"neighbours", "differentials", "auto"}));
  sub.add_option(
         "--antialias", command.antialias,
         "3x3: nine eye rays a pixel, weighted; adaptive: more rays only where a pixel differs from its "
         "neighbours, averaged over the pixel, its textures too (--filter auto then is box)")
      ->capture_default_str()
      ->check(CLI::IsMember({"off", "3x3", "adaptive"}));
  sub.add_option(
         "--antialias-contrast", command.adaptive.contrast,
         "For adaptive: the difference from a neighbour, in linear light from 0 to 1, that asks for more "
         "rays; it also says when they are enough")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 1.0));
  sub.add_option("--antialias-rays", command.adaptive.most_rays,
                 "For adaptive: the most rays more in a pixel")
      ->type_name("N")
      ->capture_default_str()
      ->check(CLI::Range(render::kFewestRefiningRays, render::kMostRefiningRays));
  sub.add_option("--error", command.most_error,
                 "Choose the antialiasing: one eye ray a pixel, and more where they help most, until the "
                 "picture's error, estimated, is at most this: root mean square of R, G and B, linear light "
                 "from 0 to 1")
      ->type_name("E")
      ->check(CLI::Range(1e-6, 1.0));
  sub.add_option(
         "--time", command.most_seconds,
         "Choose the antialiasing: the same, as far as it goes in so many seconds of the program, all "
         "told. The picture is another from run to run")
      ->type_name("SECONDS")
      ->check(CLI::Range(1e-3, 1e6));
  sub.add_option(
         "--shadows", command.shadows,
         "What a light without a radius throws: hard edges, or smooth ones, by averaging its shadow rays "
         "over the neighbouring pixels")
      ->capture_default_str()
      ->check(CLI::IsMember({"hard", "smooth"}));
  sub.add_option("--accelerator", command.accelerator,
                 "How the triangles that rays meet are found: seads, the paper's grids; sweep, boxes over "
                 "blocks of a "
                 "sweep's own grid; linear, all of them in turn; embree, Intel's tree, where this build has "
                 "it: a few "
                 "pixels may differ; auto, the fastest of ours. The picture is the same with any of ours")
      ->capture_default_str()
      ->check(CLI::IsMember(
          std::vector<std::string>(render::kAcceleratorNames.begin(), render::kAcceleratorNames.end())));
  sub.add_option("--depth", command.depth, "Levels of reflection and refraction, instead of the scene's")
      ->type_name("N")
      ->check(CLI::Range(0, kDeepest));
  sub.add_option(
         "--texture-memory", command.texture_megabytes,
         "What image textures may fill of the memory; larger ones are read piece by piece. The picture is "
         "the same")
      ->type_name("MB")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{16}, std::size_t{1} << 20));
  sub.add_option("--threads", command.options.threads,
                 "Threads; without it as many as the machine has. The picture is the same")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
}

}  // namespace

void add_render_options(CLI::App& sub, Render& command) {
  add_scene_input(sub, command.input);
  command.input.curves.has_studio = true;
  add_picture_output(sub, command.output, "The picture");
  sub.add_option("--size", command.size, "Pixels, instead of the scene's")->type_name("WxH");
  add_picture_options(sub, command);
  add_part_options(sub, command);
  add_method_options(sub, command);
  sub.add_option(
         "--stats", command.statistics,
         "Write counters, times and memory by phase, the plan, and an estimate of the picture's error as "
         "JSON")
      ->type_name("FILE");
  add_explain(sub, command.output);
  sub.add_flag(
      "--no-leave-out", command.leaves_nothing_out,
      "Switch on every part that the picture can do without; it is the same, and --explain and --stats tell "
      "what leaving out saves");
  add_json(sub, command.output, "Print the table of --explain as JSON")->needs(sub.get_option("--explain"));
  add_quiet(sub, command.output);
  sub.footer(
      "Examples:\n"
      "  sweepkit render samples/scenes/vase_and_cup.json -o vase_and_cup.png --antialias adaptive\n"
      "  sweepkit render --contour star:5,0.3,0.18 --trajectory line:0,0,0,0,1.5,0 --twist 120 -o "
      "column.png\n"
      "  sweepkit render samples/scenes/spring.json -o spring.exr --size 128x128 --alpha --aov "
      "depth,normal,object-id\n"
      "  sweepkit render samples/scenes/rope.json -o turn_{frame}.png --size 96x96 --frames 1-4 "
      "--skip-existing");
}

std::string options_of_picture(const CLI::App& sub) {
  static constexpr std::array<std::string_view, 17> kNotOfThePicture = {
      "SCENE",         "--set",  "-o",        "--quiet",          "--explain",         "--json",
      "--stats",       "--crop", "--tile",    "--frames",         "--frames-per-turn", "--skip-existing",
      "--progressive", "--help", "--threads", "--texture-memory", "--no-leave-out"};
  std::string text = "sweepkit " SWEEPKIT_VERSION;
  for (const CLI::Option* option : sub.get_options()) {
    if (std::ranges::find(kNotOfThePicture, option->get_name()) != kNotOfThePicture.end()) continue;
    text += '\n' + option->get_name() + '=';
    if (option->count() == 0) text += option->get_default_str();
    for (const std::string& result : option->results()) text += result + ';';
  }
  return text;
}

}  // namespace sweepkit::tools
