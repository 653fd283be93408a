// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <span>

#include "commands.hpp"
#include "sweepkit/scene/output_file.hpp"
#include "sweepkit/scene/schema.hpp"

namespace sweepkit::tools {

void add_schema(CLI::App& app) {
  const auto file = std::make_shared<std::string>("-");
  CLI::App& sub =
      *app.add_subcommand("schema", "The JSON Schema of scene files, for editors that check and complete");
  sub.add_option("-o", *file, "Where it goes; - is standard output")
      ->type_name("FILE")
      ->capture_default_str();
  sub.footer(
      "A scene that says {\"$schema\": \"scene.schema.json\", ...} at its top is checked and completed by\n"
      "editors that know JSON Schema, with the file beside it.\n\n"
      "Example:\n  sweepkit schema -o scene.schema.json");
  sub.callback([file] {
    scene::check_output(*file);
    const std::array files = {scene::OutputFile{*file, std::as_bytes(std::span(scene::scene_schema()))}};
    scene::write_files(files);
  });
}

}  // namespace sweepkit::tools
