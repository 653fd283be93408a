// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "scene_files.hpp"

#include <algorithm>

namespace sweepkit::report {

std::vector<SceneFile> scene_files(const Effort& effort, const std::vector<std::string>& samples) {
  if (!effort.scene.empty()) return {{effort.scene.stem().string(), effort.scene}};
  std::vector<SceneFile> files;
  for (const std::string& name : samples) {
    files.push_back({name, effort.samples / "scenes" / (name + ".json")});
  }
  return files;
}

std::vector<std::string> sample_names(const Effort& effort) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(effort.samples / "scenes", ignored)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

std::string file_name(const std::string& text) {
  std::string name = text;
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  std::replace_if(
      name.begin(), name.end(), [&](char c) { return !is_plain(c); }, '_');
  return name;
}

}  // namespace sweepkit::report
