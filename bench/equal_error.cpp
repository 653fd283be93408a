// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Error against time: RMSE in linear light and mean FLIP of every way of drawing a scene, against a reference
// of 32 x 32 point samples a pixel under a box of one pixel, and the seconds that one thread takes for the
// picture, accelerators built, everything shaded. Times are the processor's, so that another program on the
// machine counts little.
//
// Usage: equal_error SCENE FOLDER [ROUNDS]    writes FOLDER/equal_error.{csv,svg}; keeps the reference there
//
// Ends with 1 unless the best setting reaches the error of 64 plain samples a pixel in a tenth of their time.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "error_plot.hpp"
#include "harness.hpp"
#include "picture_scene.hpp"
#include "sweepkit/scene/document.hpp"
#include "sweepkit/texmap/image_error.hpp"

namespace {

using namespace sweepkit;
using namespace sweepkit::report;

constexpr int kReferenceSide = 32;
constexpr double kLongRun = 30;  // seconds; what takes longer is drawn once

enum class Kind { kOneRay, kUniform, kAdaptive, kPlain };

struct Method {
  std::string name;
  Kind kind;
  render::Options options;
};

std::vector<Method> methods() {
  using render::Filter;
  std::vector<Method> all = {
      {"point", Kind::kOneRay, {.filter = Filter::kPoint}},
      {"paper", Kind::kOneRay, {.filter = Filter::kIntegral1, .footprint = render::Footprint::kNeighbours}},
      {"trilinear", Kind::kOneRay, {.filter = Filter::kTrilinear}},
      {"integral-1", Kind::kOneRay, {.filter = Filter::kIntegral1}},
      {"integral-2", Kind::kOneRay, {.filter = Filter::kIntegral2}},
      {"ewa", Kind::kOneRay, {.filter = Filter::kEwa}},
      {"auto", Kind::kOneRay, {}},
      {"auto, hard shadows", Kind::kOneRay, {.shadows = render::Shadows::kHard}},
      {"box", Kind::kOneRay, {.filter = Filter::kBox}},
      {"3x3, paper's filter",
       Kind::kUniform,
       {.filter = Filter::kIntegral1, .footprint = render::Footprint::kNeighbours, .supersampling = 3}},
      {"3x3", Kind::kUniform, {.supersampling = 3}}};
  for (const double contrast : {0.24, 0.12, 0.06, 0.04, 0.03, 0.02, 0.01}) {
    char name[32];
    std::snprintf(name, sizeof name, "adaptive %g", contrast);
    all.push_back({name, Kind::kAdaptive, {.adaptive = render::Adaptive{.contrast = contrast}}});
  }
  for (const int side : {2, 4, 8, 16}) {
    all.push_back({"plain " + std::to_string(side * side),
                   Kind::kPlain,
                   {.filter = Filter::kPoint, .supersampling = side, .shadows = render::Shadows::kHard}});
  }
  return all;
}

// The floats of the reference as they are; a file of another size is none.
texmap::Image reference_in(const std::filesystem::path& file, const PictureScene& scene) {
  texmap::Image image = texmap::make_float_image(scene.document.width, scene.document.height);
  auto& texels = std::get<std::vector<float>>(image.texels);
  const auto bytes = static_cast<std::streamsize>(texels.size() * sizeof(float));
  std::error_code error;
  if (std::filesystem::file_size(file, error) == static_cast<std::uintmax_t>(bytes) && !error) {
    std::ifstream(file, std::ios::binary).read(reinterpret_cast<char*>(texels.data()), bytes);
    return image;
  }
  image = draw(scene, {.filter = render::Filter::kPoint,
                       .supersampling = kReferenceSide,
                       .shadows = render::Shadows::kHard})
              .image;
  const auto& drawn = std::get<std::vector<float>>(image.texels);
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(drawn.data()), bytes);
  return image;
}

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Outcome {
  std::vector<double> seconds;
  double rays_a_pixel = 0;
  double rmse = 0;
  double flip = 0;
};

