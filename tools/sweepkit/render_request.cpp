// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/output_file.hpp"

namespace sweepkit::tools {
namespace {

using texmap::ImageFormat;

constexpr double kLargestExposure = 64;  // stops; floats end at 2^128

void read_names(Render& command) {
  render::Options& options = command.options;
  options.filter = static_cast<texmap::Filter>(std::ranges::find(texmap::kFilterNames, command.filter) -
                                               texmap::kFilterNames.begin());
  options.footprint = command.footprint == "neighbours"      ? render::Footprint::kNeighbours
                      : command.footprint == "differentials" ? render::Footprint::kDifferentials
                                                             : render::Footprint::kAuto;
  options.accelerator = static_cast<render::Accelerator>(
      std::ranges::find(render::kAcceleratorNames, command.accelerator) - render::kAcceleratorNames.begin());
  if (options.accelerator == render::Accelerator::kEmbree && !render::has_embree()) {
    throw InputError({.file = "--accelerator"},
                     "embree is not in this build; install Embree 3 (Debian: libembree-dev) and build again, "
                     "or leave it to auto");
  }
  options.supersampling = command.antialias == "3x3" ? 3 : 1;
  if (command.antialias == "adaptive") options.adaptive = command.adaptive;
  if (command.most_error > 0 || command.most_seconds > 0) options.goal = render::Goal{command.most_error, {}};
  options.estimates_error = options.goal || !command.statistics.empty();
  options.shadows = command.shadows == "hard" ? render::Shadows::kHard : render::Shadows::kSmooth;
  for (const std::string& name : command.layers) {
    for (std::size_t i = 0; i < render::kLayerCount; ++i) {
      const auto layer = static_cast<render::Layer>(i);
      if (render::kind_of(layer).name != name) continue;
      if (std::ranges::find(options.layers, layer) != options.layers.end())
        throw InputError({.file = "--aov"}, "has \"" + name + "\" twice; once is enough");
      options.layers.push_back(layer);
    }
  }
}

void check_exposure(double stops) {
  if (std::abs(stops) <= kLargestExposure) return;
  char got[32];
  std::snprintf(got, sizeof got, "%g", stops);
  throw InputError({.file = "--exposure"}, std::string("needs -64 to 64 stops, got ") + got);
}

void check_format(const Render& command, ImageFormat format) {
  const bool is_jpeg = format == ImageFormat::kJpeg;
  if (command.bits != 0 && !texmap::holds_bits(format, command.bits)) {
    static constexpr const char* kHeld[] = {"a PNG file has 8 or 16 bits", "a JPEG file has 8 bits",
                                            "a TIFF file has 8 or 16 bits",
                                            "an EXR file has 16 (half) or 32 (float) bits"};
    throw InputError({.file = "--bits"}, std::string(kHeld[static_cast<std::size_t>(format)]) + ", got " +
                                             std::to_string(command.bits));
  }
  if (command.options.has_alpha && is_jpeg) {
    throw InputError({.file = "--alpha"}, "a JPEG file has no alpha; write .png, .tif or .exr");
  }
  if (!command.tile.empty() && is_jpeg) {
    throw InputError({.file = "--tile"},
                     "JPEG files cannot be put together without loss; write .png, .tif or .exr");
  }
  if (!command.layers.empty() && command.output.is_standard() && format != ImageFormat::kExr) {
    throw InputError({.file = "--aov"},
                     "writes files beside the picture, which standard output has none of; add --format exr");
  }
}

void check_goal(const Render& command) {
  if (command.most_error == 0 && command.most_seconds == 0) return;
  const std::string name = command.most_error > 0 ? "--error" : "--time";
  const auto refuse = [&](const char* why) { throw InputError({.file = name}, why); };
  if (command.most_error > 0 && command.most_seconds > 0)
    refuse("cannot be reached within --time; leave out one of the two");
  if (command.antialias != "off") refuse("chooses the antialiasing itself; leave out --antialias");
  if (!command.tile.empty()) refuse("is for the whole picture, which a part cannot judge; leave out --tile");
  if (command.is_progressive) refuse("refines a picture before it is written; leave out --progressive");
  if (command.most_seconds > 0 && !command.frames.empty()) refuse("is for one picture; leave out --frames");
}

void check_ways(const Render& command) {
  check_goal(command);
  if (!command.is_progressive) return;
  if (!command.frames.empty())
    throw InputError({.file = "--progressive"}, "is for one picture; leave out --frames");
  if (command.output.is_standard()) {
    throw InputError({.file = "--progressive"},
                     "writes its file several times, which standard output cannot be; name a file with -o");
  }
}

std::vector<PictureJob> make_jobs(const Render& command) {
  if (command.frames.empty()) return {{command.output.file, std::nullopt, {}, {}}};
  const FrameList frames = parse_frames(command.frames);
  const int count = command.frames_per_turn > 0 ? command.frames_per_turn : frames.count_in_turn;
  const std::vector<std::string> files = name_frames(command.output.file, frames);
  std::vector<PictureJob> jobs;
  jobs.reserve(files.size());
  for (std::size_t i = 0; i < files.size(); ++i)
    jobs.push_back({files[i], Turn{frames.numbers[i], count}, {}, {}});
  return jobs;
}

}  // namespace

RenderRequest read_request(Render& command) {
  const Output& output = command.output;
  RenderRequest request;
  read_names(command);
  if (!command.crop.empty()) request.crop = parse_crop(command.crop);
  if (!command.tile.empty()) request.tile = parse_tile(command.tile);
  if (output.file.empty()) {
    if (!output.explains) throw InputError("-o FILE is needed (or --explain)");
    if (!command.statistics.empty()) throw InputError("--stats needs -o FILE");
    return request;
  }
  check_ways(command);
  check_exposure(command.exposure);
  request.encoding = {.format = picture_format(output), .bits = command.bits, .exposure = command.exposure};
  check_format(command, request.encoding.format);
  request.jobs = make_jobs(command);
  request.is_marked = request.tile || !command.frames.empty() || command.skips_existing;
  for (PictureJob& job : request.jobs) {
    job.names = picture_file_names(job.file, request.encoding.format, command.options.layers);
    for (const std::string& name : job.names) {
      if (name == command.statistics) {
        throw InputError({.file = "--stats"}, "needs another file than -o, got \"" + name + "\" for both");
      }
      scene::check_output(name);
    }
  }
  if (!command.statistics.empty()) scene::check_output(command.statistics);
  return request;
}

}  // namespace sweepkit::tools
