// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "curve_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "curve_text.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::tools {
namespace {

// Light from the left and above, and a little from the right, before grey.
constexpr const char* kStudio = R"({
  "sweepkit": 1,
  "background": [0.5, 0.54, 0.58],
  "ambient": [0.22, 0.23, 0.25],
  "lights": [{"directional": [0.55, -1, -0.5], "intensity": [0.72, 0.69, 0.63]},
             {"directional": [-0.5, -0.45, -0.85], "intensity": [0.15, 0.16, 0.18]}]
})";

constexpr const char* kNothing = R"({"sweepkit": 1})";

constexpr const char* kProcedurals[] = {"checker", "tiles", "bands", "marble"};

scene::Setting plain(const std::string& pointer, const std::string& json, const std::string& option) {
  return {pointer, json, {.file = option}, {.file = option}};
}

std::string texture_json(const std::string& text) {
  const bool is_procedural =
      std::find(std::begin(kProcedurals), std::end(kProcedurals), text) != std::end(kProcedurals);
  return (is_procedural ? "{\"procedural\": " : "{\"image\": ") + json_string(text) + "}";
}

scene::Setting cells_setting(const std::string& text) {
  const std::vector<std::string> counts = split(text, 'x');
  if (counts.size() != 2 || !is_number(counts[0]) || !is_number(counts[1])) {
    throw InputError(
        {.file = "--cells"},
        "needs two numbers of cells, along contour and trajectory, such as 48x200, got \"" + text + '"');
  }
  return plain("/objects/0/tessellation",
               "{\"contour\": " + counts[0] + ", \"trajectory\": " + counts[1] + "}", "--cells");
}

scene::Setting texture_size_setting(const std::string& text) {
  const std::vector<std::string> sides = split(text, 'x');
  if (sides.empty() || sides.size() > 2 || !is_number(sides.front()) || !is_number(sides.back())) {
    throw InputError({.file = "--texture-size"},
                     "needs metres, such as 0.5 or 0.5x0.25, got \"" + text + '"');
  }
  return plain("/objects/0/uv", "{\"size\": [" + sides.front() + ", " + sides.back() + "]}",
               "--texture-size");
}

}  // namespace

bool CurveOptions::are_given() const {
  const std::string* const texts[] = {&contour, &trajectory, &profile, &twist, &guide,     &frames,
                                      &caps,    &joints,     &texture, &cells, &tolerance, &texture_size};
  return std::any_of(std::begin(texts), std::end(texts),
                     [](const std::string* text) { return !text->empty(); });
}

void add_curve_options(CLI::App& command, CurveOptions& options) {
  CLI::Option_group& group = *command.add_option_group("Without a scene file");
  group
      .add_option("--contour", options.contour,
                  "The section: a file (.svg[#ID] .csv .txt .dat .json) or a primitive such as circle:0.1, "
                  "star:points=5,radius=0.2,inner_radius=0.1; after a file's name what belongs to it: "
                  "leaf.svg:scale=0.01")
      ->type_name("CURVE");
  group
      .add_option("--trajectory", options.trajectory,
                  "The way it is carried along: a file, or helix:radius=1,pitch=0.3,turns=4, "
                  "line:0,0,0,0,2,0, torus_knot:2,3,1,0.4, ...")
      ->type_name("CURVE");
  group.add_option("--profile", options.profile, "Its size along the way: 0.5, or 0:1,0.5:0.3,1:1")
      ->type_name("LAW");
  group.add_option("--twist", options.twist, "Its turn in degrees: in all, or along the way 0:0,0.5:90,1:0")
      ->type_name("LAW");
  group.add_option("--guide", options.guide, "The curve that its x axis points at")->type_name("CURVE");
  // --frames is render's.
  group
      .add_option("--sweep-frames", options.frames,
                  "How the section turns with the trajectory: rotation-minimizing, frenet or fixed-up")
      ->type_name("F");
  group.add_option("--caps", options.caps, "flat, round or none")->type_name("C");
  group.add_option("--joints", options.joints, "miter, smooth, round or bevel")->type_name("J");
  group.add_option("--texture", options.texture, "An image file, or checker, tiles, bands, marble")
      ->type_name("IMG");
  group
      .add_option(
          "--texture-size", options.texture_size,
          "Its size on the object, metres: 0.5, or width and height 0.5x0.25. As many repeats as fit, "
          "whole ones round what is closed")
      ->type_name("M");
  CLI::Option* tolerance =
      group.add_option("--tolerance", options.tolerance, "As few triangles as are within so many metres")
          ->type_name("M");
  group.add_option("--cells", options.cells, "So many cells along contour and trajectory: 64x64")
      ->type_name("NxM")
      ->excludes(tolerance);
}

scene::SceneFile make_scene(const CurveOptions& options) {
  for (const auto& [option, value] :
       {std::pair("--contour", &options.contour), std::pair("--trajectory", &options.trajectory)}) {
    if (value->empty()) throw InputError({.file = option}, "is needed where there is no scene file");
  }
  const std::string object = "/objects/0";
  const std::string sweep = object + "/sweep";
  std::vector<scene::Setting> settings = {
      plain("/objects", R"([{"name": "sweep", "sweep": {}}])", "command line"),
      curve_setting(options.contour, sweep + "/contour", "--contour"),
      curve_setting(options.trajectory, sweep + "/trajectory", "--trajectory")};
  if (!options.profile.empty())
    settings.push_back(law_setting(options.profile, sweep + "/profile", "--profile"));
  if (!options.twist.empty()) settings.push_back(law_setting(options.twist, sweep + "/twist_deg", "--twist"));
  if (!options.guide.empty()) settings.push_back(curve_setting(options.guide, sweep + "/guide", "--guide"));
  const auto set_word = [&](const std::string& key, const std::string& word, const std::string& option) {
    if (!word.empty()) settings.push_back(plain(sweep + "/" + key, json_string(word), option));
  };
  set_word("frames", options.frames, "--sweep-frames");
  set_word("caps", options.caps, "--caps");
  set_word("joints", options.joints, "--joints");
  if (!options.texture.empty()) {
    settings.push_back(
        plain("/textures", R"({"texture": )" + texture_json(options.texture) + "}", "--texture"));
    settings.push_back(plain("/materials", R"({"material": {"texture": "texture"}})", "--texture"));
    settings.push_back(plain(object + "/material", R"("material")", "--texture"));
  }
  if (!options.texture_size.empty()) settings.push_back(texture_size_setting(options.texture_size));
  if (!options.tolerance.empty()) {
    if (!is_number(options.tolerance)) {
      throw InputError({.file = "--tolerance"},
                       "needs metres, such as 0.001, got \"" + options.tolerance + '"');
    }
    settings.push_back(
        plain(object + "/tessellation", "{\"tolerance\": " + options.tolerance + "}", "--tolerance"));
  }
  if (!options.cells.empty()) settings.push_back(cells_setting(options.cells));
  scene::SceneFile scene(options.has_studio ? kStudio : kNothing, "command line");
  for (const scene::Setting& setting : settings) scene.set(setting);
  return scene;
}

}  // namespace sweepkit::tools
