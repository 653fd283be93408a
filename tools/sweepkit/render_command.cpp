// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <span>

#include "commands.hpp"
#include "findings.hpp"
#include "memory.hpp"
#include "plan_table.hpp"
#include "progress.hpp"
#include "render.hpp"
#include "render_statistics.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/output_file.hpp"
#include "sweepkit/scene/turntable.hpp"
#include "sweepkit/texmap/file_image.hpp"

namespace sweepkit::tools {
namespace {

using Clock = std::chrono::steady_clock;

// The pixels each way that share a ray in the stages of --progressive, before the picture itself.
constexpr std::array<int, 3> kPreviewSteps = {8, 4, 2};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// What is left of --time: less a little for what cannot be foreseen, and for encoding and writing the file,
// which takes about so long for a pixel.
std::function<double()> seconds_left(double seconds, Clock::time_point start, int width, int height) {
  constexpr double kSecondsAPixel = 2e-7;
  const double most = 0.97 * seconds - kSecondsAPixel * width * height;
  return [=] { return most - seconds_since(start); };
}

// "0.0123"
std::string error_text(double error) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", error);
  return text;
}

scene::Document read_document(const Render& command, const scene::SceneFile& scene) {
  scene::Document document = scene.document();
  if (!command.size.empty()) {
    const PixelSize size = parse_size(command.size);
    document.width = size.width;
    document.height = size.height;
  }
  if (std::int64_t{document.width} * document.height > kMostPixels) {
    throw InputError({.file = command.input.name(), .pointer = "/camera"},
                     "needs at most 2^28 pixels, got " + std::to_string(document.width) + " x " +
                         std::to_string(document.height) + "; give a smaller --size");
  }
  if (command.depth >= 0) document.depth = command.depth;
  return document;
}

// What image textures may hold, as far as their files tell: a file that cannot be read is told of when it is.
std::uint64_t texture_bytes(const scene::Document& document, const scene::Plan& plan) {
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < document.textures.size(); ++i) {
    if (!plan.sampled[i]) continue;
    try {
      const texmap::ImageFileInfo info =
          texmap::read_image_info(std::get<scene::ImageEntry>(document.textures[i].source).file);
      constexpr std::uint64_t kBytesATexel = 8;  // a tile's
      bytes +=
          kBytesATexel * static_cast<std::uint64_t>(info.width) * static_cast<std::uint64_t>(info.height);
    } catch (const InputError&) {
    }
  }
  return std::min<std::uint64_t>(bytes, plan.texture_memory);
}

// Refuses a scene that there is no memory for: before it is built what its counts of cells say, and while it
// is built what a tolerance has come to.
scene::Model build(const Render& command, scene::Document& document, const scene::Plan& plan) {
  scene::MemoryEstimate needed = scene::estimate_memory(document);
  const auto require = [&] {
    require_memory(command.input.name(), needed,
                   render::estimate_memory(needed, document.width, document.height, command.options) +
                       texture_bytes(document, plan));
  };
  require();
  limit_triangles(document, render::bytes_a_triangle(command.options.accelerator));
  scene::Model model = scene::build(document, plan);
  needed = {.objects = model.scene.objects.size()};
  for (const scene::MeshView& mesh : model.scene.meshes) needed.triangles += mesh.triangles.size();
  require();
  return model;
}

scene::Plan make_plan(const Render& command, const scene::Document& document) {
  const render::Options& options = command.options;
  return scene::plan(document, {.product = scene::Request::Product::kPicture,
                                .filter = options.filter,
                                .texture_memory = command.texture_megabytes << 20,
                                .is_supersampled = options.supersampling > 1,
                                .is_refined = options.adaptive.has_value() || options.goal.has_value(),
                                .estimates_error = options.estimates_error,
                                .has_smooth_shadows = options.shadows == render::Shadows::kSmooth,
                                .has_layers = !options.layers.empty(),
                                .shows_texcoords = std::ranges::find(options.layers, render::Layer::kUv) !=
                                                   options.layers.end(),
                                .has_neighbours = options.footprint != render::Footprint::kDifferentials,
                                .has_differentials = options.footprint != render::Footprint::kNeighbours,
                                .leaves_out = !command.leaves_nothing_out});
}

