// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame_list.hpp"
#include "output.hpp"
#include "picture_file.hpp"
#include "picture_mark.hpp"
#include "scene_input.hpp"
#include "sweepkit/render/render.hpp"

namespace CLI {
class App;
}

namespace sweepkit::tools {

/// What `render` was asked for, as it stands on the command line.
struct Render {
  SceneInput input;
  Output output;
  render::Options options;
  std::string size;
  std::string filter{texmap::filter_name(render::Options{}.filter)};
  std::string footprint = "auto";
  std::string antialias = "off";
  std::string accelerator = "auto";
  std::string shadows = "smooth";
  render::Adaptive adaptive;
  std::size_t texture_megabytes = texmap::kDefaultTextureMemory >> 20;
  int depth = -1;  // the scene's
  double exposure = 0;
  int bits = 0;
  std::vector<std::string> layers;
  std::string crop;
  std::string tile;
  std::string frames;
  int frames_per_turn = 0;
  bool skips_existing = false;
  bool leaves_nothing_out = false;
  bool is_progressive = false;
  double most_error = 0;    // linear RMSE; 0: not asked for
  double most_seconds = 0;  // 0: not asked for
  std::string statistics;   // a file
  std::string key_options;  // the options that change the picture, in one text
};

/// A picture that is to be drawn.
struct PictureJob {
  std::string file;
  std::optional<Turn> turn;
  std::vector<std::string> names;  ///< of all its files
  std::string description;         ///< its mark; empty: none
};

/// What the options ask for, checked as far as it can be without the scene.
struct RenderRequest {
  PictureEncoding encoding;
  std::optional<render::Region> crop;
  std::optional<Tile> tile;
  std::vector<PictureJob> jobs;  ///< one, or one a frame; without marks

  /// Do its files carry marks?
  bool is_marked = false;
};

void add_render_options(CLI::App& sub, Render& command);

/// The options that change the picture, for Render::key_options: all that the command has but those that are
/// known to change nothing, so that a new one is not forgotten.
std::string options_of_picture(const CLI::App& sub);

/// Throws InputError naming the option: names and values that cannot be, options that do not go together,
/// files that cannot be written. Fills in command.options.
RenderRequest read_request(Render& command);

}  // namespace sweepkit::tools
