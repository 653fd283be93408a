// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {

inline const std::string kFloor = R"({"name": "floor", "plane": {"size": [1, 1]}})";

/// A scene of one line, `objects` and what else stands beside them.
inline std::string scene_text(const std::string& beside, const std::string& objects = kFloor) {
  return R"({"sweepkit": 1, )" + beside + (beside.empty() ? "" : ", ") + R"("objects": [)" + objects + "]}";
}

inline Document parse(const std::string& text, const std::vector<Setting>& settings = {}) {
  return parse_document(text, "folder/s.json", settings);
}

/// Keeps a refused scene and what is told of it for another program to look at (tests/viewers/schema.mjs),
/// where SWEEPKIT_KEEP_FAULTS names a folder.
inline void keep_fault(const std::string& text, const std::string& message) {
  static int count = 0;
  const char* const folder = std::getenv("SWEEPKIT_KEEP_FAULTS");
  if (folder == nullptr) return;
  const std::filesystem::path stem = std::filesystem::path(folder) / std::to_string(++count);
  std::ofstream(stem.string() + ".json") << text;
  std::ofstream(stem.string() + ".txt") << message;
}

/// What the InputError says that reading the text ends in, or "" if it is read.
inline std::string fault_of(const std::string& text, const std::vector<Setting>& settings = {}) {
  try {
    parse_document(text, "s.json", settings);
  } catch (const InputError& error) {
    if (settings.empty()) keep_fault(text, error.what());
    return error.what();
  }
  return "";
}

}  // namespace sweepkit::scene
