// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "commands.hpp"
#include "findings.hpp"
#include "memory.hpp"
#include "output.hpp"
#include "scene_input.hpp"

namespace sweepkit::tools {
namespace {

struct Check {
  SceneInput input;
  Output output;
  std::string object;
  bool is_strict = false;
};

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

void check(const Check& command) {
  scene::Document document = read_scene(command.input);
  if (!command.object.empty()) keep_object(document, command.object);
  scene::Plan plan = scene::plan(document, {.product = scene::Request::Product::kMeshFile});
  std::fill(plan.textures.begin(), plan.textures.end(), false);  // shapes have no pixels
  require_memory(command.input.name(), scene::estimate_memory(document), 0);
  limit_triangles(document, 0);
  const scene::Model model = scene::build(document, plan);
  const std::vector<scene::SceneFinding> findings = scene::check(document, model);
  Table table{"findings", {}};
  for (const scene::SceneFinding& found : findings) {
    const sweep::Finding& f = found.finding;
    const auto coordinate = [](double x) { return std::round(1e6 * x) / 1e6; };
    Record row = {{"object", found.object}, {"kind", std::string(sweep::name_of(f.kind))},
                  {"t", coordinate(f.t)},   {"from", coordinate(f.from)},
                  {"to", coordinate(f.to)}, {"other t", f.other ? Value(coordinate(*f.other)) : Value()}};
    if (command.output.is_json) {
      row.insert(row.end(), {{"x", f.point.x}, {"y", f.point.y}, {"z", f.point.z}, {"severity", f.severity}});
    } else {
      row.emplace_back("point", number(f.point.x) + ", " + number(f.point.y) + ", " + number(f.point.z));
    }
    row.insert(row.end(), {{"problem", f.problem}, {"cure", f.cure}});
    table.rows.push_back(std::move(row));
  }
  const std::vector<scene::MaterialFinding> of_materials = scene::check_materials(document);
  Table materials{"material findings", {}};
  for (const scene::MaterialFinding& found : of_materials) {
    std::string place = to_prefix(found.place);
    place.resize(place.size() - 2);  // of a message: ends in ": "
    materials.rows.push_back({{"material", found.material},
                              {"place", std::move(place)},
                              {"sum", std::round(1e6 * found.sum) / 1e6},
                              {"problem", found.problem},
                              {"cure", found.cure}});
  }
  const std::size_t objects = document.objects.size();
  const std::size_t found = findings.size() + of_materials.size();
  print({{{"file", command.input.name()},
          {"objects", static_cast<std::uint64_t>(objects)},
          {"found", static_cast<std::uint64_t>(found)}},
         {std::move(table), std::move(materials)}},
        command.output);
  if (command.is_strict && found > 0) throw FoundFaults();
}

}  // namespace

void add_check(CLI::App& app) {
  const auto command = std::make_shared<Check>();
  CLI::App& sub =
      *app.add_subcommand("check", "Look for faults of shape (folds, crossings, cusps) and of materials");
  add_scene_input(sub, command->input);
  sub.add_option("--object", command->object, "This object alone")->type_name("NAME");
  sub.add_flag("--strict", command->is_strict, "End with exit status 3 where there is a finding");
  sub.add_flag("--json", command->output.is_json, "As JSON");
  sub.footer(
      "A finding has its place (t, from 0 to 1 along the trajectory, and the point), how bad it is and a "
      "cure.\n"
      "Examples:\n  sweepkit check samples/scenes/vase_and_cup.json --strict\n"
      "  sweepkit check --contour circle:0.1 --trajectory circle:0.05");
  sub.callback([command] { check(*command); });
}

}  // namespace sweepkit::tools
