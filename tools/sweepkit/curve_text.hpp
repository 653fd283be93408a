// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "sweepkit/scene/document.hpp"

namespace sweepkit::tools {

/// The setting that puts a curve written as one word at `pointer`: a file (.svg[#ID], .csv .txt .xyz .dat,
/// .json with a CURVE of the scene format) with what belongs to it after a colon (icon.svg:scale=0.01), a
/// primitive (circle:0.1, helix:radius=1,pitch=0.3,turns=4), path:DATA, line:X,Y,Z,X,Y,Z, or JSON itself.
/// Throws InputError naming `option`.
scene::Setting curve_setting(const std::string& text, const std::string& pointer, const std::string& option);

/// The same for a law: a number, values along the way (0:1,0.5:0.3,1:1), a .json file with a LAW, or JSON.
scene::Setting law_setting(const std::string& text, const std::string& pointer, const std::string& option);

/// `text` as a JSON string.
std::string json_string(const std::string& text);

/// Is all of `text` a number as JSON writes them?
bool is_number(const std::string& text);

/// The parts between separators, or none of an empty text.
std::vector<std::string> split(const std::string& text, char separator);

}  // namespace sweepkit::tools