// Gives the jobs their marks, and takes those out whose files are there already with the same.
void mark_jobs(const Render& command, RenderRequest& request, const scene::SceneFile& scene,
               PictureMark mark) {
  mark.key = scene.content_hash(command.key_options);
  mark.tile = request.tile;
  mark.is_whole_marked = !command.frames.empty() || command.skips_existing;
  for (PictureJob& job : request.jobs) {
    mark.turn = job.turn;
    job.description = to_text(mark);
  }
  if (!command.skips_existing) return;
  std::erase_if(request.jobs, [](const PictureJob& job) {
    return std::ranges::all_of(job.names, [&](const std::string& name) {
      return texmap::read_description(name) == job.description;
    });
  });
}

// Draws the jobs one after another and writes each as soon as it is whole.
class PictureWriter {
 public:
  PictureWriter(const Render& command, const RenderRequest& request, const scene::Plan& plan, Phases& phases,
                Clock::time_point start)
      : command_(command), request_(request), plan_(plan), phases_(phases), start_(start) {}

  void draw(scene::Model& model, const scene::Document& document) {
    if (!request_.jobs.empty()) {
      Progress progress(command_.output.is_quiet);
      progress_ = &progress;
      render::Options options = command_.options;
      if (const auto on_progress = progress.callback()) {
        options.on_progress = [this, on_progress](double done) {
          on_progress((work_done_ + done * work_) / all_work());
        };
      }
      const render::Renderer renderer(model.scene, plan_, options);
      phases_.end(Phase::kAccelerators);
      const scene::Camera camera = model.scene.camera;
      for (std::size_t i = 0; i < request_.jobs.size(); ++i) {
        const PictureJob& job = request_.jobs[i];
        // The remainder first, so that a full turn is exactly none.
        if (job.turn) {
          const int step = job.turn->frame % job.turn->count;
          scene::look_from(model.scene, document, turned(camera, 360.0 * step / job.turn->count));
        }
        if (command_.is_progressive) {
          for (const int step : kPreviewSteps) draw_stage(renderer, job, step);
        }
        draw_picture(renderer, job, i + 1 == request_.jobs.size(), model.ledger);
      }
      progress_ = nullptr;
    } else if (!command_.statistics.empty()) {
      scene::StagedFiles files;
      add_statistics(files, model.ledger);
      files.put_in_place();
    }
  }

  const RenderTotal& total() const { return total_; }

 private:
  // In eye rays a pixel.
  double work_of(int step) const {
    const int n = command_.options.supersampling;
    return step > 1 ? 1.0 / (step * step) : static_cast<double>(n * n);
  }
  double all_work() const {
    double work = work_of(1);
    for (std::size_t i = 0; command_.is_progressive && i < kPreviewSteps.size(); ++i)
      work += work_of(kPreviewSteps[i]);
    return work * static_cast<double>(request_.jobs.size());
  }

  std::vector<EncodedFile> draw_files(const render::Renderer& renderer, const PictureJob& job, int step) {
    work_ = work_of(step);
    render::Picture picture = renderer.draw(step);
    work_done_ += work_;
    total_.add(picture);
    phases_.end(Phase::kPicture);
    // A preview is not what its mark would say.
    std::vector<EncodedFile> files = encode_picture(std::move(picture), job.file, request_.encoding,
                                                    step > 1 ? std::string() : job.description);
    phases_.end(Phase::kEncoding);
    return files;
  }

  void draw_stage(const render::Renderer& renderer, const PictureJob& job, int step) {
    const std::vector<EncodedFile> files = draw_files(renderer, job, step);
    scene::StagedFiles staged;
    for (const EncodedFile& file : files) staged.add({file.name, file.bytes});
    staged.put_in_place();
    phases_.end(Phase::kWriting);
    progress_->clear();
    say(job.file + ": a preview by a ray for each " + std::to_string(step) + " x " + std::to_string(step) +
            " pixels",
        command_.output);
  }

  void draw_picture(const render::Renderer& renderer, const PictureJob& job, bool is_last,
                    const scene::Ledger& built) {
    const std::vector<EncodedFile> files = draw_files(renderer, job, 1);
    scene::StagedFiles staged;
    for (const EncodedFile& file : files) staged.add({file.name, file.bytes});
    phases_.end(Phase::kWriting);
    if (is_last && !command_.statistics.empty()) add_statistics(staged, built);
    staged.put_in_place();
  }

