// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Rows go through a pipeline: numbered in order, made side by side, told of in order again. So the messages
// and the table are the same for any number of threads, and only a few rows are in memory at a time.

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <optional>
#include <unordered_map>

#include "generate.hpp"
#include "name_pattern.hpp"
#include "plan_table.hpp"
#include "progress.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/gltf_size.hpp"
#include "sweepkit/scene/image_store.hpp"
#include "sweepkit/scene/mesh_file.hpp"
#include "sweepkit/scene/output_file.hpp"
#include "sweepkit/scene/values_table.hpp"

namespace sweepkit::tools {
namespace {

// A row waits for its turn to be told of while slower ones before it are made: enough that no thread waits
// for work, few enough that memory stays small.
constexpr std::size_t kRowsInFlightPerThread = 8;

struct Job {
  std::string file;     // empty where nothing is to be written
  std::string problem;  // empty: none so far
};

struct RowOutcome {
  std::size_t row = 0;
  std::string problem;  // empty: made
  scene::Plan plan;
  MadeFile made;
};

// One line that names the row's line, wherever the fault itself lies: in the scene, or in the header.
std::string row_problem(const scene::ValuesTable& table, std::size_t row, const InputError& error) {
  const scene::ValuesTable::Cell& first = table.rows[row].front();
  if (error.place().file == table.file && error.place().line >= first.line) return error.what();
  return to_prefix(table.place(first)) + error.what();
}

// Names are settled before any work, since two rows may not share one. A row that cannot be named is refused
// like one that cannot be made.
std::vector<Job> name_rows(const scene::ValuesTable& table, const std::string& pattern_text) {
  std::vector<Job> jobs(table.rows.size());
  if (pattern_text.empty()) return jobs;
  const NamePattern pattern(pattern_text, table);
  std::unordered_map<std::string, std::size_t> rows_by_file;
  for (std::size_t row = 0; row < jobs.size(); ++row) {
    try {
      jobs[row].file = pattern.file(row);
    } catch (const InputError& error) {
      jobs[row].problem = row_problem(table, row, error);
      continue;
    }
    const std::string& file = jobs[row].file;
    const auto [taken, is_new] =
        rows_by_file.emplace(std::filesystem::path(file).lexically_normal().string(), row);
    if (!is_new) {
      throw InputError(table.place(table.rows[row].front()),
                       "makes the same file as line " +
                           std::to_string(table.rows[taken->second].front().line) + ", " + file +
                           "; put {row} in -o's name");
    }
    scene::check_output(file);
  }
  return jobs;
}

class Batch {
 public:
  Batch(const Generate& command, const scene::SceneFile& scene, const scene::ValuesTable& table)
      : command_(command), scene_(scene), table_(table), jobs_(name_rows(table, command.output.file)) {}

  void run() {
    const std::size_t count = jobs_.size();
    Progress progress(command_.output.is_quiet);
    const auto on_progress = progress.callback();
    std::size_t next = 0;
    const auto number = [&](tbb::flow_control& control) {
      if (next < count) return next++;
      control.stop();
      return count;
    };
    const auto tell = [&](const RowOutcome& outcome) {
      if (!outcome.problem.empty()) {
        progress.clear();
        complain(outcome.problem);
      }
      add(outcome);
      if (on_progress) on_progress(static_cast<double>(outcome.row + 1) / static_cast<double>(count));
    };
    // More threads than the machine has must be allowed first, or TBB prints a warning and takes fewer.
    std::optional<tbb::global_control> allowed;
    if (command_.threads > 0) {
      allowed.emplace(tbb::global_control::max_allowed_parallelism,
                      static_cast<std::size_t>(command_.threads));
    }
    tbb::task_arena arena(command_.threads > 0 ? command_.threads : tbb::task_arena::automatic);
    arena.execute([&] {
      const auto threads = static_cast<std::size_t>(arena.max_concurrency());
      tbb::parallel_pipeline(kRowsInFlightPerThread * threads,
                             tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, number) &
                                 tbb::make_filter<std::size_t, RowOutcome>(
                                     tbb::filter_mode::parallel, [&](std::size_t row) { return make(row); }) &
                                 tbb::make_filter<RowOutcome, void>(tbb::filter_mode::serial_in_order, tell));
    });
  }

