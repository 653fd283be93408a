// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <utility>

namespace sweepkit::tools {

/// What tools/ bundles with node, as it lies beside the program or where it was installed. Throws InputError
/// where this build has none; `purpose` says what it would be for: "to show models with".
std::string read_bundled(const std::string& file, const std::string& purpose);

/// The template with texts in place of its marks, which stand in it in this order. Throws OutputError where
/// one is missing; `file` names the template.
std::string fill_marks(const std::string& page_template, const std::string& file,
                       std::span<const std::pair<std::string, std::string>> texts);

/// As HTML has it.
std::string html_text(const std::string& text);

/// JSON that may stand in a page's script: a browser looks for the script's end in JSON as well.
std::string json_in_html(const std::string& json);

}  // namespace sweepkit::tools
