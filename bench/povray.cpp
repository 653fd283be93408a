// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Error against time beside POV-Ray 3.7: the same scene, two threads each, each program measured against its
// own reference under a box of one pixel, RMSE in linear light. POV-Ray's time is its render phase alone, as
// its statistics tell it; ours is everything after the meshes are in memory. Ends with 1 where not one of
// our ways reaches the error of POV-Ray's adaptive antialiasing at least 20 times faster.
//
// Usage: povray SCENE FOLDER [SAMPLES]    SAMPLES a pixel of the references: 64, 256, or 1,024 unless said
//
// FOLDER gets povray.csv, both pictures side by side, and what was drawn. The references take minutes and are
// kept there: they are read again, not drawn again.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness.hpp"
#include "povray_scene.hpp"
#include "sweepkit/render/render.hpp"
#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/output_file.hpp"
#include "sweepkit/scene/plan.hpp"
#include "sweepkit/texmap/image_error.hpp"
#include "sweepkit/texmap/image_file.hpp"

namespace {

using namespace sweepkit;
namespace fs = std::filesystem;

constexpr int kRounds = 3;
constexpr int kThreads = 2;
constexpr double kLeastGain = 20;
constexpr int kPassSide = 8;  // of the squares of samples that POV-Ray's reference is drawn by

struct Timed {
  texmap::Image image;
  double seconds = 0;
};

struct Way {
  std::string name;
  std::string povray;       // its options, or
  render::Options options;  // ours

  bool is_povray() const { return !povray.empty(); }
};

std::string read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// "Trace Time:       0 hours  0 minutes  1 seconds (1.045 seconds)"
double trace_seconds(const std::string& report) {
  const std::size_t line = report.find("Trace Time:");
  const std::size_t at = line == std::string::npos ? line : report.find('(', line);
  if (at == std::string::npos) throw std::runtime_error("POV-Ray told no trace time");
  return std::strtod(report.c_str() + at + 1, nullptr);
}

// Draws scene.inc in `folder` with a camera and options.
Timed run_povray(const fs::path& folder, const std::string& camera, const std::string& options, int width,
                 int height) {
  std::ofstream(folder / "scene.pov") << camera << "#include \"scene.inc\"\n";
  const std::string command = "cd '" + folder.string() + "' && povray -V +Iscene.pov +Oscene.exr +FE -D +WT" +
                              std::to_string(kThreads) + " +W" + std::to_string(width) + " +H" +
                              std::to_string(height) + " " + options + " >povray.log 2>&1 </dev/null";
  const int status = std::system(command.c_str());
  const std::string report = read_text(folder / "povray.log");
  if (status != 0)
    throw std::runtime_error("POV-Ray failed: " +
                             report.substr(report.size() - std::min<std::size_t>(report.size(), 400)));
  return {texmap::read_image(folder / "scene.exr", texmap::ColorSpace::kLinear), trace_seconds(report)};
}

Timed run_ours(const scene::Document& document, const scene::Model& model, const render::Options& options) {
  const scene::Plan plan =
      scene::plan(document, {.product = scene::Request::Product::kPicture,
                             .filter = options.filter,
                             .is_supersampled = options.supersampling > 1,
                             .is_refined = options.adaptive.has_value(),
                             .has_smooth_shadows = options.shadows == render::Shadows::kSmooth,
                             .has_differentials = options.footprint != render::Footprint::kNeighbours});
  render::Picture picture = render::render(model.scene, plan, options);
  return {std::move(picture.image), picture.statistics.build_seconds + picture.statistics.picture_seconds};
}

texmap::Image read_floats(const fs::path& file, int width, int height) {
  texmap::Image image = texmap::make_float_image(width, height);
  auto& texels = std::get<std::vector<float>>(image.texels);
  std::ifstream in(file, std::ios::binary);
  in.read(reinterpret_cast<char*>(texels.data()),
          static_cast<std::streamsize>(texels.size() * sizeof(float)));
  if (!in) throw std::runtime_error(file.string() + " is cut short; remove it");
  return image;
}
void write_floats(const fs::path& file, const texmap::Image& image) {
  const auto& texels = std::get<std::vector<float>>(image.texels);
  const fs::path part = file.string() + ".part";
  std::ofstream(part, std::ios::binary)
      .write(reinterpret_cast<const char*>(texels.data()),
             static_cast<std::streamsize>(texels.size() * sizeof(float)));
  fs::rename(part, file);
}

// The means of squares of pixels, side x side.
texmap::Image shrunk(const texmap::Image& large, int side) {
  texmap::Image small = texmap::make_float_image(large.width / side, large.height / side);
  auto* out = std::get<std::vector<float>>(small.texels).data();
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      glm::dvec3 sum(0.0);
      for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) sum += glm::dvec3(large.color(x * side + i, y * side + j));
      }
      for (glm::length_t k = 0; k < 3; ++k) *out++ = static_cast<float>(sum[k] / (side * side));
    }
  }
  return small;
}

