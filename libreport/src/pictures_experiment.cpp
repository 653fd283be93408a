// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// What [Akdemir98] tells of its pictures is their time alone: 15 minutes point sampled, 20 filtered.

#include "pictures_experiment.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "equal_error.hpp"
#include "picture_methods.hpp"
#include "picture_scene.hpp"
#include "scene_files.hpp"
#include "sweepkit/texmap/image_error.hpp"
#include "timing.hpp"

namespace sweepkit::report {
namespace {

constexpr int kRounds = 5;

struct Drawn {
  double first_seconds = 0;     // with what is built before
  std::vector<double> seconds;  // one a round
  double rays_a_pixel = 0;
  double rmse = 0;
  double psnr_db = 0;
  double flip = 0;
  Cell rmse_floor;
  Cell rmse_mirror;
};

// Of one thread's processor, so that another program on the machine counts little.
double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Judge {
 public:
  Judge(const PictureScene& scene, int reference_side) {
    render::Options options = plain_options(reference_side);
    options.threads = 0;
    reference_ = draw(scene, options).image;
    const auto has = [&](const char* name) {
      return std::any_of(scene.document.objects.begin(), scene.document.objects.end(),
                         [&](const scene::ObjectEntry& one) { return one.name == name; });
    };
    if (!has(kPaperFloor) || !has(kPaperMirror)) return;
    floor_ = mask_of(scene, kPaperFloor);
    mirror_ = mask_of(scene, kPaperMirror);
  }

  void judge(const render::Picture& picture, Drawn& drawn) const {
    const texmap::Image& image = picture.image;
    drawn.rays_a_pixel =
        static_cast<double>(picture.statistics.eye_rays) / (1.0 * image.width * image.height);
    drawn.rmse = texmap::rmse(image, reference_);
    drawn.psnr_db = texmap::psnr(image, reference_);
    drawn.flip = texmap::mean_flip(image, reference_);
    drawn.rmse_floor = floor_.empty() ? Cell("") : Cell(texmap::rmse(image, reference_, floor_));
    drawn.rmse_mirror = mirror_.empty() ? Cell("") : Cell(texmap::rmse(image, reference_, mirror_));
  }

 private:
  texmap::Image reference_;
  std::vector<std::uint8_t> floor_;
  std::vector<std::uint8_t> mirror_;
};

// All methods in turn, every other round backwards, after one that warms up and is looked at.
std::vector<Drawn> draw_all(const PictureScene& scene, const std::vector<PictureMethod>& methods,
                            const Judge& judge, const std::function<void(double)>& tell) {
  std::vector<Drawn> all(methods.size());
  std::vector<render::Renderer> renderers;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const render::Options& options = methods[i].options;
    const double start = processor_seconds();
    renderers.emplace_back(scene.model.scene, plan_for(scene.document, options), options);
    const render::Picture picture = renderers.back().draw();
    all[i].first_seconds = processor_seconds() - start;
    judge.judge(picture, all[i]);
  }
  for (int round = 0; round < kRounds; ++round) {
    tell((round + 1.0) / (kRounds + 1));
    for (std::size_t turn = 0; turn < methods.size(); ++turn) {
      const std::size_t i = round % 2 == 0 ? turn : methods.size() - 1 - turn;
      const double start = processor_seconds();
      keep(renderers[i].draw());
      all[i].seconds.push_back(processor_seconds() - start);
    }
  }
  return all;
}

// The samples' error fell by so much from a quarter of them to all; it falls as much again and again up to
// the reference's.
double error_of_reference(const std::vector<PictureMethod>& methods, const std::vector<Drawn>& all,
                          int reference_side) {
  double last = 0;
  double before = 0;
  int side = 0;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    if (methods[i].filter != "plain") continue;
    before = last;
    last = all[i].rmse;
    side = methods[i].options.supersampling;
  }
  return last * std::pow(last / before, std::log2(static_cast<double>(reference_side) / side));
}

