// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "sweepkit/scene/document.hpp"

namespace CLI {
class App;
}

namespace sweepkit::tools {

/// An object given by options in place of a scene file.
struct CurveOptions {
  std::string contour;
  std::string trajectory;
  std::string profile;
  std::string twist;
  std::string guide;
  std::string frames;
  std::string caps;
  std::string joints;
  std::string texture;
  std::string texture_size;
  std::string cells;
  std::string tolerance;
  /// The object stands in a lit place, for a picture; a file of it brings no lights.
  bool has_studio = false;

  /// Is any of them given?
  bool are_given() const;
};

void add_curve_options(CLI::App& command, CurveOptions& options);

/// A scene of one object, "sweep", as the options have it. File names are relative to the working folder.
/// Throws InputError naming the option: a missing one, or what is no curve, law or number of cells.
scene::SceneFile make_scene(const CurveOptions& options);

}  // namespace sweepkit::tools
