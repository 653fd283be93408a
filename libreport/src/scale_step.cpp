// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The kernel keeps a process's largest resident size since it was last told to forget it (proc(5),
// clear_refs). What was freed before the work is given back first, else the work would find it there.

#include "sweepkit/report/scale_step.hpp"

#include <malloc.h>

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <optional>

#include "picture_scene.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/gltf.hpp"
#include "timing.hpp"

namespace sweepkit::report {
namespace {

// Bytes, of a line of /proc/self/status such as "VmHWM:  1234 kB".
std::optional<double> memory(const std::string& key) {
  std::ifstream lines("/proc/self/status");
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(key)) return 1024 * std::strtod(line.c_str() + key.size(), nullptr);
  }
  return std::nullopt;
}

bool forget_peak() {
  malloc_trim(0);
  std::ofstream file("/proc/self/clear_refs");
  file << 5 << std::flush;
  return file.good();
}

double peak_of(const std::function<void()>& work) {
  work();  // loads what reads images, if it does; that is no part of the work
  const bool is_told = forget_peak();
  const std::optional<double> before = memory("VmRSS:");
  work();
  const std::optional<double> peak = memory("VmHWM:");
  if (!is_told || !before || !peak) return std::numeric_limits<double>::quiet_NaN();
  return std::max(0.0, *peak - *before);
}

std::string text_of(double number) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

std::string measure(const std::function<void()>& work) {
  const double bytes = peak_of(work);
  // A process that runs long enough to tell the time: a quick run's effort in any case.
  const Timing timing = time_calls(work, {.is_quick = true});
  return text_of(timing.median) + ' ' + text_of(timing.least) + ' ' + text_of(timing.most) + ' ' +
         text_of(timing.runs) + ' ' + text_of(bytes);
}

}  // namespace

std::string run_scale_step(const ScaleStep& step) {
  const scene::Document document = scene::read_document(step.scene);
  const scene::Plan mesh_plan = scene::plan(document, {.product = scene::Request::Product::kMeshFile});
  if (step.work == "generate") return measure([&] { keep(scene::build(document, mesh_plan)); });
  if (step.work == "export") {
    const scene::Model model = scene::build(document, mesh_plan);
    return measure([&] { keep(scene::make_gltf(model.scene, mesh_plan, "scale.glb", {})); });
  }
  if (step.work == "render" || step.work == "render 3x3") {
    const PictureScene scene = read_scene(step.scene, step.side);
    const render::Options options{.supersampling = step.work == "render" ? 1 : 3, .threads = step.threads};
    return measure([&] { keep(draw(scene, options)); });
  }
  throw InputError("no such step of work: " + step.work);
}

}  // namespace sweepkit::report
