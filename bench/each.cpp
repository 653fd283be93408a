// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A thousand small tubes (16 x 16 cells, untextured .glb) by generate --each on one thread and on all, and by
// a process for each. The whole command is timed: start, table, geometry, files. Times are for one process,
// and for the thousand rows.
//
// Usage: bench_each [FOLDER]   where the files are written; the temporary folder without it

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "harness.hpp"

namespace {

namespace bench = sweepkit::bench;
namespace fs = std::filesystem;

constexpr int kRows = 1000;
constexpr int kProcesses = 20;

void write(const fs::path& file, const std::string& text) {
  if (!(std::ofstream(file, std::ios::binary) << text))
    throw std::runtime_error(file.string() + ": cannot be written");
}

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string row_number(int row) {
  std::string number = std::to_string(row);
  return std::string(4 - number.size(), '0') + number;
}

void run(const fs::path& folder, const std::string& arguments) {
  const std::string command =
      "cd '" + folder.string() + "' && " SWEEPKIT_PROGRAM " generate scene.json --quiet " + arguments;
  if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
}

int compare_ways(const fs::path& folder) {
  write(folder / "scene.json", R"({"sweepkit": 1, "objects": [{"name": "tube",
  "tessellation": {"contour": 16, "trajectory": 16},
  "sweep": {"contour": {"circle": {"radius": 0.1}},
            "trajectory": {"bezier": [[0, 0, 0], [0, 1, 0], [1, 1, 0], [1, 2, 1]]}, "twist_deg": 0}}]})");
  std::string table = "/objects/0/name,/objects/0/sweep/twist_deg,/objects/0/translate\n";
  for (int row = 1; row <= kRows; ++row) {
    const std::string number = std::to_string(row);
    table += "tube" + number + ',' + number + ",\"[" + number + ", 0, 0]\"\n";
  }
  write(folder / "values.csv", table);

  // The bytes of a process are the reference: a row that differs is no result.
  const auto setting_of = [](int row) {
    const std::string number = std::to_string(row);
    return "--set /objects/0/name=tube" + number + " --set /objects/0/sweep/twist_deg=" + number +
           " --set '/objects/0/translate=[" + number + ", 0, 0]'";
  };
  run(folder, "-o reference.glb " + setting_of(kProcesses));
  const std::string reference = read(folder / "reference.glb");
  // A new folder for each run, and nothing removed before the end: ext4 is slow to make files while it
  // remembers, for some seconds, a thousand that were removed.
  int runs = 0;
  std::string out;
  const auto prepare = [&] {
    out = "out" + std::to_string(++runs);
    fs::create_directory(folder / out);
  };
  const auto check = [&](int files) {
    const auto made = std::distance(fs::directory_iterator(folder / out), fs::directory_iterator());
    if (made != files) return std::to_string(made) + " files";
    const fs::path file = folder / out / (row_number(kProcesses) + ".glb");
    return read(file) == reference ? std::string() : file.string() + " differs from a process's";
  };
  const auto each = [&](const std::string& name, const std::string& more) {
    return bench::Contender{name,
                            [&, more] { run(folder, "--each values.csv -o " + out + "/{row}.glb " + more); },
                            [&] { return check(kRows); }, prepare};
  };
  int next = 0;
  const bench::Contender process{"process",
                                 [&] {
                                   const int row = ++next;
                                   run(folder,
                                       "-o " + out + '/' + row_number(row) + ".glb " + setting_of(row));
                                 },
                                 [&] { return check(kProcesses); },
                                 [&] {
                                   prepare();
                                   next = 0;
                                 },
                                 kProcesses};
  const bench::Comparison comparison =
      bench::compare("each", {process, each("each_1_thread", "--threads 1"),
                              each("each_2_threads", "--threads 2"), each("each_all_threads", "")});
  std::fputs(bench::to_table(comparison).c_str(), stdout);
  for (const bench::Result& result : comparison.results) {
    const int files = result.name == process.name ? 1 : kRows;
    std::printf("  %-32s %10.0f files/s\n", result.name.c_str(), files / result.seconds.median);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::string folder =
        ((argc > 1 ? fs::path(argv[1]) : fs::temp_directory_path()) / "bench_each.XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) throw std::runtime_error(folder + ": cannot be made");
    const int status = compare_ways(folder);
    fs::remove_all(folder);
    return status;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