void add_rows(const std::string& scene, const std::vector<PictureMethod>& methods,
              const std::vector<Drawn>& all, double reference_error, Table& table) {
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const Drawn& one = all[i];
    std::vector<Cell> row{scene,
                          methods[i].filter,
                          methods[i].antialiasing,
                          methods[i].setting,
                          one.rays_a_pixel,
                          one.rmse,
                          one.psnr_db,
                          one.flip,
                          one.rmse_floor,
                          one.rmse_mirror,
                          reference_error,
                          one.first_seconds};
    add_timing(row, timing_of(one.seconds));
    table.rows.push_back(std::move(row));
  }
}

void add_speedups(const std::string& scene, const std::vector<PictureMethod>& methods,
                  const std::vector<Drawn>& all, Table& table) {
  const auto those = [&](const std::string& antialiasing) {
    std::vector<ErrorAtTime> some;
    for (std::size_t i = 0; i < methods.size(); ++i) {
      if (methods[i].antialiasing == antialiasing)
        some.push_back({timing_of(all[i].seconds).median, all[i].psnr_db});
    }
    return some;
  };
  const std::vector<ErrorAtTime> plain = those("plain");
  for (const std::string antialiasing : {"off", "3x3", "adaptive", "plain"}) {
    const std::vector<ErrorAtTime> some = those(antialiasing);
    for (const double psnr_db : {20.0, 25.0, 30.0, 35.0, 40.0}) {
      const double plain_seconds = seconds_to_reach(plain, psnr_db);
      const double seconds = antialiasing == "plain" ? plain_seconds : least_seconds(some, psnr_db);
      table.rows.push_back({scene, antialiasing, psnr_db, plain_seconds, seconds, plain_seconds / seconds});
    }
  }
}

Experiment make_speedups() {
  return {.name = "speedups",
          .title = "Whole pictures: time to reach an error",
          .what =
              "How long, and how many times faster, a picture reaches an error (PSNR in linear light) than "
              "plain point "
              "samples do, of the fastest filter that reaches it. Failed where one of the two never does.",
          .how =
              "From the table of whole pictures. The plain samples' time is interpolated between their "
              "numbers, in the logarithms; ours is that of a setting that was drawn.",
          .table = {.columns = {{"scene", "scene"},
                                {"antialiasing", "antialiasing"},
                                {"psnr_db", "error to reach (dB)"},
                                {"plain_seconds", "plain samples' time (s)"},
                                {"seconds", "time (s)"},
                                {"speedup", "speed-up"}}}};
}

Experiment make_cost() {
  return {
      .name = "cost",
      .title = "Whole pictures: what filtering costs",
      .what =
          "The time of a whole picture over that of the same point sampled with one ray a pixel. The "
          "paper tells 15 minutes point sampled and 20 filtered, on its machine of 1998.",
      .how =
          "From the table of whole pictures; the ratio is taken round by round, and its median is "
          "shown with the range.",
      .table = {.columns = {{"scene", "scene"},
                            {"filter", "filter"},
                            {"setting", "antialiasing"},
                            {"ratio", "time over point sampling's"},
                            {"ratio_least", "least"},
                            {"ratio_most", "most"}},
                .rows = {{"the paper's own", "the paper's box", "off", 20.0 / 15, 20.0 / 15, 20.0 / 15}}}};
}

void add_cost(const std::string& scene, const std::vector<PictureMethod>& methods,
              const std::vector<Drawn>& all, Table& table) {
  for (std::size_t i = 1; i < methods.size(); ++i) {
    if (methods[i].antialiasing != "off" && methods[i].antialiasing != "3x3") continue;
    std::vector<double> ratios;
    for (std::size_t round = 0; round < all[i].seconds.size(); ++round)
      ratios.push_back(all[i].seconds[round] / all[0].seconds[round]);
    const Timing ratio = timing_of(ratios);
    table.rows.push_back(
        {scene, methods[i].filter, methods[i].setting, ratio.median, ratio.least, ratio.most});
  }
}