  // The table of rows for --json, the plan for --explain: parts that any row needs, with what all rows cost.
  Report report() const {
    const Output& output = command_.output;
    Report report;
    if (output.is_json) {
      report.facts = {{"rows", made_ + refused_},
                      {"made", output.file.empty() ? std::uint64_t{0} : made_},
                      {"refused", refused_}};
      report.tables.push_back(rows_);
    }
    if (output.explains) {
      report.tables.push_back(
          plan_table(plan_, output.file.empty() ? std::nullopt : std::optional(total_.ledger)));
    }
    return report;
  }

  std::uint64_t made() const { return made_; }
  std::uint64_t refused() const { return refused_; }
  const MadeFile& total() const { return total_; }

 private:
  RowOutcome make(std::size_t row) {
    RowOutcome outcome{.row = row, .problem = jobs_[row].problem};
    if (!outcome.problem.empty()) return outcome;
    try {
      const std::vector<scene::Setting> settings = settings_of(table_, table_.rows[row]);
      scene::Document document = scene_.document(settings);
      if (!command_.object.empty()) keep_object(document, command_.object);
      outcome.plan = scene::plan(document, model_request(jobs_[row].file, command_.gltf));
      if (jobs_[row].file.empty()) return outcome;
      if (!scene::is_mesh_name(jobs_[row].file)) scene::check_gltf_size(document, command_.gltf);
      scene::GltfOptions options = command_.gltf;
      options.images = &images_;
      options.threads = 1;  // rows are made side by side
      if (keeps_scene(command_, jobs_[row].file)) options.scene = scene_.text(settings);
      outcome.made = make_file(document, outcome.plan, jobs_[row].file, options, false);
    } catch (const InputError& error) {
      outcome.problem = row_problem(table_, row, error);
    }
    return outcome;
  }

  void add(const RowOutcome& outcome) {
    const bool is_made = outcome.problem.empty();
    if (command_.output.is_json) {
      const std::string& file = jobs_[outcome.row].file;
      rows_.rows.push_back({{"row", std::uint64_t{outcome.row + 1}},
                            {"line", static_cast<std::uint64_t>(table_.rows[outcome.row].front().line)},
                            {"file", file.empty() ? Value() : Value(file)},
                            {"made", is_made && !file.empty()},
                            {"triangles", outcome.made.triangles},
                            {"bytes", outcome.made.bytes},
                            {"problem", is_made ? Value() : Value(outcome.problem)}});
    }
    if (!is_made) {
      ++refused_;
      return;
    }
    for (std::size_t part = 0; part < scene::kPartCount; ++part) {
      const scene::Need& need = outcome.plan.needs[part];
      if (made_ == 0 || (need.is_needed && !plan_.needs[part].is_needed)) plan_.needs[part] = need;
    }
    ++made_;
    total_.objects += outcome.made.objects;
    total_.triangles += outcome.made.triangles;
    total_.bytes += outcome.made.bytes;
    total_.ledger.add(outcome.made.ledger);
  }

  const Generate& command_;
  const scene::SceneFile& scene_;
  const scene::ValuesTable& table_;
  std::vector<Job> jobs_;  // a row each
  scene::ImageStore images_;
  std::uint64_t made_ = 0;
  std::uint64_t refused_ = 0;
  MadeFile total_;
  scene::Plan plan_;
  Table rows_{"table", {}};
};

std::string rows_text(std::uint64_t count) {
  return std::to_string(count) + (count == 1 ? " row" : " rows");
}

}  // namespace

void generate_each(const Generate& command) {
  const auto start = std::chrono::steady_clock::now();
  const Output& output = command.output;
  const scene::ValuesTable table = scene::read_values_table(command.values);
  const scene::SceneFile scene = open_scene(command.input);
  scene::check_pointers(table, scene);
  Batch batch(command, scene, table);
  batch.run();
  if (output.is_json || output.explains) print(batch.report(), output);

  const std::string made = rows_text(batch.made()) + (output.file.empty() ? " read" : " made");
  if (batch.refused() > 0) {
    throw InputError({.file = table.file}, made + ", " + std::to_string(batch.refused()) + " refused");
  }
  if (output.file.empty()) return;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  say(table.file + ": " + made + ", " + std::to_string(batch.total().triangles) + " triangles, " +
          std::to_string(batch.total().bytes) + " bytes in " + duration_text(seconds),
      output);
}

}  // namespace sweepkit::tools
