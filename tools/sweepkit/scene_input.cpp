// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "scene_input.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>

#include "sweepkit/error.hpp"
#include "sweepkit/scene/gltf_source.hpp"

namespace sweepkit::tools {

void add_scene_input(CLI::App& command, SceneInput& input) {
  command
      .add_option("SCENE", input.file,
                  "Scene file (JSON), or a .glb or .gltf that holds the scene it was made from")
      ->type_name("");
  command
      .add_option("--set", input.settings,
                  "Change a value of the scene, such as /objects/0/revolve/angle_deg=270; may be repeated")
      ->type_name("POINTER=VALUE")
      ->allow_extra_args(false);
  command
      .add_option("--files-in", input.folder,
                  "The folder that the scene in a .glb or .gltf names its files from; without it the "
                  "glTF's own")
      ->type_name("FOLDER");
  add_curve_options(command, input.curves);
}

namespace {

scene::SceneFile open_file(const SceneInput& input) {
  if (input.file.empty()) return make_scene(input.curves);
  if (!scene::is_gltf_name(input.file)) return scene::SceneFile(input.file);
  const std::filesystem::path file = input.file;
  return {scene::read_gltf_source(file).scene, file,
          input.folder.empty() ? file.parent_path() : std::filesystem::path(input.folder)};
}

}  // namespace

std::string folder_hint(const SceneInput& input, const InputError& error) {
  const bool is_missing = error.problem().find("no such file") != std::string::npos;
  if (!is_missing || !input.folder.empty() || !scene::is_gltf_name(input.file)) return "";
  return "; --files-in tells the folder of the scene that the glTF was made from";
}

scene::SceneFile open_scene(const SceneInput& input) {
  std::vector<scene::Setting> settings;
  settings.reserve(input.settings.size());
  for (const std::string& text : input.settings) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
      throw InputError({.file = "--set"},
                       "needs POINTER=VALUE, such as /objects/0/name=vase, got \"" + text + "\"");
    }
    settings.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  if (input.file.empty() && !input.curves.are_given()) {
    throw InputError("needs a scene file, or --contour and --trajectory");
  }
  if (!input.file.empty() && input.curves.are_given()) {
    throw InputError({.file = input.file},
                     "is a scene file; beside one change values with --set, or leave it out");
  }
  if (!input.folder.empty() && !scene::is_gltf_name(input.file)) {
    throw InputError({.file = "--files-in"},
                     "is for the scene in a .glb or .gltf; a scene file's names are "
                     "relative to it");
  }
  scene::SceneFile scene = open_file(input);
  for (const scene::Setting& setting : settings) scene.set(setting);
  return scene;
}

scene::Document read_scene(const SceneInput& input) {
  return open_scene(input).document();
}

void keep_object(scene::Document& document, const std::string& name) {
  const auto found = std::find_if(document.objects.begin(), document.objects.end(),
                                  [&](const scene::ObjectEntry& object) { return object.name == name; });
  if (found == document.objects.end()) {
    std::string names;
    for (const scene::ObjectEntry& object : document.objects) {
      names += (names.empty() ? "\"" : ", \"") + object.name + '"';
    }
    throw InputError({.file = "--object"}, "there is no object \"" + name + "\"; there is " + names);
  }
  scene::ObjectEntry kept = std::move(*found);
  document.objects.clear();
  document.objects.push_back(std::move(kept));
}

PixelSize parse_size(const std::string& text) {
  PixelSize size;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  const bool has_cross = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = has_cross ? std::from_chars(width.ptr + 1, end, size.height) : width;
  const bool is_read = has_cross && height.ec == std::errc() && height.ptr == end;
  if (!is_read || size.width < 1 || size.height < 1 || size.width > kLongestSide ||
      size.height > kLongestSide) {
    throw InputError({.file = "--size"}, "needs WIDTHxHEIGHT in pixels, each 1 to " +
                                             std::to_string(kLongestSide) + ", such as 640x480, got \"" +
                                             text + "\"");
  }
  if (std::int64_t{size.width} * size.height > kMostPixels) {
    throw InputError({.file = "--size"}, "needs at most 2^28 pixels (16384x16384), got " + text);
  }
  return size;
}

}  // namespace sweepkit::tools