  void add_statistics(scene::StagedFiles& files, const scene::Ledger& built) {
    RenderTotal total = total_;
    total.ledger.add(built);
    statistics_ = to_json(statistics_report(total, phases_, plan_, seconds_since(start_)));
    files.add({command_.statistics, std::as_bytes(std::span(statistics_))});
  }

  const Render& command_;
  const RenderRequest& request_;
  const scene::Plan& plan_;
  Phases& phases_;
  Clock::time_point start_;
  Progress* progress_ = nullptr;  // while pictures are drawn
  RenderTotal total_;
  std::string statistics_;
  double work_ = 0;  // of the picture being drawn
  double work_done_ = 0;
};

void draw(Render& command) {
  const Clock::time_point start = Clock::now();
  const Output& output = command.output;
  Phases phases;
  RenderRequest request = read_request(command);
  const scene::SceneFile scene = open_scene(command.input);
  scene::Document document = read_document(command, scene);
  const render::Region whole = area_of(document.width, document.height, request.crop);
  const render::Region part = request.tile ? part_of(whole, *request.tile) : whole;
  if (request.crop || request.tile) {
    command.options.crop = part;
    request.encoding.window = {part.x, part.y, document.width, document.height};
  }
  if (command.most_seconds > 0 && !output.file.empty()) {
    command.options.goal->seconds_left = seconds_left(command.most_seconds, start, part.width, part.height);
    texmap::load_image_module();
  }
  const scene::Plan plan = make_plan(command, document);
  if (output.file.empty()) {
    print({{}, {plan_table(plan, {})}}, output);
    return;
  }
  const std::size_t wanted = request.jobs.size();
  if (request.is_marked) {
    mark_jobs(command, request, scene, {.width = document.width, .height = document.height, .area = whole});
  }
  phases.end(Phase::kReading);
  PictureWriter writer(command, request, plan, phases, start);
  scene::Model model;
  if (!request.jobs.empty()) {
    model = build(command, document, plan);
    phases.end(Phase::kMeshes, model.mesh_seconds);
    phases.end(Phase::kTextures, model.texture_seconds);
    if (!output.is_quiet) warn(scene::check(document, model, scene::Thoroughness::kQuick), output);
  }
  writer.draw(model, document);

  if (output.explains) {
    scene::Ledger ledger = model.ledger;
    ledger.add(writer.total().ledger);
    print({{}, {plan_table(plan, ledger)}}, output);
  }
  const std::string seconds = duration_text(seconds_since(start));
  const RenderTotal& total = writer.total();
  const std::string error = total.estimates > 0 ? ", error about " + error_text(total.error.rmse) : "";
  const std::string name = output.is_standard() ? "standard output" : output.file;
  const std::string pixels = std::to_string(part.width) + " x " + std::to_string(part.height) + " pixels";
  const std::size_t drawn = request.jobs.size();
  if (!command.frames.empty()) {
    say(name + ": " + std::to_string(drawn) + (drawn == 1 ? " frame" : " frames") + " of " + pixels +
            (drawn < wanted ? ", " + std::to_string(wanted - drawn) + " there already," : "") + " in " +
            seconds + error,
        output);
  } else {
    say(name + ": " + (drawn > 0 ? pixels + " in " + seconds + error : "is there already"), output);
  }
  if (command.most_error > 0 && total.error.rmse > 1.1 * command.most_error) {
    say(name + ": --error " + error_text(command.most_error) + " takes more than " +
            std::to_string(render::kMostRefiningRays) + " rays a pixel, the most there are",
        output);
  }
  if (command.most_seconds > 0 && drawn > 0 && total.statistics.refining_rays == 0 &&
      seconds_since(start) > 1.2 * command.most_seconds) {
    say(name + ": --time " + error_text(command.most_seconds) +
            " s is less than the picture takes by one ray a pixel",
        output);
  }
}

}  // namespace

void add_render(CLI::App& app) {
  const auto command = std::make_shared<Render>();
  CLI::App& sub = *app.add_subcommand("render", "Draw the scene as a picture by ray tracing");
  add_render_options(sub, *command);
  sub.callback([command, &sub] {
    command->key_options = options_of_picture(sub);
    draw(*command);
  });
}

}  // namespace sweepkit::tools
