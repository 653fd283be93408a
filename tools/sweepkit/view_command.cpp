// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "commands.hpp"
#include "findings.hpp"
#include "memory.hpp"
#include "output.hpp"
#include "scene_input.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/drawn_curves.hpp"
#include "sweepkit/scene/gltf.hpp"
#include "sweepkit/scene/gltf_info.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/output_file.hpp"
#include "view_page.hpp"

namespace sweepkit::tools {
namespace {

// A browser holds the page's text, the model's base64 in it, and its bytes at once; beyond this they give up.
constexpr std::uint64_t kLargestModel = std::uint64_t{256} << 20;

struct View {
  SceneInput input;
  Output output;
  std::string object;
  int bake_size = 1024;
};

struct Shown {
  std::vector<std::byte> model;
  std::string curves;  // JSON
  std::string title;
};

// "1,2,3".
void append(std::string& text, const glm::dvec3& p) {
  for (glm::length_t k = 0; k < 3; ++k) {
    if (k > 0) text += ',';
    text += json_value(p[k]);
  }
}

std::string to_json(const std::vector<scene::DrawnCurve>& curves) {
  static constexpr const char* kKinds[] = {"trajectory", "contour", "axis"};
  // Relative to the first point, so that float32 suffices anywhere.
  const glm::dvec3 origin = curves.front().points.front();
  std::string text = R"({"origin": [)";
  append(text, origin);
  text += R"(], "curves": [)";
  for (const scene::DrawnCurve& curve : curves) {
    if (text.back() == '}') text += ", ";
    text += R"({"kind": ")";
    text += kKinds[static_cast<int>(curve.kind)];
    text += R"(", "points": [)";
    for (const glm::dvec3& p : curve.points) {
      if (text.back() != '[') text += ',';
      append(text, p - origin);
    }
    text += "]}";
  }
  return text + "]}";
}

Shown make_shown(const View& command) {
  scene::Document document = read_scene(command.input);
  if (!command.object.empty()) keep_object(document, command.object);
  const scene::Plan plan = scene::plan(document, {.product = scene::Request::Product::kMeshFile});
  // The model, its base64 and the page.
  const scene::MemoryEstimate needed = scene::estimate_memory(document);
  require_memory(command.input.name(), needed, 5 * needed.bytes);
  limit_triangles(document, 5 * scene::kLeastBytesATriangle);
  const scene::Model model = scene::build(document, plan);
  Shown shown{.title = command.object.empty() ? std::filesystem::path(command.input.name()).stem().string()
                                              : command.object};
  scene::GltfFile gltf = scene::make_gltf(model.scene, plan, "view.glb", {.bake_size = command.bake_size});
  shown.model = std::move(gltf.files.back().bytes);
  for (const scene::ObjectEntry& object : document.objects) {
    const std::vector<scene::DrawnCurve> curves = scene::drawn_curves(object);
    if (curves.empty()) continue;
    if (!shown.curves.empty()) shown.curves += ", ";
    shown.curves += json_value(object.name);
    shown.curves += ": ";
    shown.curves += to_json(curves);
  }
  if (!command.output.is_quiet) {
    warn(scene::check(document, model, scene::Thoroughness::kQuick), command.output);
  }
  return shown;
}

Shown read_shown(const std::string& file) {
  scene::read_gltf_info(file);  // says what is wrong with a file that is no glTF
  std::ifstream in(file, std::ios::binary);
  const std::vector<char> text{std::istreambuf_iterator<char>(in), {}};
  const auto bytes = std::as_bytes(std::span(text));
  return {{bytes.begin(), bytes.end()}, "", std::filesystem::path(file).stem().string()};
}

void view(const View& command) {
  const auto start = std::chrono::steady_clock::now();
  const Output& output = command.output;
  if (output.file.empty()) throw InputError("-o PAGE.html is needed");
  if (!output.is_standard() && std::filesystem::path(output.file).extension() != ".html")
    throw InputError({.file = output.file}, "a page's name ends in .html");
  scene::check_output(output.file);
  const std::string page_template = read_page_template();
  const std::string extension = std::filesystem::path(command.input.file).extension();
  if (extension == ".gltf") {
    throw InputError({.file = command.input.file},
                     "has its buffer and images beside it; a page holds a .glb or is made of the scene");
  }
  const bool is_model = extension == ".glb";
  if (is_model && !(command.input.settings.empty() && command.object.empty()))
    throw InputError({.file = command.input.file},
                     "is shown as it stands; --set and --object are for scenes");
  const Shown shown = is_model ? read_shown(command.input.file) : make_shown(command);
  if (shown.model.size() > kLargestModel) {
    throw InputError({.file = command.input.name()},
                     "makes a model of " + std::to_string(shown.model.size() >> 20) +
                         " MiB, and browsers show pages of up to " + std::to_string(kLargestModel >> 20) +
                         "; ask for fewer cells or for one --object");
  }
  const std::string page = fill_page(page_template, {.title = shown.title,
                                                     .facts = "{\"title\": " + json_value(shown.title) +
                                                              ", \"curves\": {" + shown.curves + "}}",
                                                     .model = shown.model});
  scene::write_files(std::vector<scene::OutputFile>{{output.file, std::as_bytes(std::span(page))}});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  say((output.is_standard() ? "standard output" : output.file) + ": " + std::to_string(page.size()) +
          " bytes in " + duration_text(seconds),
      output);
}

}  // namespace

void add_view(CLI::App& app) {
  const auto command = std::make_shared<View>();
  CLI::App& sub = *app.add_subcommand(
      "view", "Make a page that shows the scene or a .glb in any browser, without a network");
  add_scene_input(sub, command->input);
  sub.get_option("SCENE")->description("Scene file (JSON), or a .glb of whatever program");
  sub.add_option("-o", command->output.file, "The page, ending in .html; - is standard output")
      ->type_name("PAGE.html");
  sub.add_option("--object", command->object, "This object alone")->type_name("NAME");
  sub.add_option("--bake-size", command->bake_size,
                 "Texels on the longer side of the image that a procedural texture becomes")
      ->capture_default_str()
      ->type_name("N")
      ->check(CLI::Range(1, 16384));
  add_quiet(sub, command->output);
  sub.footer(
      "The page turns and zooms the model by mouse, touch or keys, shows it finished, with a (u,v) checker, "
      "by\n"
      "its normals or as clay, its triangles, and the curves it was made of; ? tells the keys.\n\n"
      "Examples:\n"
      "  sweepkit view samples/scenes/vase_and_cup.json -o vase_and_cup.html\n"
      "  sweepkit view --contour circle:0.1 --trajectory helix:radius=1,pitch=0.3,turns=4 -o spring.html");
  sub.callback([command] { view(*command); });
}

}  // namespace sweepkit::tools
