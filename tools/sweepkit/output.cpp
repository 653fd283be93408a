// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "output.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>

namespace sweepkit::tools {

void add_quiet(CLI::App& command, Output& output) {
  command.add_flag("--quiet", output.is_quiet, "Say nothing but errors");
}

void add_explain(CLI::App& command, Output& output) {
  command.add_flag("--explain", output.explains,
                   "Print what the scene needs, what is left out, and why; without -o no more");
}

CLI::Option* add_json(CLI::App& command, Output& output, const std::string& what) {
  return command.add_flag("--json", output.is_json, what);
}

void add_picture_output(CLI::App& command, Output& output, const std::string& what) {
  command.add_option("-o", output.file, what + ", ending in .png, .jpg, .tif or .exr; - is standard output")
      ->type_name("FILE");
  command.add_option("--format", output.format, "The file's format, whatever its name ends in; png for -o -")
      ->check(CLI::IsMember({"png", "jpg", "tif", "exr"}));
}

texmap::ImageFormat picture_format(const Output& output) {
  static const std::map<std::string, texmap::ImageFormat> kFormats = {{"png", texmap::ImageFormat::kPng},
                                                                      {"jpg", texmap::ImageFormat::kJpeg},
                                                                      {"tif", texmap::ImageFormat::kTiff},
                                                                      {"exr", texmap::ImageFormat::kExr}};
  if (!output.format.empty()) return kFormats.at(output.format);
  return output.is_standard() ? texmap::ImageFormat::kPng : texmap::image_format(output.file);
}

void print(const Report& report, const Output& output) {
  const std::string text = output.is_json ? to_json(report) : to_text(report);
  std::fputs(text.c_str(), output.is_standard() ? stderr : stdout);
}

void complain(std::string message) {
  // File names may hold anything; the message stays one line.
  std::replace_if(
      message.begin(), message.end(), [](char c) { return c >= 0 && c < 0x20; }, ' ');
  std::fprintf(stderr, "sweepkit: %s\n", message.c_str());
}

void say(const std::string& line, const Output& output) {
  if (!output.is_quiet) std::fprintf(stderr, "%s\n", line.c_str());
}

std::string length_text(double metres) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.2g m", metres);
  return buffer;
}

std::string duration_text(double seconds) {
  char buffer[64];
  if (seconds < 0.1) {
    std::snprintf(buffer, sizeof buffer, "%.1f ms", 1e3 * seconds);
  } else {
    std::snprintf(buffer, sizeof buffer, "%.2f s", seconds);
  }
  return buffer;
}

}  // namespace sweepkit::tools
