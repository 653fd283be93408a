// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <tuple>
#include <utility>

#include "commands.hpp"
#include "output.hpp"
#include "page_template.hpp"
#include "progress.hpp"
#include "samples_folder.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/report/plot_drawer.hpp"
#include "sweepkit/report/report.hpp"
#include "sweepkit/report/scale_step.hpp"
#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/output_file.hpp"

namespace sweepkit::tools {
namespace {

constexpr const char* kPage = "sweepkit-report.html";
constexpr const char* kPlots = "sweepkit-plots.js";
constexpr const char* kPurpose = "to report on";

struct ReportCommand {
  Output output;  ///< its file is the folder
  bool is_quick = false;
  std::vector<std::string> only;
  std::filesystem::path scene;                          ///< measured in place of the samples
  std::tuple<std::string, std::string, int, int> step;  ///< a report::ScaleStep
};

std::string names() {
  std::string all;
  for (const report::Runnable& one : report::runnables()) all += (all.empty() ? "" : ", ") + one.name;
  return all;
}

std::vector<report::Runnable> chosen(const std::vector<std::string>& only) {
  if (only.empty()) return report::runnables();
  std::vector<report::Runnable> runnables;
  for (const report::Runnable& one : report::runnables()) {
    if (std::find(only.begin(), only.end(), one.name) != only.end()) runnables.push_back(one);
  }
  return runnables;
}

// What the experiments work on; refused before any of them runs.
report::Effort effort_of(const ReportCommand& command, const std::vector<report::Runnable>& runnables) {
  std::error_code ignored;
  report::Effort effort{.is_quick = command.is_quick,
                        .samples = samples_folder(),
                        .scene = command.scene,
                        .program = std::filesystem::canonical("/proc/self/exe", ignored)};
  if (!effort.scene.empty()) {
    scene::read_document(effort.scene);
  } else if (effort.samples.empty()) {
    for (const report::Runnable& one : runnables) {
      if (!one.needs_scenes) continue;
      throw InputError("the experiment " + one.name +
                       " needs the sample scenes, which are missing (share/sweepkit/samples beside the "
                       "program's bin): install sweepkit again, or name a scene of your own by --scene");
    }
  }
  return effort;
}

// The folder is made where the one it is in is there.
void prepare_folder(const std::filesystem::path& folder) {
  if (folder.empty()) throw InputError("-o FOLDER is needed");
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    scene::check_output(folder);
    std::filesystem::create_directory(folder, error);
    if (error) throw OutputError(folder.string() + ": cannot be made: " + error.message());
  }
  scene::check_output(folder / "index.html");
}

std::string now() {
  const std::time_t time = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&time));
  return text;
}

report::Report measure(const ReportCommand& command, const std::vector<report::Runnable>& runnables,
                       report::Effort effort) {
  report::Report made{.version = SWEEPKIT_VERSION,
                      .date = now(),
                      .is_quick = command.is_quick,
                      .machine = report::this_machine()};
  Progress progress(command.output.is_quiet);
  const std::function<void(double)> bar = progress.callback();
  for (std::size_t i = 0; i < runnables.size(); ++i) {
    if (bar) {
      effort.on_progress = [&, i](double done) {
        bar((static_cast<double>(i) + done) / static_cast<double>(runnables.size()));
      };
    }
    effort.tell(0);
    report::Experiment experiment = runnables[i].run(effort);
    std::vector<report::Experiment> derived = std::exchange(experiment.derived, {});
    made.experiments.push_back(std::move(experiment));
    std::move(derived.begin(), derived.end(), std::back_inserter(made.experiments));
  }
  return made;
}

void run_report(const ReportCommand& command) {
  const auto start = std::chrono::steady_clock::now();
  const std::filesystem::path folder = command.output.file;
  const std::string page_template = read_bundled(kPage, kPurpose);
  report::PlotDrawer drawer(read_bundled(kPlots, kPurpose));
  const std::vector<report::Runnable> runnables = chosen(command.only);
  const report::Effort effort = effort_of(command, runnables);
  prepare_folder(folder);
  const report::Report made = measure(command, runnables, effort);

  std::vector<std::pair<std::string, std::string>> texts;
  for (const report::Experiment& experiment : made.experiments) {
    texts.emplace_back(experiment.name + ".csv", report::to_csv(experiment.table));
    for (const report::Plot& plot : experiment.plots) {
      texts.emplace_back(plot.name + ".svg", drawer.svg(report::plot_json(experiment, plot)));
    }
  }
  texts.emplace_back("report.json", report::to_json(made));
  const std::vector<std::pair<std::string, std::string>> marks = {
      {"@GENERATOR@", "sweepkit " SWEEPKIT_VERSION}, {"@REPORT@", json_in_html(report::to_json(made, true))}};
  texts.emplace_back("index.html", fill_marks(page_template, kPage, marks));

  std::vector<scene::OutputFile> files;
  files.reserve(texts.size());
  for (const auto& [name, text] : texts) files.push_back({folder / name, std::as_bytes(std::span(text))});
  scene::write_files(files);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  say((folder / "index.html").string() + ": " + std::to_string(made.experiments.size()) + " experiments in " +
          duration_text(seconds),
      command.output);
}

}  // namespace

void add_report(CLI::App& app) {
  const auto command = std::make_shared<ReportCommand>();
  CLI::App& sub =
      *app.add_subcommand("report", "Measure error against run time on this machine, as a page with plots");
  sub.add_option("-o", command->output.file,
                 "The folder for index.html, plots and tables; made where it is missing")
      ->type_name("FOLDER");
  sub.add_flag("--quick", command->is_quick, "Under a minute, with fewer settings and shorter runs");
  sub.add_option("--only", command->only, "This experiment alone: " + names() + "; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->check(CLI::IsMember([] {
        std::vector<std::string> all;
        for (const report::Runnable& one : report::runnables()) all.push_back(one.name);
        return all;
      }()))
      ->description("This experiment alone: " + names() + "; may be repeated");
  sub.add_option("--scene", command->scene, "Measure this scene in place of the samples")->type_name("SCENE");
  add_quiet(sub, command->output);
  // How a report runs itself; not for people.
  CLI::Option* step = sub.add_option("--scale-step", command->step)->group("");
  sub.footer(
      "The page needs no network. Each plot is also an SVG file, each table a CSV file, and all of it is in\n"
      "report.json.\n\n"
      "Example:\n  sweepkit report --quick -o report");
  sub.callback([command, step] {
    if (step->count() == 0) {
      run_report(*command);
      return;
    }
    const auto& [work, scene, threads, side] = command->step;
    std::cout << report::run_scale_step({work, scene, threads, side}) << '\n';
  });
}

}  // namespace sweepkit::tools