// Squares of 8 x 8 samples, moved by parts of a sample's step against each other, so that all together lie on
// one even grid.
texmap::Image povray_reference(const fs::path& folder, const scene::Scene& scene, int samples) {
  const int shifts = static_cast<int>(std::lround(std::sqrt(samples))) / kPassSide;
  texmap::Image mean = texmap::make_float_image(scene.width, scene.height);
  auto& sums = std::get<std::vector<float>>(mean.texels);
  for (int pass = 0; pass < shifts * shifts; ++pass) {
    const fs::path file =
        folder / ("povray_reference_" + std::to_string(shifts) + "_" + std::to_string(pass) + ".f32");
    if (!fs::exists(file)) {
      std::fprintf(stderr, "povray: reference, pass %d of %d\n", pass + 1, shifts * shifts);
      const glm::dvec2 shift =
          ((glm::dvec2(pass % shifts, pass / shifts) + 0.5) / (1.0 * shifts) - 0.5) / (1.0 * kPassSide);
      write_floats(file, shrunk(run_povray(folder, bench::povray_camera(scene, shift), "-A",
                                           kPassSide * scene.width, kPassSide * scene.height)
                                    .image,
                                kPassSide));
    }
    const texmap::Image drawn = read_floats(file, scene.width, scene.height);
    const auto& texels = std::get<std::vector<float>>(drawn.texels);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += texels[i] / static_cast<float>(shifts * shifts);
  }
  return mean;
}

texmap::Image our_reference(const fs::path& folder, const scene::Document& document,
                            const scene::Model& model, int samples) {
  const fs::path file = folder / ("sweepkit_reference_" + std::to_string(samples) + ".f32");
  if (!fs::exists(file)) {
    std::fprintf(stderr, "povray: our reference\n");
    const int side = static_cast<int>(std::lround(std::sqrt(samples)));
    write_floats(file,
                 run_ours(document, model,
                          {.filter = render::Filter::kPoint, .supersampling = side, .threads = kThreads})
                     .image);
  }
  return read_floats(file, model.scene.width, model.scene.height);
}

void write_side_by_side(const fs::path& file, const texmap::Image& left, const texmap::Image& right) {
  texmap::Image both = texmap::make_float_image(2 * left.width, left.height);
  auto* out = std::get<std::vector<float>>(both.texels).data();
  for (int y = 0; y < left.height; ++y) {
    for (int x = 0; x < 2 * left.width; ++x) {
      const glm::vec3 color = x < left.width ? left.color(x, y) : right.color(x - left.width, y);
      for (glm::length_t k = 0; k < 3; ++k) *out++ = color[k];
    }
  }
  const std::vector<std::byte> bytes = texmap::encode_image(both, texmap::image_format(file));
  scene::write_files(std::vector<scene::OutputFile>{{file, bytes}});
}

}  // namespace

