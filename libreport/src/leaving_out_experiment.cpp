// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "leaving_out_experiment.hpp"

#include <algorithm>
#include <numeric>

#include "picture_scene.hpp"
#include "scene_files.hpp"
#include "timing.hpp"

namespace sweepkit::report {
namespace {

using scene::Part;

// A scene built and drawn with one plan.
struct Way {
  scene::Plan plan;
  render::Picture picture;
  scene::Ledger ledger;
};

void draw_with(const scene::Document& document, const render::Options& options, Way& way) {
  const scene::Model model = scene::build(document, way.plan);
  way.picture = render::render(model.scene, way.plan, options);
  way.ledger = model.ledger;
  way.ledger.add(way.picture.ledger);
}

scene::Cost total(const scene::Ledger& ledger) {
  return std::accumulate(ledger.costs.begin(), ledger.costs.end(), scene::Cost{},
                         [](const scene::Cost& a, const scene::Cost& b) {
                           return scene::Cost{a.bytes + b.bytes, a.calls + b.calls};
                         });
}

double number(std::uint64_t count) {
  return static_cast<double>(count);
}

std::vector<SceneFile> scenes_for(const Effort& effort) {
  std::vector<std::string> names = {"vase_and_cup", "seashell", "picture_frame", "bottle"};
  if (!effort.is_quick) names = sample_names(effort);
  return scene_files(effort, names);
}

}  // namespace

Experiment measure_leaving_out(const Effort& effort) {
  Experiment experiment{
      .name = "leaving_out",
      .title = "What a scene does without",
      .what =
          "Each scene twice: as it is drawn, with only the parts of the work that it needs, and with every "
          "part switched on that leaves the picture as it is. The bytes and calls are counted by the parts "
          "themselves. What is no share of the work, such as layers that nobody asks for, is on in neither.",
      .how =
          "From the checked scene to the picture: meshes, textures, accelerators and all pixels. Smooth "
          "shadows, the filter auto, one thread."};
  experiment.table.columns = {{"scene", "scene"},
                              {"way", "way"},
                              {"parts", "parts switched on"},
                              {"bytes", "memory of the parts (bytes)"},
                              {"calls", "calls of the parts"},
                              {"time_share", "time over that of everything on"},
                              {"same_picture", "the same bytes in the picture"}};
  for (Column& column : timing_columns("the scene and its picture"))
    experiment.table.columns.push_back(std::move(column));
  Experiment parts{
      .name = "left_out",
      .title = "What each scene leaves out, part by part",
      .what =
          "Whether a scene needs a part, and why; what the part costs in its picture, and what it "
          "would cost if it were on. The last two are 0 for what only a wish can switch on.",
      .how = "Counters of the same two pictures."};
  parts.table.columns = {{"scene", "scene"},
                         {"part", "part"},
                         {"needed", "needed"},
                         {"why", "why"},
                         {"bytes", "memory (bytes)"},
                         {"calls", "calls"},
                         {"bytes_if_on", "memory if everything is on (bytes)"},
                         {"calls_if_on", "calls if everything is on"}};

  const std::vector<SceneFile> files = scenes_for(effort);
  double done = 0;
  for (const SceneFile& file : files) {
    effort.tell(done++ / number(files.size()));
    scene::Document document = scene::read_document(file.file);
    document.width = document.height = effort.is_quick ? 64 : 256;
    const render::Options options{.threads = 1};
    Way left_out{.plan = plan_for(document, options)};
    Way everything{.plan = plan_for(document, options, false)};
    const std::vector<Timing> timings = time_in_turn(
        {[&] { draw_with(document, options, left_out); }, [&] { draw_with(document, options, everything); }},
        effort);
    const bool is_same = left_out.picture.image.texels == everything.picture.image.texels;
    const auto add = [&](const char* name, const Way& way, const Timing& timing) {
      const scene::Cost cost = total(way.ledger);
      std::vector<Cell> row{file.name,
                            name,
                            number(static_cast<std::uint64_t>(std::ranges::count_if(
                                way.plan.needs, [](const scene::Need& need) { return need.is_needed; }))),
                            number(cost.bytes),
                            number(cost.calls),
                            timing.median / timings[1].median,
                            is_same ? "yes" : "no"};
      add_timing(row, timing);
      experiment.table.rows.push_back(std::move(row));
    };
    add("what it needs", left_out, timings[0]);
    add("everything on", everything, timings[1]);
    for (std::size_t i = 0; i < scene::kPartCount; ++i) {
      const auto part = static_cast<Part>(i);
      const scene::Need& need = left_out.plan.needs[i];
      const scene::Cost& cost = left_out.ledger[part];
      const scene::Cost& on = everything.ledger[part];
      parts.table.rows.push_back({file.name, std::string(scene::part_name(part)),
                                  need.is_needed ? "yes" : "left out", need.why, number(cost.bytes),
                                  number(cost.calls), number(on.bytes), number(on.calls)});
    }
  }
  experiment.plots.push_back({.name = "leaving_out",
                              .title = "memory of the parts against time, a point a scene",
                              .x = "seconds",
                              .y = "bytes",
                              .by = "way",
                              .label = "scene",
                              .has_lines = false});
  experiment.derived.push_back(std::move(parts));
  return experiment;
}

}  // namespace sweepkit::report