void run(const char* scene_file, const std::filesystem::path& folder, int rounds) {
  std::filesystem::create_directories(folder);
  const PictureScene scene = make_scene(scene::read_document(scene_file));
  const texmap::Image reference = reference_in(folder / "reference.raw", scene);
  const std::vector<Method> all = methods();
  std::vector<Outcome> outcomes(all.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t turn = 0; turn < all.size(); ++turn) {
      const std::size_t i = round % 2 == 0 ? turn : all.size() - 1 - turn;
      Outcome& outcome = outcomes[i];
      if (round > 0 && outcome.seconds.front() > kLongRun) continue;
      render::Options options = all[i].options;
      options.threads = 1;
      const double start = processor_seconds();
      const render::Picture picture = draw(scene, options);
      outcome.seconds.push_back(processor_seconds() - start);
      if (round > 0) continue;
      outcome.rays_a_pixel = static_cast<double>(picture.statistics.eye_rays) /
                             (1.0 * scene.document.width * scene.document.height);
      outcome.rmse = texmap::rmse(picture.image, reference);
      outcome.flip = texmap::mean_flip(picture.image, reference);
    }
  }

  std::string csv = "method,seconds_median,seconds_min,seconds_max,rays_a_pixel,rmse,mean_flip\n";
  std::vector<bench::PlotCurve> curves = {{"one ray a pixel", "#777777", false, {}},
                                          {"3x3", "#c08000", false, {}},
                                          {"adaptive", "#c02020", true, {}},
                                          {"plain samples", "#2050c0", true, {}}};
  const auto seconds_of = [&](std::size_t i) { return bench::spread(outcomes[i].seconds).median; };
  std::size_t plain_64 = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bench::Spread seconds = bench::spread(outcomes[i].seconds);
    char line[256];
    std::snprintf(line, sizeof line, "\"%s\",%.3f,%.3f,%.3f,%.2f,%.5f,%.4f\n", all[i].name.c_str(),
                  seconds.median, seconds.min, seconds.max, outcomes[i].rays_a_pixel, outcomes[i].rmse,
                  outcomes[i].flip);
    csv += line;
    const std::string label = all[i].name.substr(all[i].name.find(' ') + 1);
    curves[static_cast<std::size_t>(all[i].kind)].points.push_back(
        {all[i].kind == Kind::kOneRay ? all[i].name : label, seconds.median, outcomes[i].rmse});
    if (all[i].name == "plain 64") plain_64 = i;
  }
  std::ofstream(folder / "equal_error.csv") << csv;
  std::ofstream(folder / "equal_error.svg") << bench::error_plot(
      std::filesystem::path(scene_file).stem().string() + ": error against time", curves);
  std::fputs(csv.c_str(), stdout);

  // Four times the samples lowered the error by so much; once more makes the reference.
  const double next = outcomes.back().rmse;
  std::printf("the reference's own error: about %.5f\n", next * next / outcomes[plain_64].rmse);
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_good = all[i].kind != Kind::kPlain && outcomes[i].rmse <= outcomes[plain_64].rmse;
    if (is_good && (!best || seconds_of(i) < seconds_of(*best))) best = i;
  }
  if (!best) throw std::runtime_error("no method reaches the error of 64 plain samples");
  const double share = seconds_of(*best) / seconds_of(plain_64);
  std::printf("%s reaches the error of 64 plain samples in %.3f of their time\n", all[*best].name.c_str(),
              share);
  if (share > 0.1) throw std::runtime_error("that is more than a tenth");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3 || argc > 4) {
    std::fprintf(stderr, "usage: equal_error SCENE FOLDER [ROUNDS]\n");
    return 2;
  }
  try {
    run(argv[1], argv[2], argc == 4 ? std::max(1, std::atoi(argv[3])) : 5);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "equal_error: %s\n", error.what());
    return 1;
  }
}