int main(int argc, char** argv) {
  const int samples = argc == 4 ? std::atoi(argv[3]) : 1024;
  if (argc < 3 || argc > 4 || (samples != 64 && samples != 256 && samples != 1024)) {
    std::fprintf(stderr, "usage: povray SCENE FOLDER [64|256|1024]\n");
    return 2;
  }
  if (std::system("command -v povray >/dev/null") != 0) {
    std::fprintf(stderr, "povray: SKIPPED: POV-Ray is not installed (scripts/setup --peers)\n");
    return 0;
  }
  try {
    const fs::path folder = fs::absolute(argv[2]);
    fs::create_directories(folder);
    const scene::Document document = scene::read_document(argv[1]);
    const scene::Model model =
        scene::build(document, scene::plan(document, {.product = scene::Request::Product::kPicture,
                                                      .filter = render::Filter::kAuto,
                                                      .has_differentials = true}));
    const scene::Scene& scene = model.scene;
    std::ofstream(folder / "scene.inc") << bench::povray_scene(document, scene);

    const std::vector<Way> ways = {
        {"povray off", "-A", {}},
        {"povray adaptive (+A0.1 +AM1 +R3)", "+A0.1 +AM1 +R3", {}},
        {"povray adaptive (+A0.1 +AM1 +R3 -J)", "+A0.1 +AM1 +R3 -J", {}},
        {"povray uniform (+A0.0 +AM1 +R3 -J)", "+A0.0 +AM1 +R3 -J", {}},
        {"sweepkit point", "", {.filter = render::Filter::kPoint, .threads = kThreads}},
        {"sweepkit off", "", {.threads = kThreads}},
        {"sweepkit adaptive 1", "", {.adaptive = render::Adaptive{.contrast = 1}, .threads = kThreads}},
        {"sweepkit adaptive 0.5", "", {.adaptive = render::Adaptive{.contrast = 0.5}, .threads = kThreads}},
        {"sweepkit adaptive 0.24", "", {.adaptive = render::Adaptive{.contrast = 0.24}, .threads = kThreads}},
        {"sweepkit adaptive 0.12", "", {.adaptive = render::Adaptive{.contrast = 0.12}, .threads = kThreads}},
        {"sweepkit adaptive 0.03", "", {.adaptive = render::Adaptive{}, .threads = kThreads}},
        {"sweepkit 2x2", "", {.supersampling = 2, .threads = kThreads}},
        {"sweepkit 3x3", "", {.supersampling = 3, .threads = kThreads}},
    };
    constexpr std::size_t kPeer = 1;

    std::vector<Timed> drawn(ways.size());
    std::vector<std::vector<double>> seconds(ways.size());
    for (int round = 0; round < kRounds; ++round) {
      for (std::size_t i = 0; i < ways.size(); ++i) {
        const std::size_t turn = round % 2 == 0 ? i : ways.size() - 1 - i;
        const Way& way = ways[turn];
        drawn[turn] = way.is_povray() ? run_povray(folder, bench::povray_camera(scene, glm::dvec2(0.0)),
                                                   way.povray, scene.width, scene.height)
                                      : run_ours(document, model, way.options);
        seconds[turn].push_back(drawn[turn].seconds);
      }
    }
    const texmap::Image povray = povray_reference(folder, scene, samples);
    const texmap::Image ours = our_reference(folder, document, model, samples);
    write_side_by_side(folder / "side_by_side.png", povray, ours);

    std::string csv = "way,seconds_median,seconds_min,seconds_max,rmse\n";
    std::vector<double> rmse;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      rmse.push_back(texmap::rmse(drawn[i].image, ways[i].is_povray() ? povray : ours));
      const bench::Spread spread = bench::spread(seconds[i]);
      char line[200];
      std::snprintf(line, sizeof line, "%s,%.4f,%.4f,%.4f,%.5f\n", ways[i].name.c_str(), spread.median,
                    spread.min, spread.max, rmse.back());
      csv += line;
    }
    std::ofstream(folder / "povray.csv") << csv;
    std::fputs(csv.c_str(), stdout);
    std::printf("# the two references, %d samples a pixel, differ by an RMSE of %.5f\n", samples,
                texmap::rmse(ours, povray));
    double best = 0;
    std::size_t fastest = 0;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (ways[i].is_povray() || rmse[i] > rmse[kPeer]) continue;
      std::vector<double> gains;  // of the same round
      for (std::size_t round = 0; round < seconds[i].size(); ++round)
        gains.push_back(seconds[kPeer][round] / seconds[i][round]);
      const double gain = bench::spread(gains).median;
      if (gain <= best) continue;
      best = gain;
      fastest = i;
    }
    const bool holds = best >= kLeastGain;
    std::printf("# %s's error: reached by %s %.1f times faster%s\n", ways[kPeer].name.c_str(),
                best > 0 ? ways[fastest].name.c_str() : "none", best, holds ? "" : ": NOT AS CLAIMED (20)");
    return holds ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "povray: %s\n", error.what());
    return 1;
  }
}
