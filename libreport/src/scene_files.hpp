// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sweepkit/report/experiment.hpp"

namespace sweepkit::report {

struct SceneFile {
  std::string name;  ///< of the file, without its ending: "vase_and_cup"
  std::filesystem::path file;
};

/// The samples of these names, or the one scene that is to be measured in their place.
std::vector<SceneFile> scene_files(const Effort& effort, const std::vector<std::string>& samples);

/// Of all samples, in the order of the alphabet.
std::vector<std::string> sample_names(const Effort& effort);

/// As a file may be called: what is neither a letter nor a digit becomes '_'.
std::string file_name(const std::string& text);

}  // namespace sweepkit::report