Plot error_plot(const std::string& scene, const std::string& y, const std::string& title) {
  return {.name = "pictures_" + file_name(scene) + (y == "rmse" ? "" : "_" + y),
          .title = title,
          .x = "seconds",
          .y = y,
          .by = "filter",
          .only = "scene",
          .only_is = scene,
          .label = "setting",
          .has_front = true};
}

}  // namespace

Experiment measure_pictures(const Effort& effort) {
  const int side = effort.is_quick ? 20 : 64;
  const int reference_side = effort.is_quick ? 32 : 64;
  const std::string pixels = std::to_string(side);
  Experiment experiment{
      .name = "pictures",
      .title = "Whole pictures",
      .what =
          "Root mean square error in linear light, PSNR and FLIP of pictures of " + pixels + " x " + pixels +
          " pixels, against " + std::to_string(reference_side * reference_side) +
          " point samples a pixel under a box of one pixel, whose own error is extrapolated from the plain "
          "samples'. The pictures are small because the reference takes most of the run. Of the paper's "
          "scene also on its floor alone and inside its mirror alone.",
      .how =
          "A picture drawn again: accelerators, and tables and tiles of textures, are there from the first "
          "time, "
          "whose whole time stands beside, since a small picture would not tell it from drawing. Processor "
          "time of one thread, five rounds over all methods in turn. "
          "'plain' is so many point samples a pixel, hard shadows; 'the paper's box' is a summed-area table "
          "over the eight neighbours' hits."};
  Table& table = experiment.table;
  table.columns = {{"scene", "scene"},
                   {"filter", "filter"},
                   {"antialiasing", "antialiasing"},
                   {"setting", "antialiasing"},
                   {"rays_a_pixel", "eye rays a pixel"},
                   {"rmse", "RMSE, linear light"},
                   {"psnr_db", "PSNR (dB)"},
                   {"flip", "mean FLIP"},
                   {"rmse_floor", "RMSE on the floor"},
                   {"rmse_mirror", "RMSE inside the mirror"},
                   {"reference_rmse", "the reference's own RMSE, about"},
                   {"first_seconds", "time for the first picture, everything built (s)"}};
  for (Column& column : timing_columns("one picture")) table.columns.push_back(std::move(column));
  Experiment speedups = make_speedups();
  Experiment cost = make_cost();
  const std::vector<PictureMethod> methods = picture_methods(effort.is_quick);
  const std::vector<SceneFile> scenes =
      scene_files(effort, {kPaperScene, "trefoil_knot", "seashell", "picture_frame", "bottle"});
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto tell = [&](double done) {
      effort.tell((static_cast<double>(i) + done) / static_cast<double>(scenes.size()));
    };
    tell(0);
    const std::string& name = scenes[i].name;
    const PictureScene scene = read_scene(scenes[i].file, side);
    const Judge judge(scene, reference_side);
    const std::vector<Drawn> all =
        draw_all(scene, methods, judge, [&](double done) { tell(0.4 + 0.6 * done); });
    add_rows(name, methods, all, error_of_reference(methods, all, reference_side), table);
    add_speedups(name, methods, all, speedups.table);
    add_cost(name, methods, all, cost.table);
    experiment.plots.push_back(error_plot(name, "rmse", name));
    experiment.plots.push_back(error_plot(name, "flip", name + ", FLIP"));
    if (std::holds_alternative<double>(all[0].rmse_floor)) {
      experiment.plots.push_back(error_plot(name, "rmse_floor", name + ", on the floor"));
      experiment.plots.push_back(error_plot(name, "rmse_mirror", name + ", inside the mirror"));
    }
    speedups.plots.push_back({.name = "speedups_" + file_name(name),
                              .title = name,
                              .x = "psnr_db",
                              .y = "seconds",
                              .by = "antialiasing",
                              .only = "scene",
                              .only_is = name,
                              .is_x_log = false});
  }
  experiment.derived = {std::move(speedups), std::move(cost)};
  return experiment;
}

}  // namespace sweepkit::report
