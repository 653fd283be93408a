// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sweepkit::test {

/// What a run of the program left behind.
struct Outcome {
  int status = 0;  ///< exit status, or 128 plus the signal that ended it
  std::string out;
  std::string err;
  std::chrono::duration<double> time{};  ///< on the wall
  double cpu_seconds = 0;                ///< of the processor, its own and the system's
  std::size_t peak_bytes = 0;            ///< the most memory that it held at once
};

/// An empty folder to work in, removed at the end. The program runs inside it.
class Workshop {
 public:
  Workshop();
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  /// Everything in the folder, each file with its size and a hash: equal before and after where nothing was
  /// left behind.
  std::map<std::string, std::string> contents() const;

  Outcome sweepkit(const std::vector<std::string>& arguments) const;
  /// The same by a shell, in which "sweepkit" is the program.
  Outcome shell(const std::string& command) const;
  /// Starts the program with its output thrown away and goes on.
  pid_t start(const std::vector<std::string>& arguments) const;

 private:
  Outcome run(const std::vector<std::string>& command) const;

  std::filesystem::path folder_;
};

/// 128 plus the signal, or the exit status, of a child that has ended.
int exit_status(int wait_status);

/// A scene of these objects (JSON, separated by commas), each line of them on a line of its own from line 3
/// on, and after the objects whatever else ("materials", ...).
std::string scene_of(const std::string& objects, const std::string& more = "");

/// A small solid without texture: 720 triangles.
inline constexpr const char* kBall =
    R"({"name": "ball", "tessellation": {"contour": 16, "trajectory": 24},
  "revolve": {"contour": {"bezier": [[0, -1], [1.3, -1], [1.3, 1], [0, 1]]}}})";

}  // namespace sweepkit::test
