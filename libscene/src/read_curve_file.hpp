// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::scene {

/// Curves that come as SVG, path data or lists of points. All throw InputError, with the place in the curve's
/// own file where there is one.

/// {"svg": FILE, "id": ID, "scale": s}; a user unit is `scale` metres.
struct SvgCurve {
  std::filesystem::path file;
  std::optional<std::string> id;
  double scale = 1;
};

/// {"path": DATA, "scale": s}
struct PathCurve {
  std::string data;
  double scale = 1;
};

/// {"csv": FILE, "closed": bool, "smooth": bool}
struct PointCurve {
  std::filesystem::path file;
  bool is_closed = false;  ///< coinciding ends close anyway
  bool is_smooth = false;  ///< a free curve through the points in place of straight lines
};

/// The outlines that bound what is filled, each with the region on its left; then what is drawn without being
/// filled, as it is drawn: open subpaths of inline path data, outlines of SVG elements with fill="none".
/// (A filled element of an SVG file closes its open subpaths.) Not empty.
std::vector<sweep::Curve2> contour_of(const SvgCurve& svg);
std::vector<sweep::Curve2> contour_of(const PathCurve& path);
std::vector<sweep::Curve2> contour_of(const PointCurve& points);

/// As drawn, filled or not. A plane curve lies in the x,y plane. Throws InputError where there is more than
/// one outline.
sweep::Curve3 trajectory_of(const SvgCurve& svg);
sweep::Curve3 trajectory_of(const PathCurve& path);
sweep::Curve3 trajectory_of(const PointCurve& points);

}  // namespace sweepkit::scene
