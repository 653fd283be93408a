// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "curve_options.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/document.hpp"

namespace CLI {
class App;
}

namespace sweepkit::tools {

/// The scene that a command works on: its file or what the options for curves make, changed by --set.
struct SceneInput {
  std::string file;    ///< a scene, or a glTF that holds the one it was made from
  std::string folder;  ///< where the files are that the scene of a glTF names; empty: beside it
  CurveOptions curves;
  std::vector<std::string> settings;  ///< POINTER=VALUE

  /// For messages and tables.
  std::string name() const { return file.empty() ? "command line" : file; }
};

void add_scene_input(CLI::App& command, SceneInput& input);

/// Does a missing file that the scene names need to be looked for elsewhere? Then what to do, else "".
std::string folder_hint(const SceneInput& input, const InputError& error);

/// The file with --set done to it, for documents that differ in more values. Throws InputError: neither a
/// file nor curves or both, a setting without "=", or what scene::SceneFile and make_scene() find.
scene::SceneFile open_scene(const SceneInput& input);

/// Its document. Throws InputError as that does.
scene::Document read_scene(const SceneInput& input);

/// Leaves the named object alone in the document, so that nothing else is planned, made or read. Throws
/// InputError with the names there are.
void keep_object(scene::Document& document, const std::string& name);

struct PixelSize {
  int width = 0;
  int height = 0;
};

/// Pixels of a picture or texels of a baked texture: 16384 x 16384.
inline constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;
inline constexpr int kLongestSide = 32768;

/// "640x480". Throws InputError naming --size: not two whole numbers, a side not in 1 to kLongestSide, or
/// more than kMostPixels.
PixelSize parse_size(const std::string& text);

}  // namespace sweepkit::tools
