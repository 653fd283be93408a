// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace sweepkit::report {

/// A scene file's text: tubes about a trefoil knot, in a row where there are several, `triangles` together,
/// with an image about them unless its name is empty.
std::string knots_scene(double triangles, int objects, const std::string& image);

/// Writes a PNG of side x side pixels, coloured noise on a slope: nothing that packs to nothing. Throws
/// OutputError.
void write_noise(const std::filesystem::path& file, int side);

}  // namespace sweepkit::report
